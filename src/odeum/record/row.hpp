// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <complex>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "odeum/core/numbers.hpp"

/// A row names its file and columns once; CSV, reader, store and tables follow from that:
///
///   struct OrderRow {
///     std::string case_id;
///     judge::OrderFit fit;
///     static constexpr const char* file = "orders.csv";
///     ODEUM_COLUMNS(case_id, fit.points, column("measured_order", fit.order))
///   };
///
/// A column has the name of its member without what stands before a dot and without an _id at its
/// end, or the one that `column` gives it. A member is text, a number, a count, a complex number
/// (two columns, _re and _im), an enumeration that has a to_string, a number that may be missing
/// (std::optional, nan), one of the wrappers below, or a struct that has columns, which stand in
/// its place.
#define ODEUM_COLUMNS(...) ODEUM_EACH_COLUMN(, __VA_ARGS__) ODEUM_EACH_COLUMN(const, __VA_ARGS__)
#define ODEUM_EACH_COLUMN(qualifier, ...)                                                 \
  void each(auto&& visit) qualifier {                                                     \
    using namespace ::odeum::record;                                                      \
    static constexpr ::odeum::record::detail::ColumnNames names_of_columns{#__VA_ARGS__}; \
    ::odeum::record::detail::visit_columns(visit, names_of_columns, __VA_ARGS__);         \
  }

namespace odeum::record {

/// A value that follows from other members: written, never read back.
template <class T>
struct ComputedColumn {
  T value;
};
template <class T>
ComputedColumn(T) -> ComputedColumn<T>;

/// A bool or an enumeration of two values as one of two words.
template <class T>
struct PhraseColumn {
  T& value;
  const char *first, *second;
};
template <class T>
PhraseColumn(T&, const char*, const char*) -> PhraseColumn<T>;

/// A value in a column of another name.
template <class T>
struct NamedColumn {
  const char* name;
  T&& value;
};
template <class T>
NamedColumn<T> column(const char* name, T&& value) {
  return {name, std::forward<T>(value)};
}

/// Numbers that are in the store, without a column in the file.
template <class T>
struct StoredOnly {
  T& values;
};
template <class T>
StoredOnly(T&) -> StoredOnly<T>;

using Cell = std::variant<std::string, double, std::int64_t, std::uint64_t>;
struct Field {
  std::string column;
  Cell value;
};
using Fields = std::vector<Field>;
/// A cell as plain text.
std::string cell_text(const Cell& cell);

/// The source of a row's fields, by column or in their order.
class FieldSource {
 public:
  virtual ~FieldSource() = default;
  /// The text of the next field, or that of the column. Throws BadField past the end of a record.
  virtual std::string next(const std::string& column) = 0;
};
/// A field is not a value of its member.
class BadField : public std::exception {
 public:
  const char* what() const noexcept override { return "a field is malformed"; }
};
/// Parses a number; throws BadField.
double number_of(std::string_view text);
std::int64_t integer_of(std::string_view text);

namespace detail {

/// The names of columns from the list in a row's declaration; empty where `column` gives the name.
template <std::size_t size>
struct ColumnNames {
  char text[size] = {};
  std::size_t begins[size / 2 + 1] = {};

  consteval explicit ColumnNames(const char (&list)[size]) {
    std::size_t length = 0, item = 0;
    int depth = 0;
    bool quoted = false;
    for (const char c : list) {
      quoted = quoted != (c == '"');
      depth += quoted ? 0 : (c == '(' || c == '{') - (c == ')' || c == '}');
      if (quoted || depth > 0) continue;
      if (c == '.') length = begins[item];
      if (c == ',' || c == '\0') {
        const std::string_view name(text + begins[item], length - begins[item]);
        if (name.ends_with("_id")) length -= 3;
        text[length++] = '\0';
        begins[++item] = length;
      } else if (c != '.' && c != ' ') {
        text[length++] = c;
      }
    }
  }
  const char* operator[](std::size_t item) const { return text + begins[item]; }
};

void visit_column(auto& visit, const char* name, auto& value) {
  if constexpr (requires { value.each(visit); })
    value.each(visit);
  else
    visit(name, value);
}
template <class T>
void visit_column(auto& visit, const char*, NamedColumn<T>& named) {
  visit(named.name, named.value);
}
void visit_columns(auto& visit, const auto& names, auto&&... values) {
  std::size_t item = 0;
  (visit_column(visit, names[item++], values), ...);
}

struct Lister {
  Fields& fields;
  bool stored;  ///< as in the store, see fields_of

  void add(std::string column, Cell value) const {
    fields.push_back({std::move(column), std::move(value)});
  }
  void operator()(const char* column, const std::string& value) const { add(column, value); }
  void operator()(const char* column, const char* value) const { add(column, std::string(value)); }
  void operator()(const char* column, double value) const { add(column, value); }
  void operator()(const char* column, std::unsigned_integral auto value) const {
    add(column, static_cast<std::uint64_t>(value));
  }
  void operator()(const char* column, std::signed_integral auto value) const {
    add(column, static_cast<std::int64_t>(value));
  }
  void operator()(const char* column, const std::complex<double>& value) const {
    add(std::string(column) + "_re", value.real());
    add(std::string(column) + "_im", value.imag());
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* column, Enum value) const {
    add(column, std::string(to_string(value)));
  }
  template <class T>
  void operator()(const char* column, const std::optional<T>& value) const {
    value ? (*this)(column, *value) : add(column, nan);
  }
  template <class T>
  void operator()(const char* column, const PhraseColumn<T>& words) const {
    add(column, std::string(static_cast<bool>(words.value) ? words.second : words.first));
  }
  template <class T>
  void operator()(const char* column, const ComputedColumn<T>& value) const {
    if (!stored) (*this)(column, value.value);
  }
  template <class T>
  void operator()(const char* column, const StoredOnly<T>& kept) const {
    if (!stored) return;
    add(column, static_cast<std::uint64_t>(kept.values.size()));
    for (const auto value : kept.values) add(column, static_cast<double>(value));
  }
};

struct Reader {
  FieldSource& source;
  bool stored;

  void operator()(const char* column, std::string& value) const { value = source.next(column); }
  void operator()(const char* column, double& value) const {
    value = number_of(source.next(column));
  }
  template <std::integral Count>
  void operator()(const char* column, Count& value) const {
    const std::int64_t found = integer_of(source.next(column));
    value = static_cast<Count>(found);
    if (static_cast<std::int64_t>(value) != found) throw BadField();
    if (std::is_unsigned_v<Count> && found < 0) throw BadField();
  }
  void operator()(const char* column, std::complex<double>& value) const {
    const double re = number_of(source.next(std::string(column) + "_re"));
    value = {re, number_of(source.next(std::string(column) + "_im"))};
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* column, Enum& value) const {
    constexpr int most_enumerators = 16;
    const std::string text = source.next(column);
    for (int k = 0; k < most_enumerators; ++k)
      if (value = static_cast<Enum>(k); text == to_string(value)) return;
    throw BadField();
  }
  template <class T>
  void operator()(const char* column, std::optional<T>& value) const {
    const double found = number_of(source.next(column));
    value = std::isnan(found) ? std::nullopt : std::optional<T>(static_cast<T>(found));
  }
  template <class T>
  void operator()(const char* column, const PhraseColumn<T>& words) const {
    const std::string text = source.next(column);
    if (text != words.first && text != words.second) throw BadField();
    words.value = static_cast<T>(text == words.second);
  }
  template <class T>
  void operator()(const char*, const ComputedColumn<T>&) const {}
  template <class T>
  void operator()(const char* column, const StoredOnly<T>& kept) const {
    if (!stored) return;
    std::size_t count = 0;
    (*this)(column, count);
    kept.values.clear();
    for (; count > 0; --count)
      kept.values.push_back(static_cast<typename T::value_type>(number_of(source.next(column))));
  }
};

}  // namespace detail

/// The fields of a row in the order of its columns; `stored`: as in the store, with what has no
/// column and without what is computed.
template <class Row>
Fields fields_of(const Row& row, bool stored = false) {
  Fields fields;
  row.each(detail::Lister{fields, stored});
  return fields;
}
template <class Row>
std::vector<Fields> fields_of(const std::vector<Row>& rows) {
  std::vector<Fields> all;
  all.reserve(rows.size());
  for (const Row& row : rows) all.push_back(fields_of(row));
  return all;
}

/// The row whose fields, or `stored` ones, a source gives. Throws BadField.
template <class Row>
Row row_of(FieldSource& source, bool stored = false) {
  Row row;
  row.each(detail::Reader{source, stored});
  return row;
}

}  // namespace odeum::record

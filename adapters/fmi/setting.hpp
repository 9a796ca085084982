// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

#include "fmi/description.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {

/// A text with the variable whose value it is. Its functions throw LoadError where it is none of
/// the variable's type.
struct Setting {
  const Variable* variable;
  std::string text, place = {};  ///< `place`: before its name in errors

  double real() const {
    double value = 0;
    if (read(value) != std::errc{}) fail("a number");
    return value;
  }
  template <class Integer>
  Integer integer() const {
    Integer value{};
    const std::errc error = read(value);
    if (error == std::errc::result_out_of_range)
      fail(fmt::format("{} to {}", std::numeric_limits<Integer>::min(),
                       std::numeric_limits<Integer>::max()));
    if (error != std::errc{}) fail("a whole number");
    return value;
  }
  bool boolean() const {
    if (text != "true" && text != "1" && text != "false" && text != "0") fail("true or false");
    return text == "true" || text == "1";
  }
  [[noreturn]] void fail_type() const {
    throw LoadError(fmt::format("{}{}: a {} cannot be set", place, variable->name, variable->type));
  }
  [[noreturn]] void fail(const std::string& expected) const {
    throw LoadError(fmt::format("{}{}: got \"{}\", expected {}", place, variable->name,
                                foreign::cleaned(text.c_str()), expected));
  }

 private:
  template <class Number>
  std::errc read(Number& value) const {
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value);
    return error == std::errc{} && end != last ? std::errc::invalid_argument : error;
  }
};

/// Calls use(value) with the value of a setting in the type of its variable; false: texts of that
/// type cannot be set.
template <class Use>
bool with_value(const Setting& s, int version, const Use& use) {
  const std::string& type = s.variable->type;
  if (type == "Real" || type == "Float64") return use(s.real()), true;
  if (type == "Float32") return use(static_cast<float>(s.real())), true;
  if (type == "Boolean") return use(s.boolean()), true;
  if (type == "Integer" || (type == "Enumeration" && version == 2) || type == "Int32")
    return use(s.integer<std::int32_t>()), true;
  if (type == "Int64" || type == "Enumeration") return use(s.integer<std::int64_t>()), true;
  if (type == "Int8") return use(s.integer<std::int8_t>()), true;
  if (type == "UInt8") return use(s.integer<std::uint8_t>()), true;
  if (type == "Int16") return use(s.integer<std::int16_t>()), true;
  if (type == "UInt16") return use(s.integer<std::uint16_t>()), true;
  if (type == "UInt32") return use(s.integer<std::uint32_t>()), true;
  if (type == "UInt64") return use(s.integer<std::uint64_t>()), true;
  return false;
}

}  // namespace odeum::adapters::fmi

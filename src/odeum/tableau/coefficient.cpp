// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/coefficient.hpp"

#include <fmt/format.h>

#include <cmath>

namespace odeum {
namespace {

constexpr std::size_t longest_text = 400;
constexpr int deepest_nesting = 32;
constexpr int largest_exponent = 400;
constexpr std::size_t digits_of_a_rounded_decimal = 15;

mpf_class real(const mpq_class& exact) { return mpf_class(exact, coefficient_bits); }

Coefficient rational(const mpq_class& exact, double uncertainty = 0) {
  return {exact, real(exact), true, uncertainty};
}
Coefficient irrational(const mpf_class& value, double uncertainty) {
  return {mpq_class(0), mpf_class(value, coefficient_bits), false, uncertainty};
}

double size(const Coefficient& x) { return std::abs(x.value.get_d()); }

Coefficient add(const Coefficient& x, const Coefficient& y, int sign) {
  const double uncertainty = x.uncertainty + y.uncertainty;
  if (x.rational && y.rational) return rational(x.exact + sign * y.exact, uncertainty);
  return irrational(x.value + sign * y.value, uncertainty);
}

Coefficient multiply(const Coefficient& x, const Coefficient& y) {
  const double uncertainty = size(x) * y.uncertainty + size(y) * x.uncertainty;
  if (x.rational && y.rational) return rational(x.exact * y.exact, uncertainty);
  return irrational(x.value * y.value, uncertainty);
}

Coefficient divide(const Coefficient& x, const Coefficient& y) {
  if (y.value == 0) throw CoefficientError("a division by zero");
  const double uncertainty = (x.uncertainty + size(x) / size(y) * y.uncertainty) / size(y);
  if (x.rational && y.rational) return rational(x.exact / y.exact, uncertainty);
  return irrational(x.value / y.value, uncertainty);
}

Coefficient square_root(const Coefficient& x) {
  if (x.value < 0) throw CoefficientError("a square root of a negative number");
  if (x.value == 0) return rational(0);
  const mpf_class root = sqrt(x.value);
  const double uncertainty = x.uncertainty / (2 * root.get_d());
  if (x.rational && mpz_perfect_square_p(x.exact.get_num_mpz_t()) &&
      mpz_perfect_square_p(x.exact.get_den_mpz_t()))
    return rational(mpq_class(sqrt(x.exact.get_num()), sqrt(x.exact.get_den())), uncertainty);
  return irrational(root, uncertainty);
}

/// Recursive descent over the text.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Coefficient whole() {
    const Coefficient x = sum(0);
    skip_blanks();
    if (at_ < text_.size()) {
      if (text_[at_] == ',') throw CoefficientError("a comma (decimals are written with a point)");
      throw CoefficientError(fmt::format("'{}' after the end of the number", text_.substr(at_, 8)));
    }
    return x;
  }

 private:
  Coefficient sum(int depth) {
    if (depth > deepest_nesting) throw CoefficientError("brackets nested too deeply");
    Coefficient x = product(depth);
    for (;;) {
      if (take('+'))
        x = add(x, product(depth), 1);
      else if (take('-'))
        x = add(x, product(depth), -1);
      else
        return x;
    }
  }

  Coefficient product(int depth) {
    Coefficient x = factor(depth);
    for (;;) {
      if (take('*'))
        x = multiply(x, factor(depth));
      else if (take('/'))
        x = divide(x, factor(depth));
      else
        return x;
    }
  }

  Coefficient factor(int depth) {
    if (take('-')) return add(rational(0), unsigned_factor(depth), -1);
    take('+');
    return unsigned_factor(depth);
  }

  Coefficient unsigned_factor(int depth) {
    skip_blanks();
    const bool root = text_.substr(at_, 4) == "sqrt";
    if (root) at_ += 4;
    if (take('(')) {
      const Coefficient x = sum(depth + 1);
      if (!take(')')) throw CoefficientError("a bracket that is not closed");
      return root ? square_root(x) : x;
    }
    if (root) throw CoefficientError("sqrt without (...)");
    return decimal();
  }

  Coefficient decimal() {
    const std::string whole_part = digits();
    std::string fraction;
    const bool point = at_ < text_.size() && text_[at_] == '.';
    if (point) {
      ++at_;
      fraction = digits();
    }
    if (whole_part.empty() && fraction.empty()) {
      if (at_ - (point ? 1 : 0) >= text_.size()) throw CoefficientError("a number is missing");
      throw CoefficientError("not a number");
    }
    if (whole_part.size() > 1 && whole_part[0] == '0')
      throw CoefficientError("a leading zero (octal or decimal?)");
    const long exponent = exponent_part() - static_cast<long>(fraction.size());
    const std::string all = whole_part + fraction;
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
    const mpq_class unit = exponent < 0 ? mpq_class(1, power) : mpq_class(power);
    const std::size_t leading = std::min(all.find_first_not_of('0'), all.size());
    const bool rounded = point && all.size() - leading >= digits_of_a_rounded_decimal;
    mpq_class exact = mpq_class(mpz_class(all, 10)) * unit;
    exact.canonicalize();
    return rational(exact, rounded ? unit.get_d() / 2 : 0);
  }

  std::string digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  long exponent_part() {
    if (at_ >= text_.size() || (text_[at_] != 'e' && text_[at_] != 'E')) return 0;
    ++at_;
    long sign = 1;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+'))
      sign = text_[at_++] == '-' ? -1 : 1;
    const std::string text = digits();
    if (text.empty()) throw CoefficientError("an exponent without digits");
    if (text.size() > 4 || std::stol(text) > largest_exponent)
      throw CoefficientError(fmt::format("an exponent beyond {}", largest_exponent));
    return sign * std::stol(text);
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Coefficient parse_coefficient(std::string_view text) {
  mpf_set_default_prec(coefficient_bits);  // the precision of GMP's temporaries
  if (text.size() > longest_text)
    throw CoefficientError(fmt::format("a number of more than {} characters", longest_text));
  const Coefficient x = Parser(text).whole();
  if (size(x) > 1e9) throw CoefficientError("a coefficient beyond 1e9");
  return x;
}

}  // namespace odeum

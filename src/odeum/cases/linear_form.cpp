// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/linear_form.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/modal_solution.hpp"
#include "odeum/linear/eigenvalues.hpp"

namespace odeum::cases {
namespace {

/// M of (u, 1)' = M (u, 1); without the last row and column where b is 0.
std::vector<double> with_constant(const LinearForm& form, bool has_constant) {
  const std::size_t n = form.size, size = n + (has_constant ? 1 : 0);
  std::vector<double> m(size * size);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i * size + j] = form.a[i * n + j];
    if (has_constant) m[i * size + n] = form.b[i];
  }
  return m;
}

void set_solution(LinearForm& form, const Case& c) {
  const bool constant = std::ranges::any_of(form.b, [](double x) { return x != 0; });
  std::vector<double> z0 = c.y0;
  if (constant) z0.push_back(1);
  form.solution = modal_solution(with_constant(form, constant), z0, form.size, c.end() - c.t0,
                                 c.t0 == 0 ? "t" : "s");
}

}  // namespace

std::optional<LinearForm> linear_form(const Case& c) {
  const OdeView& view = c.problem.view;
  const std::size_t n = c.y0.size();
  if (n == 0 || n > most_unknowns_shown || !view.jacobian || !c.nature.linear) return {};
  LinearForm form{.size = n,
                  .a = std::vector<double>(n * n),
                  .b = std::vector<double>(n),
                  .b_varies = view.time_derivative != nullptr,
                  .eigenvalues = {},
                  .solution = {}};
  const std::vector<double> zero(n);
  view.jacobian(view.problem, c.t0, zero.data(), form.a.data());
  view.rhs(view.problem, c.t0, zero.data(), form.b.data());
  if (!is_finite(form.a.data(), n * n) || !is_finite(form.b.data(), n)) return {};
  std::vector<double> later(n * n);
  view.jacobian(view.problem, c.end(), zero.data(), later.data());
  if (later != form.a) return {};  // A depends on t
  form.eigenvalues = eigenvalues(form.a, n);
  if (!form.b_varies) set_solution(form, c);
  return form;
}

std::string text_of_matrix(const std::vector<double>& matrix, std::size_t columns) {
  std::string text = "[";
  for (std::size_t k = 0; k < matrix.size(); ++k)
    text += fmt::format("{}{:.9g}", k == 0 ? "" : k % columns == 0 ? "; " : " ", matrix[k] + 0.);
  return text + "]";
}

std::string text_of_eigenvalues(std::vector<std::complex<double>> values) {
  double largest = 0;
  for (const auto& z : values) largest = std::max(largest, std::abs(z));
  // What is below the rounding of the largest is printed as 0.
  const auto part = [&](double x) { return std::abs(x) <= 1e-15 * largest ? 0 : x; };
  // A double eigenvalue is computed to half of the digits.
  constexpr double half = 3e-8;
  std::vector<std::string> texts;
  while (!values.empty()) {
    const std::complex<double> first = values.front();
    std::complex<double> sum = 0;
    const auto rest = std::stable_partition(values.begin(), values.end(), [&](const auto& z) {
      return std::abs(z - first) <= half * std::abs(first);
    });
    for (auto z = values.begin(); z != rest; ++z) sum += *z;
    const auto times = rest - values.begin();
    values.erase(values.begin(), rest);
    std::complex<double> mean = sum / static_cast<double>(times);
    if (std::abs(mean.imag()) <= 1e-13 * largest) mean = mean.real();
    if (mean.imag() < 0) continue;  // with its conjugate
    std::string text =
        part(mean.real()) == 0 && mean.imag() > 0 ? "" : fmt::format("{:.9g}", part(mean.real()));
    if (mean.imag() > 0)
      text += fmt::format("{}+-{}{:.9g}i", text.empty() ? "" : " ", text.empty() ? "" : " ",
                          mean.imag());
    texts.push_back(times == 1 ? text : fmt::format("{} ({} times)", text, times));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

Facts facts_of(const LinearForm& form, const Case& c) {
  const std::vector<std::string> names = component_names(c);
  Facts facts{{"form", fmt::format("u' = A u + b, u = ({})", fmt::join(names, ", "))},
              {"A", text_of_matrix(form.a, form.size)},
              {"b", text_of_matrix(form.b, 1) +
                        (form.b_varies ? fmt::format(" at t = {:g}; it depends on t", c.t0) : "")},
              {"eigenvalues", text_of_eigenvalues(form.eigenvalues)}};
  for (std::size_t i = 0; i < form.solution.size(); ++i)
    facts.emplace_back("solution", fmt::format("{} = {}", names[i], form.solution[i]));
  if (!form.solution.empty() && c.t0 != 0)
    facts.emplace_back("solution", fmt::format("s = t - {:g}", c.t0));
  if (form.solution.empty())
    facts.emplace_back("solution",
                       form.b_varies
                           ? "b depends on t, and none is looked for; truth: " + c.truth.source
                           : "none was found: the eigenvalues lie too close together, or too far "
                             "apart, to tell its terms from rounding");
  return facts;
}

}  // namespace odeum::cases

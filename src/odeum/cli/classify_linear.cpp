// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/cases/linear_form.hpp"
#include "odeum/cli/classify.hpp"
#include "odeum/judge/step_matrix.hpp"
#include "odeum/linear/matrix_exponential.hpp"

namespace odeum::cli {
namespace {

std::string lines_of(const Facts& facts) {
  std::string text;
  for (const auto& [name, fact] : facts) text += fmt::format("{:<12} {}\n", name, fact);
  return text;
}

/// The largest difference of R from I + h A, and of R (I - h A) from I, for 2 x 2 matrices.
std::array<double, 2> off_euler(const cases::LinearForm& form, const std::vector<double>& r,
                                double h) {
  std::array<double, 2> off{};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const double unit = i == j ? 1 : 0;
      off[0] = std::max(off[0], std::abs(r[i * 2 + j] - unit - h * form.a[i * 2 + j]));
      double back = r[i * 2 + j] - unit;
      for (std::size_t k = 0; k < 2; ++k) back -= h * r[i * 2 + k] * form.a[k * 2 + j];
      off[1] = std::max(off[1], std::abs(back));
    }
  return off;
}

/// What slides on a spring K (L0 - x) say of Euler's methods, beside what holds; empty where this
/// is none, or the step another one.
std::string slide_on_springs(const cases::LinearForm& form, const std::vector<double>& r,
                             double h) {
  if (form.size != 2 || form.a[0] != 0 || form.a[1] != 1 || !(form.a[2] < 0)) return "";
  const double k = -form.a[2], d = -form.a[3];
  const double root = h * std::sqrt(k);
  const auto [off_explicit, off_implicit] = off_euler(form, r, h);
  constexpr double rounding = 1e-12;
  if (off_explicit < rounding) {
    std::string text = fmt::format(
        "a slide prints for springs without damping: no divergence if 1 + h sqrt(K/m) < 1, here "
        "{:.6g}. The eigenvalues are 1 +- i h sqrt(K/m), of modulus sqrt(1 + h^2 K/m) = {:.10g}",
        1 + root, std::sqrt(1 + root * root));
    if (d != 0)
      text += fmt::format(
          "; with damping of d the product of the eigenvalues is 1 + h^2 K/m - h d/m = {:.10g}",
          1 + root * root - h * d);
    return text;
  }
  if (off_implicit < rounding && d == 0)
    return fmt::format(
        "a slide prints for springs the eigenvalue 1 - h sqrt(K/m) < 1, here {:.6g}. The "
        "eigenvalues are 1 / (1 +- i h sqrt(K/m)), of modulus 1 / sqrt(1 + h^2 K/m) = {:.10g}",
        1 - root, 1 / std::sqrt(1 + root * root));
  return "";
}

std::string text_of_step(const Case& c, const cases::LinearForm& form, const Solver& solver,
                         double h) {
  const std::string id = solver.info.id();
  const double steps = std::round((c.end() - c.t0) / h);
  judge::StepMatrix step;
  try {
    step = judge::measure_step_matrix(c, solver, h);
  } catch (const std::runtime_error& error) {
    throw UsageError("{} on {}: {}", id, c.id, error.what());
  }
  std::vector<double> scaled = form.a;
  for (double& x : scaled) x *= h;
  const judge::Powers exact =
      judge::powers_of(linear::matrix_exponential(scaled, form.size), form.size);
  const std::string of_solution = fmt::format(
      "e^(h A) has {}, {}", judge::text_of_radius(exact.radius), judge::consequence(exact, steps));
  constexpr double rounding = 1e-9;
  if (step.rest > rounding)
    return lines_of(
        {{"one step",
          fmt::format(
              "{} at h = {:g} is not a matrix on the last state: eight steps differ from the "
              "eighth power of the first by {:.2g} of the state (it keeps earlier states, "
              "or solves its stages inexactly)",
              id, h, step.rest)},
         {"solution", of_solution}});
  Facts facts{{"one step", fmt::format("{} at h = {:g}: u becomes R u + r", id, h)},
              {"R", cases::text_of_matrix(step.matrix, form.size)},
              {"r", cases::text_of_matrix(step.vector, 1) +
                        (form.b_varies ? fmt::format(" from t = {:g}", c.t0) : "")},
              {"eigenvalues", cases::text_of_eigenvalues(step.powers.eigenvalues)},
              {"radius", fmt::format("{} at h = {:g}: spectral radius {}, {}", id, h,
                                     judge::text_of_radius(step.powers.radius),
                                     judge::consequence(step.powers, steps))},
              {"solution", of_solution}};
  if (const std::string slide = slide_on_springs(form, step.matrix, h); !slide.empty())
    facts.emplace_back("slide", slide);
  return lines_of(facts);
}

const Solver& fixed_step_solver(const Case& c, const std::string& name) {
  const std::string id = find_entrant(c.entrants, c.id, name).info.id();
  const auto& all = all_solvers();
  const auto at = std::ranges::find_if(all, [&](const Solver& s) { return s.info.id() == id; });
  if (at == all.end() || !at->info.fixed)
    throw UsageError("--solver: {} takes no fixed steps, so that its step is not one matrix", id);
  return *at;
}

}  // namespace

void classify_linear(const Case& c, const std::vector<std::string>& solvers,
                     std::optional<double> step) {
  const auto form = cases::linear_form(c);
  if (!form)
    throw UsageError(
        "{}: not linear with constant coefficients, or of more than {} unknowns; got {} unknowns, "
        "{}; expected u' = A u + b",
        c.id, cases::most_unknowns_shown, c.y0.size(), fmt::join(tags_of(c), " "));
  std::string text = lines_of({{"problem", c.title}, {"equation", c.equation}}) +
                     lines_of(cases::facts_of(*form, c));
  if (solvers.empty() != !step) throw UsageError("--solver and --step: expected both or none");
  for (const std::string& name : solvers)
    text += "\n" + text_of_step(c, *form, fixed_step_solver(c, name), *step);
  print(text);
}

}  // namespace odeum::cli

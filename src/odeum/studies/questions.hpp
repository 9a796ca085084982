// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace odeum::study {

/// A job that the first page of a report answers for, and the case that stands for it.
struct Question {
  const char* title;
  const char* case_id;
};
inline constexpr Question questions[] = {{"Oscillator", "damped_oscillator_underdamped"},
                                         {"Pendulum", "pendulum_large"},
                                         {"Cloth", "cloth11_two_way"},
                                         {"Orbit", "kepler_e09"},
                                         {"Stiff reaction", "robertson_40"},
                                         {"Chaos", "lorenz_kehlet_logg"},
                                         {"Free fall", "free_fall"},
                                         {"Dahlquist", "dahlquist_complex"}};

/// The orders of all solvers on the cloth take four minutes on two cores, as long as those on
/// twenty other cases; a quick report times the solvers on it, and leaves its orders out.
inline constexpr const char* long_orders = "cloth11_two_way";

/// The cases of a quick report: one for each question, and a larger stiff system.
inline std::vector<std::string> quick_cases() {
  std::vector<std::string> ids;
  for (const Question& question : questions) ids.emplace_back(question.case_id);
  ids.emplace_back("hires");
  return ids;
}

}  // namespace odeum::study

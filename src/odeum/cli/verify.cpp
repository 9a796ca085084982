// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/verify.hpp"

#include "odeum/cases/text_case.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

int verify_tableau(const std::string& path) {
  const TableauFile file = read_tableau_file(path);
  const proof::Verification verification = proof::verify(file);
  print(verification.text(file));
  return verification.passed() ? success : check_failed;
}

int verify_truth(const Case& c) {
  print("case    {}: {}\ntruth   {}\n", c.id, c.equation, cases::with_proof(c));
  return cases::with_proof(c).find("; refuted: ") == std::string::npos ? success : check_failed;
}

}  // namespace

void add_verify(CLI::App& app, Session& session, int& result) {
  auto what = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "verify",
      "orders and stability of a Runge-Kutta tableau, proven and measured; or the digits of a "
      "problem's truth, proved by an enclosure of the solution");
  add_option(*command, "tableau FILE|CASE", *what,
             "a YAML file, see cases/tableaus/README.md; or a problem: a case or a file")
      ->required();
  command->callback([what, &session, &result] {
    const cases::Named named(*what);
    const cases::Kind* const kind = cases::kind_of(named);
    // A tableau's file is YAML as a scene's is.
    const bool problem = knows_case(*what) || (kind && !kind->has_frames && named.exists());
    result =
        problem ? verify_truth(case_of(session, *what, ProblemOptions{})) : verify_tableau(*what);
  });
}

}  // namespace odeum::cli

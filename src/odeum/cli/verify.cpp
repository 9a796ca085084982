// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/verify.hpp"

#include "odeum/cli/session.hpp"

namespace odeum::cli {

void add_verify(CLI::App& app, int& result) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "verify", "orders and stability of a Runge-Kutta tableau, proven and measured");
  add_option(*command, "tableau FILE", *path, "a YAML file, see cases/tableaus/README.md")
      ->required();
  command->callback([path, &result] {
    try {
      const TableauFile file = read_tableau_file(*path);
      const proof::Verification verification = proof::verify(file);
      print(verification.text(file));
      result = verification.passed() ? success : check_failed;
    } catch (const InputError& error) {
      throw UsageError(error.what());
    }
  });
}

}  // namespace odeum::cli

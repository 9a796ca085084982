// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <new>
#include <sstream>

#include "odeum/cli/help.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/build_info.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/standard_streams.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "odeum/studies/study.hpp"

namespace {

using namespace odeum::cli;

// The first signal lets running work end and flush; the second ends at once.
void on_signal(int) {
  if (odeum::interrupted.exchange(true)) std::_Exit(interrupted_code);
}

constexpr const char* introduction =
    "Odeum compares time integrators: its own and those of SUNDIALS, GSL, Boost.odeint "
    "and\n"
    "Bullet, on the same cases, against an independent truth.\n"
    "\n"
    "  odeum advise kepler_e06 --error 1e-6\n"
    "  odeum why robertson_40 --solver dormand_prince54 --tol 1e-6\n"
    "  odeum run damped_oscillator_undamped --solver rk4 --step 0.01\n"
    "  odeum run hanging_cloth --out /tmp/cloth\n"
    "  odeum converge --case rc_circuit --solver 'odeum/*' --out /tmp/odeum\n"
    "  odeum list solvers\n"
    "\n"
    "odeum --help lists every command.\n";

// --plugin FILE on every command that has been added: its problems and solvers are known before
// the command runs.
void add_plugin_option(CLI::App& app) {
  const auto add = [](CLI::App& to) {
    to.add_option_function<std::vector<std::string>>(
          "--plugin",
          [](const std::vector<std::string>& files) {
            for (const std::string& file : files) odeum::add_plugin(file);
          },
          "a shared object with problems and solvers of your own, see odeum/plugin.h")
        ->type_name("FILE.so")
        ->allow_extra_args(false);
  };
  add(app);
  // What a plan does not know is the planned command's.
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    if (!command->get_allow_extras()) add(*command);
}

int run(const std::vector<std::string>& words, Session& session) {
  CLI::App app{"Odeum: a laboratory that compares time integrators", "odeum"};
  app.formatter(std::make_shared<WrappedHelp>());
  const std::string_view revision = odeum::build::revision;
  app.set_version_flag("--version",
                       fmt::format("odeum {}{}", odeum::build::version,
                                   revision.empty() ? "" : fmt::format(" ({})", revision)));
  app.require_subcommand(0, 1);
  int result = success;
  add_run(app, session, result);
  add_advise(app, session, result);
  add_why(app, session, result);
  add_judge(app, session, result);
  add_compare(app, result);
  const odeum::study::Studies studies = odeum::study::make_studies();
  for (const auto& study : studies) add_study(app, session, *study);
  add_report(app, session);
  add_sweep(app, session, result);
  add_plan(app, session, result, run);
  add_list(app, session);
  add_verify(app, session, result);
  add_classify(app, session);
  add_poisson(app);
  add_doctor(app);
  add_completion(app);
  add_help(app);
  group_commands(app);
  add_plugin_option(app);
  try {
    std::vector<std::string> from_back(words.rbegin(), words.rend());
    // As the word before the command, so the option behind it.
    if (words.size() < 3 && !words.empty() && words.front() == "help")
      from_back.back() = "--help",
      std::rotate(from_back.begin(), from_back.end() - 1, from_back.end());
    app.parse(std::move(from_back));
  } catch (const CLI::Success& help) {  // --help, --version
    std::ostringstream text;
    const bool right = app.exit(help, text, text) == 0;
    print(text.str());
    return right ? success : usage;
  } catch (const CLI::ParseError& error) {
    const bool unknown = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
    odeum::tell(fmt::format("odeum: {}{}\n", error.what(), unknown ? hint_of(app) : ""));
    const CLI::App* at = &app;
    if (!app.get_subcommands().empty()) at = app.get_subcommands().front();
    odeum::tell(fmt::format("see {} --help\n", at == &app ? "odeum" : "odeum " + at->get_name()));
    return usage;
  }
  if (app.get_subcommands().empty()) print(introduction);
  return result;
}

int ended(ExitCode code, const std::string& why) {
  odeum::tell(fmt::format("odeum: {}\n", why));
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  odeum::open_standard_streams();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of the write
  try {
    Session session;
    return run({argv + 1, argv + argc}, session);
  } catch (const odeum::LoadError& error) {
    return ended(usage, fmt::format("--plugin {}", error.what()));
  } catch (const UsageError& error) {
    return ended(usage, error.what());
  } catch (const odeum::shards::PlanError& error) {
    return ended(usage, error.what());
  } catch (const odeum::study::ResultLost& error) {
    return ended(usage, error.what());
  } catch (const odeum::InputError& error) {
    return ended(usage, error.what());
  } catch (const odeum::record::FileError& error) {
    return ended(file_failed, error.what());
  } catch (const Stopped& stopped) {
    return ended(interrupted_code, fmt::format("interrupted; {}", stopped.what()));
  } catch (const odeum::Interrupted&) {
    return ended(interrupted_code, "interrupted before all files were written");
  } catch (const std::bad_alloc&) {
    return ended(solver_failed, "out of memory");
  } catch (const std::exception& error) {
    return ended(solver_failed, error.what());
  }
}

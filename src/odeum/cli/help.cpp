// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/help.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

constexpr std::size_t explanations = 30;  // CLI11's column

std::size_t width_of_terminal() {
  constexpr std::size_t least = 40, otherwise = 100;
  winsize size{};
  std::size_t width = otherwise;
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    width = size.ws_col;
  else if (const char* const columns = std::getenv("COLUMNS"))
    width = std::strtoul(columns, nullptr, 10);
  return width == 0 ? 0 : std::max(width, least);
}

/// A line that begins with two spaces goes on below the explanations.
std::string wrapped_line(std::string line, std::size_t width) {
  const std::size_t indent = !line.starts_with("  ") ? 0 : std::min(explanations, width / 2);
  std::string text;
  while (line.size() > width) {
    std::size_t at = line.rfind(' ', width);
    if (at == std::string::npos || line.find_last_not_of(' ', at) == std::string::npos ||
        at <= indent)
      at = line.find(' ', std::max(width, indent + 1));
    if (at == std::string::npos) break;
    text += line.substr(0, line.find_last_not_of(' ', at) + 1) + '\n';
    const std::size_t next = line.find_first_not_of(' ', at);
    if (next == std::string::npos) return text;
    line = std::string(indent, ' ') + line.substr(next);
  }
  return text + line + '\n';
}

/// Two commands to paste, by the command.
struct Examples {
  std::string_view command, first, second;
};
constexpr Examples examples[]{
    {"run", "odeum run lotka_volterra --solver rk4 --step 0.1",
     "odeum run hanging_cloth --until 1 --out DIR"},
    {"advise", "odeum advise kepler_e06 --error 1e-6",
     "odeum advise my_scene.yaml --frame 1/60 --error 1e-3"},
    {"why", "odeum why robertson --solver dormand_prince54 --tol 1e-6",
     "odeum why my.yaml --solver rk4 --step 0.1 --out DIR"},
    {"judge", "odeum judge osc_under euler_h0.1.csv euler_h0.05.csv --claims explicit_euler",
     "odeum judge my.yaml sol.npy --map x=2 --map t=1*0.001"},
    {"precision", "odeum precision lotka_volterra --solver 'gsl/*' --solver rk4 --out DIR",
     "odeum precision my.yaml --seconds 1"},
    {"converge", "odeum converge osc_under --solver rk4",
     "odeum converge my.yaml --solver rodas4 --solver cvode/bdf --out DIR"},
    {"stability", "odeum stability osc_under --solver midpoint",
     "odeum stability my.yaml --solver 'odeum/*' --out DIR"},
    {"limits", "odeum limits robertson_40 --solver rk4", "odeum limits --solver rkc2 --out DIR"},
    {"drift", "odeum drift kepler_e06 --solver velocity_verlet --solver rk4",
     "odeum drift my.yaml --solver 'odeum/*' --out DIR"},
    {"sweep", "odeum sweep lotka_volterra --over a=0.5..2:40 --solver rk4 --step 0.01",
     "odeum sweep my.yaml --sample 1e5 --over 'k~loguniform(1,1e6)' --solver rodas4 --tol 1e-4"},
    {"plan", "odeum plan sweep my.yaml --over k=1..9:1000 --solver rodas4 --tol 1e-4 --shards 9",
     "odeum plan converge --shard-time 30min --out DIR"},
    {"shard", "odeum shard DIR 0", "seq 0 8 | xargs -P 2 -n 1 odeum shard DIR"},
    {"merge", "odeum merge DIR --out WHOLE", "odeum merge DIR"},
    {"status", "odeum status DIR", "odeum merge DIR --resubmit"},
    {"compare", "odeum compare before after --within 0.02",
     "odeum compare --commands 'old/odeum run ...' 'new/odeum run ...' --pairs 40"},
    {"list", "odeum list cases --parameters", "odeum list solvers my.yaml"},
    {"verify", "odeum verify my_tableau.yaml", "odeum verify my.yaml"},
    {"classify", "odeum classify 'u_xx + y*u_yy = 0'",
     "odeum classify damped_oscillator_undamped --solver explicit_euler --step 0.1"},
    {"poisson", "odeum poisson square:16 --load 1",
     "odeum poisson my.msh --load 'x*y' --refine 2 --out DIR"},
    {"doctor", "odeum doctor", "odeum doctor --plugin ./libmine.so"},
    {"completion", "odeum completion bash", "odeum completion man"},
    {"reduction", "odeum reduction --solver 'odeum/sdirk*'", "odeum reduction --out DIR"},
    {"material", "odeum material --solver 'bullet/*'", "odeum material --out DIR"},
    {"cloth", "odeum cloth --solver symplectic_euler", "odeum cloth --out DIR"},
    {"cost", "odeum cost --most 1000", "odeum cost --out DIR"},
    {"mesh", "odeum mesh --solver rk4", "odeum mesh --out DIR"},
    {"elements", "odeum elements --most 16", "odeum elements --out DIR"},
    {"evolution", "odeum evolution --most 16", "odeum evolution --out DIR"},
    {"proof", "odeum proof --solver rk4", "odeum proof --out DIR"},
    {"report", "odeum report --quick", "odeum report my.yaml --out DIR"}};

}  // namespace

std::string WrappedHelp::make_help(const CLI::App* app, std::string name,
                                   CLI::AppFormatMode mode) const {
  const std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
  const std::size_t width = width_of_terminal();
  if (width == 0) return text;
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += wrapped_line(line, width);
  return out;
}

std::string WrappedHelp::make_option(const CLI::Option* option, bool is_positional) const {
  std::string text = "  " + make_option_name(option, is_positional) + make_option_opts(option);
  const std::string explanation = make_option_desc(option);
  if (explanation.empty()) return text + '\n';
  if (text.size() + 2 > explanations) text += "\n";
  const std::size_t filled = text.ends_with('\n') ? 0 : text.size();
  return text + std::string(explanations - filled, ' ') + explanation + '\n';
}

void add_help(CLI::App& app) {
  app.add_subcommand("help", "the help of a command, as its --help")
      ->add_option("command", "the command; none: the list of all")
      ->type_name("COMMAND")
      ->expected(0, 1);
}

void group_commands(CLI::App& app) {
  const std::vector<std::pair<const char*, std::vector<std::string_view>>> groups{
      {"Questions",
       {"run", "advise", "why", "judge", "precision", "converge", "stability", "limits", "drift"}},
      {"Many runs", {"sweep", "plan", "shard", "merge", "status"}},
      {"Tools",
       {"compare", "list", "verify", "classify", "poisson", "doctor", "completion", "help"}}};
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    command->group("Laboratory");
    for (const auto& [group, names] : groups)
      if (std::ranges::find(names, command->get_name()) != names.end()) command->group(group);
    for (const Examples& each : examples)
      if (each.command == command->get_name())
        command->footer("Examples:\n  " + std::string(each.first) + "\n  " +
                        std::string(each.second));
  }
}

std::string hint_of(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::vector<std::string> options, subcommands;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (const CLI::App* each : command.get_subcommands([](const CLI::App*) { return true; }))
    subcommands.push_back(each->get_name());
  for (std::string word : app.remaining(true)) {
    word = word.substr(0, word.find('='));
    std::string hint = did_you_mean(word, word.starts_with("--") ? options : subcommands);
    if (!hint.empty()) return hint;
  }
  return "";
}

}  // namespace odeum::cli

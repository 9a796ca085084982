// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <span>
#include <sstream>

#include "odeum/core/parallel.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/report/html.hpp"

extern char** environ;

namespace odeum::report {
namespace {

namespace fs = std::filesystem;

/// A folder for scripts and pictures, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "odeum_plots_XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw record::FileError(fmt::format("cannot make folder {}: {}", name, std::strerror(errno)));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in ? text.str() : std::string();
}

void write_file(const fs::path& path, const char* bytes, std::size_t size) {
  std::ofstream out(path, std::ios::binary);
  out.write(bytes, static_cast<std::streamsize>(size));
  out.close();
  if (!out) throw record::FileError(fmt::format("cannot write {}", path.string()));
}

// The script that draws the pictures of these numbers; it prints a line for each when it is done.
std::string script_of(const std::vector<Picture>& pictures, std::span<const std::size_t> numbers,
                      const std::string& progress, const TemporaryFolder& folder) {
  std::string script = fmt::format(
      "set print '{}'\nprint sprintf('%.1f.%s', GPVAL_VERSION, GPVAL_PATCHLEVEL)\n", progress);
  for (const std::size_t i : numbers) {
    const Picture& picture = pictures[i];
    script += fmt::format("reset\nset terminal {} size {},{}\nset output 'picture{}'\n",
                          picture.kind == Picture::Kind::svg ? "svg enhanced font 'sans,11'"
                                                             : "pngcairo transparent font 'sans,9'",
                          picture.width, picture.height, i);
    if (!picture.matrix.empty()) {
      const std::string name = fmt::format("matrix{}", i);
      write_file(folder / name, reinterpret_cast<const char*>(picture.matrix.data()),
                 picture.matrix.size() * sizeof(float));
      script += fmt::format("matrix = '{}'\n", name);
    }
    script += picture.commands + "\nunset output\nprint 'done'\n";
  }
  return script;
}

// Starts gnuplot on a script of the folder; its process id, or -1 with errno set.
pid_t start_gnuplot(const TemporaryFolder& folder, const std::string& script,
                    const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  // -d: no settings of the user's own.
  std::string name = "gnuplot", defaults = "-d", file = script;
  char* const arguments[] = {name.data(), defaults.data(), file.data(), nullptr};
  pid_t process = -1;
  const int error = ::posix_spawnp(&process, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  errno = error;
  return error == 0 ? process : -1;
}

bool ended_well(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string first_line(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t^") != std::string::npos) return plain(line);
  return "no message";
}

// What one run of gnuplot came to: how many pictures it finished, and why it ended before the last.
struct Run {
  std::size_t finished = 0;
  std::string version, problem;
};

Run run_gnuplot(const std::vector<Picture>& pictures, std::span<const std::size_t> numbers,
                std::size_t worker, const TemporaryFolder& folder) {
  const std::string name = fmt::format("script{}", worker), log = fmt::format("log{}", worker);
  const std::string progress = fmt::format("progress{}", worker);
  const std::string script = script_of(pictures, numbers, progress, folder);
  write_file(folder / name, script.data(), script.size());
  const pid_t process = start_gnuplot(folder, name, log);
  Run run;
  if (process < 0) {
    run.problem = fmt::format("gnuplot could not be run ({})", std::strerror(errno));
    return run;
  }
  if (!ended_well(process)) run.problem = "gnuplot failed: " + first_line(read_file(folder / log));
  std::istringstream lines(read_file(folder / progress));
  std::getline(lines, run.version);
  for (std::string line; std::getline(lines, line);) ++run.finished;
  return run;
}

}  // namespace

Rendering render(const std::vector<Picture>& pictures, unsigned processes) {
  Rendering rendering;
  rendering.images.resize(pictures.size());
  const TemporaryFolder folder;
  const auto workers =
      std::clamp<std::size_t>(processes, 1, std::max<std::size_t>(1, pictures.size()));
  std::mutex mutex;
  parallel_for(workers, static_cast<unsigned>(workers), [&](std::size_t worker) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = worker; i < pictures.size(); i += workers) numbers.push_back(i);
    // A picture that gnuplot fails on ends its script: go on behind it.
    for (std::span<const std::size_t> left = numbers; !left.empty();) {
      const Run run = run_gnuplot(pictures, left, worker, folder);
      for (const std::size_t i : left.first(run.finished))
        rendering.images[i] = read_file(folder / fmt::format("picture{}", i));
      const std::lock_guard lock(mutex);
      if (!run.version.empty()) rendering.version = run.version;
      if (!run.problem.empty()) rendering.problem = run.problem;
      if (run.version.empty()) break;  // it does not even start
      left = left.subspan(std::min(left.size(), run.finished + 1));
    }
  });
  return rendering;
}

}  // namespace odeum::report

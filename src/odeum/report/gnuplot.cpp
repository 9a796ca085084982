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
#include <sstream>

#include "odeum/report/html.hpp"
#include "odeum/report/output_folder.hpp"

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
      throw FileError(fmt::format("cannot make folder {}: {}", name, std::strerror(errno)));
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
  if (!out) throw FileError(fmt::format("cannot write {}", path.string()));
}

std::string image_name(std::size_t i) { return fmt::format("picture{}", i); }

std::string script_of(const std::vector<Picture>& pictures, std::size_t first, std::size_t stride,
                      const TemporaryFolder& folder) {
  std::string script =
      "set print 'version'\nprint sprintf('%.1f.%s', GPVAL_VERSION, GPVAL_PATCHLEVEL)\n"
      "set print\n";
  for (std::size_t i = first; i < pictures.size(); i += stride) {
    const Picture& picture = pictures[i];
    const bool svg = picture.kind == Picture::Kind::svg;
    script += fmt::format(
        "reset\nset terminal {} size {},{} {}\nset output '{}'\n", svg ? "svg" : "pngcairo",
        picture.width, picture.height,
        svg ? "enhanced font 'sans,11'" : "transparent font 'sans,12'", image_name(i));
    if (!picture.matrix.empty()) {
      const std::string name = fmt::format("matrix{}", i);
      write_file(folder / name, reinterpret_cast<const char*>(picture.matrix.data()),
                 picture.matrix.size() * sizeof(float));
      script += fmt::format("matrix = '{}'\n", name);
    }
    script += picture.commands + "\nunset output\n";
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
  posix_spawn_file_actions_addopen(&actions, 2, log.c_str(), O_WRONLY | O_CREAT, 0600);
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

}  // namespace

Rendering render(const std::vector<Picture>& pictures, unsigned processes) {
  Rendering rendering;
  rendering.images.resize(pictures.size());
  const TemporaryFolder folder;
  const std::size_t stride = std::clamp<std::size_t>(processes, 1, std::max<std::size_t>(1, pictures.size()));
  std::vector<std::pair<pid_t, std::string>> running;
  for (std::size_t k = 0; k < stride; ++k) {
    const std::string script = script_of(pictures, k, stride, folder);
    const std::string name = fmt::format("script{}", k), log = fmt::format("log{}", k);
    write_file(folder / name, script.data(), script.size());
    const pid_t process = start_gnuplot(folder, name, log);
    if (process < 0) {
      rendering.problem = fmt::format("gnuplot could not be run: {}", std::strerror(errno));
      break;
    }
    running.emplace_back(process, log);
  }
  for (const auto& [process, log] : running)
    if (!ended_well(process) && rendering.problem.empty())
      rendering.problem = "gnuplot failed: " + first_line(read_file(folder / log));
  for (std::size_t i = 0; i < pictures.size(); ++i)
    rendering.images[i] = read_file(folder / image_name(i));
  rendering.version = read_file(folder / "version");
  if (rendering.version.ends_with('\n')) rendering.version.pop_back();
  return rendering;
}

}  // namespace odeum::report

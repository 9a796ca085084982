// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/compile.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "odeum/core/machine.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::formula {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t large_text = 2'000'000;  // optimised less: the compiler's time grows faster
constexpr std::chrono::seconds longest_compilation{120};

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// The path of a program: itself where it has a slash, else the first in $PATH.
std::string find_program(const std::string& name) {
  if (name.empty()) return "";
  if (name.find('/') != std::string::npos) return ::access(name.c_str(), X_OK) == 0 ? name : "";
  std::istringstream folders(environment("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string path = fs::path(folder) / name;
    if (!folder.empty() && ::access(path.c_str(), X_OK) == 0) return path;
  }
  return "";
}

std::string find_compiler() {
  if (const std::string given = environment("CC"); !given.empty()) return find_program(given);
  for (const char* name : {"cc", "gcc", "clang"})
    if (std::string path = find_program(name); !path.empty()) return path;
  return "";
}

std::vector<std::string> flags_for(const std::string& text) {
  // As Odeum itself is compiled, see CMakeLists.txt; the last three change no value.
  return {text.size() > large_text ? "-O1" : "-O2",
          "-march=native",
          "-std=gnu11",
          "-shared",
          "-fPIC",
          "-w",
          "-fno-tree-slp-vectorize",
          "-ffp-contract=fast",
          "-fno-math-errno",
          "-fno-trapping-math"};
}

bool write_file(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  return out.good();
}

/// Runs a program with arguments; its output goes to `log`. False where it fails or does not end.
bool run(const std::vector<std::string>& command, const fs::path& log) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string log_name = log.string();
  const pid_t child = ::fork();
  if (child < 0) return false;
  if (child == 0) {
    const int file = ::open(log_name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (file < 0 || nothing < 0 || ::dup2(nothing, 0) < 0 || ::dup2(file, 1) < 0 ||
        ::dup2(file, 2) < 0)
      ::_exit(127);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  const auto end = std::chrono::steady_clock::now() + longest_compilation;
  int status = 0;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (ended < 0 && errno != EINTR) return false;
    if (std::chrono::steady_clock::now() > end) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

std::shared_ptr<const Library> load(const fs::path& path) {
  void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  return handle ? std::make_shared<const Library>(handle) : nullptr;
}

/// A folder of its own that is removed with all that is in it.
class WorkFolder {
 public:
  explicit WorkFolder(const fs::path& in) {
    std::string name = (in / "work-XXXXXX").string();
    if (::mkdtemp(name.data())) path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Compiled build(const std::string& compiler, const std::string& text, const fs::path& cache,
               const std::string& key) {
  const WorkFolder work(cache.empty() ? fs::temp_directory_path() : cache);
  const fs::path source = work.path() / "problem.c", object = work.path() / "problem.so",
                 log = work.path() / "log";
  if (work.path().empty() || !write_file(source, text))
    return {nullptr,
            "no folder to compile in: neither the cache nor the temporary folder can be "
            "written"};
  std::vector<std::string> command{compiler};
  for (std::string& flag : flags_for(text)) command.push_back(std::move(flag));
  for (const char* word : {"-o", object.c_str(), source.c_str(), "-lm"}) command.emplace_back(word);
  if (!run(command, log)) {
    std::ifstream file(log);
    std::string said;
    std::getline(file, said);
    return {nullptr, fmt::format("{} failed{}{:.200}", compiler, said.empty() ? "" : ": ", said)};
  }
  auto library = load(object);
  if (!library) return {nullptr, "what " + compiler + " made cannot be loaded"};
  if (!cache.empty()) {
    // The text first: an object without its text is not used.
    std::error_code failed;
    fs::rename(source, cache / (key + ".c"), failed);
    if (!failed) fs::rename(object, cache / (key + ".so"), failed);
  }
  return {std::move(library), "compiled by " + compiler};
}

}  // namespace

Library::~Library() { ::dlclose(handle_); }
void* Library::symbol(const char* name) const { return ::dlsym(handle_, name); }

std::string content_key(const std::string& text) {
  std::uint64_t a = 0xcbf29ce484222325U, b = 0x84222325cbf29ce4U;  // FNV-1a, twice
  for (const char c : text) {
    a = (a ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    b = (b ^ static_cast<unsigned char>(c) ^ (a >> 40)) * 0x100000001b3U;
  }
  return fmt::format("{:016x}{:016x}", a, b);
}

std::string cache_folder() {
  fs::path base = environment("XDG_CACHE_HOME");
  if (base.empty() && !environment("HOME").empty()) base = environment("HOME") + "/.cache";
  if (!base.is_absolute()) return "";
  const fs::path folder = base / "odeum";
  std::error_code failed;
  fs::create_directories(folder, failed);
  struct stat status {};
  // Code is loaded from here: no other user may have put it there.
  if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
      status.st_uid != ::geteuid())
    return "";
  if ((status.st_mode & 077U) != 0 && ::chmod(folder.c_str(), 0700) != 0) return "";
  return folder.string();
}

Compiled compile_c(const std::string& text) {
  const std::string compiler = find_compiler();
  if (compiler.empty()) {
    const std::string given = environment("CC");
    return {nullptr, given.empty() ? "no compiler was found: none of cc, gcc, clang is in $PATH"
                                   : "the compiler of $CC, " + given + ", cannot be run"};
  }
  const fs::path cache = cache_folder();
  std::error_code ignored;
  std::string identity = compiler + ' ' + cpu_model() + ' ' +
                         std::to_string(fs::file_size(fs::canonical(compiler, ignored), ignored));
  for (const std::string& flag : flags_for(text)) identity += ' ' + flag;
  const std::string key = content_key(identity + '\n' + text);
  if (!cache.empty() && text_of_file(cache / (key + ".c")) == text)
    if (auto library = load(cache / (key + ".so")))
      return {std::move(library), "compiled by " + compiler + ", from the cache"};
  return build(compiler, text, cache, key);
}

}  // namespace odeum::formula

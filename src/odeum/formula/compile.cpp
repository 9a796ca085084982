// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/compile.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "odeum/core/machine.hpp"
#include "odeum/formula/limited_program.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::formula {
namespace {

namespace fs = std::filesystem;

// Optimised less, and not at all: the compiler's time grows faster than the text. At -O1 a product
// of 3,000 factors with its derivatives, 4.8 MB, takes it 60 s, at -O0 three.
constexpr std::size_t large_text = 2'000'000, huge_text = 4'000'000;

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

/// Tables are read at every level alike, and left out here.
std::size_t size_of_code(const std::string& text) {
  std::size_t size = text.size();
  for (std::size_t at = text.find("static const "); at != std::string::npos;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    size -= end - at;
    at = text.find("static const ", end);
  }
  return size;
}

/// The levels of optimisation that are tried, each where the one before takes too long.
std::vector<std::string> levels_for(const std::string& text) {
  const std::size_t size = size_of_code(text);
  if (size > huge_text) return {"-O0"};
  if (size > large_text) return {"-O1", "-O0"};
  return {"-O2", "-O1", "-O0"};
}

const std::vector<std::string>& flags() {
  // As Odeum itself is compiled, see CMakeLists.txt; the last three change no value.
  static const std::vector<std::string> all{"-march=native",
                                            "-std=gnu11",
                                            "-shared",
                                            "-fPIC",
                                            "-w",
                                            "-fno-tree-slp-vectorize",
                                            "-ffp-contract=fast",
                                            "-fno-math-errno",
                                            "-fno-trapping-math"};
  return all;
}

std::shared_ptr<const Library> load(const fs::path& path) {
  void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  return handle ? std::make_shared<const Library>(handle) : nullptr;
}

/// A folder of its own that is removed with all that is in it.
class WorkFolder {
 public:
  explicit WorkFolder(const fs::path& in) {
    std::string name = unfinished_in(in);
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

/// What is kept beside an object: its text and a hash of its bytes.
std::string described(const std::string& text, const std::string& object) {
  return text + "\n/* " + content_key(object) + " */\n";
}

Compiled build(const std::string& compiler, const std::string& text, const fs::path& cache,
               const std::string& key) {
  const WorkFolder work(cache.empty() ? fs::temp_directory_path() : cache);
  const fs::path source = work.path() / "problem.c", object = work.path() / "problem.so",
                 log = work.path() / "log";
  if (work.path().empty() || !write_text(source, text))
    return {nullptr,
            "no folder to compile in: neither the cache nor the temporary folder can be "
            "written"};
  const std::vector<std::string> levels = levels_for(text);
  std::string how, at_level;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    std::vector<std::string> command{compiler, levels[k]};
    command.insert(command.end(), flags().begin(), flags().end());
    for (const char* word : {"-o", object.c_str(), source.c_str(), "-lm"})
      command.emplace_back(word);
    // The levels share the time: a lower one takes less.
    const double seconds = compiler_seconds() / static_cast<double>(std::min(k + 2, levels.size()));
    how = run_limited(command, log, seconds);
    if (how.empty() || how == "failed") break;
    at_level = fmt::format(" at {}, since {} {}", k + 1 < levels.size() ? levels[k + 1] : levels[k],
                           levels[k], how);
  }
  if (!how.empty()) {
    std::ifstream file(log);
    std::string said;
    std::getline(file, said);
    return {nullptr, fmt::format("{} {}{}{:.200}", compiler, how, said.empty() ? "" : ": ", said)};
  }
  auto library = load(object);
  if (!library) return {nullptr, "what " + compiler + " made cannot be loaded"};
  if (!cache.empty()) {
    // The text first: an object without its text is not used.
    std::error_code failed;
    if (const auto bytes = text_of_file(object)) keep_text(key + ".c", described(text, *bytes));
    fs::rename(object, cache / (key + ".so"), failed);
  }
  return {std::move(library), "compiled by " + compiler + at_level};
}

}  // namespace

Library::~Library() { ::dlclose(handle_); }
void* Library::symbol(const char* name) const { return ::dlsym(handle_, name); }

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
  for (const std::string& flag : flags()) identity += ' ' + flag;
  identity += ' ' + levels_for(text).front();
  const std::string key = content_key(identity + '\n' + text);
  const fs::path object = cache / (key + ".so");
  const auto bytes = cache.empty() ? std::nullopt : text_of_file(object);
  if (bytes && kept_text(key + ".c") == described(text, *bytes))
    if (auto library = load(object))
      return {std::move(library), "compiled by " + compiler + ", from the cache"};
  return build(compiler, text, cache, key);
}

}  // namespace odeum::formula

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

namespace odeum::formula {

/// A shared object that was loaded.
class Library {
 public:
  explicit Library(void* handle) : handle_(handle) {}
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  /// Null where there is none of that name.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  void* handle_;
};

/// What compile_c() did.
struct Compiled {
  std::shared_ptr<const Library> library;  ///< null where it failed
  std::string how;                         ///< compiler and cache, or why it failed, in a sentence
};

/// Compiles a C text with the system's compiler ($CC, else cc, gcc or clang in $PATH), which is
/// started without a shell, and loads it. Kept in the cache folder under a hash of text, compiler,
/// flags and processor, beside the text, which is compared.
Compiled compile_c(const std::string& text);

/// The folder in which the program keeps what it computed: $XDG_CACHE_HOME/odeum, else
/// $HOME/.cache/odeum, made for its owner alone. Empty where there is none that can be used.
std::string cache_folder();
/// 32 hexadecimal digits that identify a text.
std::string content_key(const std::string& text);

}  // namespace odeum::formula

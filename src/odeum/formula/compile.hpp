// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/formula/cache.hpp"

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
/// started without a shell and within limits (limited_program.hpp), and loads it. Kept in the cache
/// folder under a hash of text, compiler, flags and processor, beside the text, which is compared,
/// and a hash of the object: one that is not as it was made is made again.
Compiled compile_c(const std::string& text);

}  // namespace odeum::formula

// SPDX-License-Identifier: BSD-3-Clause
#include "odepack/library.hpp"

#include <dlfcn.h>

namespace odeum::adapters::odepack {
namespace {

/// The pointer stays empty, and the reason is kept, where the library has no such symbol.
template <class Function>
void find(void* handle, const char* name, Function& function, std::string& failure) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  if (!function) failure = std::string("deSolve.so does not have the symbol ") + name;
}

void load(Library& all) {
  // Beside an installed program, where its search path finds it, or where it was built. The loader
  // takes it for the libR.so that deSolve.so needs, whether or not R is installed.
  void* without_r = dlopen("libodeum_without_r.so", RTLD_NOW | RTLD_LOCAL);
  if (!without_r) without_r = dlopen(ODEUM_WITHOUT_R, RTLD_NOW | RTLD_LOCAL);
  void* const handle = without_r ? dlopen(ODEUM_DESOLVE, RTLD_LAZY | RTLD_LOCAL) : nullptr;
  if (!handle) {
    const char* why = dlerror();
    all.failure = why ? why : "deSolve.so could not be loaded";
    return;
  }
  find(handle, "dlsoda_", all.lsoda, all.failure);
  find(handle, "dlsode_", all.lsode, all.failure);
  find(handle, "dvode_", all.vode, all.failure);
  find(handle, "dintdy_", all.of_odepack, all.failure);
  find(handle, "dvindy_", all.of_vode, all.failure);
  find(handle, "radau5_", all.radau5, all.failure);
  find(handle, "contr5_", all.continuous, all.failure);
}

}  // namespace

Library& library() {
  static Library* const all = [] {
    auto* const made = new Library;  // never destroyed: runs may end after main
    load(*made);
    return made;
  }();
  return *all;
}

}  // namespace odeum::adapters::odepack

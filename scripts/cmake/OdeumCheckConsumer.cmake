# SPDX-License-Identifier: BSD-3-Clause
# Whether the compiler and flags of a project that found Odeum work with it, by trying: at configure
# time, once for each set of flags.

# Compiles, and with LINK links, a program with the targets; the outcome is left in `variable`.
function(odeum_try variable targets program)
  string(MD5 flags "${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS} ${CMAKE_EXE_LINKER_FLAGS} ${CMAKE_BUILD_TYPE} ${program}")
  set(cached ODEUM_TRIED_${variable}_${flags})
  if(NOT DEFINED ${cached})
    set(folder ${CMAKE_BINARY_DIR}/CMakeFiles/odeum_${variable})
    file(WRITE ${folder}/try.cpp "${program}")
    try_compile(works ${folder}/build ${folder}/try.cpp LINK_LIBRARIES ${targets}
                CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON OUTPUT_VARIABLE output)
    file(WRITE ${folder}/output.txt "${output}")
    set(${cached} ${works} CACHE INTERNAL "")
  endif()
  set(${variable} ${${cached}} PARENT_SCOPE)
endfunction()

macro(odeum_check_integrators)
  set(Odeum_integrators_FOUND FALSE)
  if(NOT CMAKE_CXX_COMPILER_LOADED)
    set(odeum_why "Odeum needs the language CXX: project(... LANGUAGES CXX)")
  else()
    odeum_try(integrators Odeum::integrators "
#include <odeum/api/integrate.hpp>
#include <odeum/methods/rk4.hpp>
struct Decay {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = -y[0]; }
};
int main() {
  std::array<double, 1> y{1};
  return odeum::integrate(Decay{}, odeum::methods::rk4{}, y, 0, 1, odeum::Step{1}).ok() ? 0 : 1;
}
")
    set(Odeum_integrators_FOUND ${integrators})
    if(NOT Odeum_integrators_FOUND)
      set(odeum_why "Odeum's headers need C++20 with concepts (g++ 12 or later, clang 14 or later): a \
program of ten lines does not compile with ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} and \
the flags \"${CMAKE_CXX_FLAGS}\"; see ${CMAKE_BINARY_DIR}/CMakeFiles/odeum_integrators/output.txt")
    endif()
  endif()
  set(Odeum_integrators_eigen_FOUND ${Odeum_integrators_FOUND})
endmacro()

# Standard libraries and their modes have names of their own in what is linked (std::__1, __cxx11,
# __debug); of the sanitizers, those for threads and memory want all code instrumented.
macro(odeum_check_laboratory)
  set(odeum_sanitized 0)
  if(Odeum_SANITIZE)
    set(odeum_sanitized 1)
  endif()
  odeum_try(laboratory Odeum::laboratory "
#include <odeum/input/near_words.hpp>
#if defined(__has_feature)
#if __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define ODEUM_WANTS_ALL
#endif
#endif
#if (defined(ODEUM_WANTS_ALL) || defined(__SANITIZE_THREAD__)) && !${odeum_sanitized}
#error \"the whole program has to be instrumented\"
#endif
int main(int argc, char** argv) {
  return odeum::nearest(\"x\", std::vector<std::string>(argv, argv + argc)).empty() ? 0 : 1;
}
")
  set(Odeum_laboratory_FOUND ${laboratory})
  if(NOT Odeum_laboratory_FOUND)
    set(odeum_why "Odeum::laboratory is a static library of ${Odeum_COMPILER} with libstdc++")
    if(Odeum_SANITIZE)
      string(APPEND odeum_why " and -fsanitize=${Odeum_SANITIZE}")
    endif()
    string(APPEND odeum_why ", which does not link with ${CMAKE_CXX_COMPILER_ID} \
${CMAKE_CXX_COMPILER_VERSION} and the flags \"${CMAKE_CXX_FLAGS}\": another standard library or mode \
of it, or another sanitizer. Use Odeum::integrators, which is headers only, or build Odeum with the \
same; see ${CMAKE_BINARY_DIR}/CMakeFiles/odeum_laboratory/output.txt")
  endif()
endmacro()

# SPDX-License-Identifier: BSD-3-Clause
# How everything is compiled.

# What every translation unit of ours is compiled with; peers' templates get the same flags.
add_library(odeum_options INTERFACE)
# Among files that are compiled together, a local name hides a name of another file; -Wshadow is for each file alone
# (the presets dev, tidy and odr).
target_compile_options(odeum_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
                       $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # It warns of its own std::string and std::regex (GCC bugs 105329, 105651, 105616), of registers that its AVX-512
  # headers leave undefined on purpose (105593), and of unnamed namespaces in files that another one includes.
  target_compile_options(odeum_options INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds
                         -Wno-maybe-uninitialized -Wno-uninitialized -Wno-subobject-linkage)
  # With AVX-512 it turns the constant vector {x, x, 0, 0} into {x, x, x, x}: an initial state {1, 1, 0, 0} starts at
  # {1, 1, 1, 1}. Without this pass it makes no such vector.
  add_compile_options(-fno-tree-slp-vectorize)
endif()
if(ODEUM_WERROR)
  target_compile_options(odeum_options INTERFACE -Werror)
endif()
if(ODEUM_SANITIZE)
  add_compile_options(-fsanitize=${ODEUM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ODEUM_SANITIZE})
endif()
# Debian's hardening. What the linker does costs no time of a run. What the compiler adds took 0 to 3 % of the time of
# three own methods: it is off where times are measured, in builds that are tuned for this processor.
add_link_options(-Wl,-z,relro,-z,now)
if(NOT ODEUM_NATIVE AND NOT ODEUM_SANITIZE AND CMAKE_BUILD_TYPE STREQUAL "Release")
  include(CheckCXXCompilerFlag)
  add_compile_options(-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
  foreach(flag IN ITEMS -fstack-protector-strong -fstack-clash-protection -fcf-protection -mbranch-protection=standard)
    string(MAKE_C_IDENTIFIER ODEUM_HAS${flag} known)
    check_cxx_compiler_flag(${flag} ${known})
    if(${known})
      add_compile_options(${flag})
    endif()
  endforeach()
endif()
if(ODEUM_NATIVE)
  # Some compilers for ARM know the second only.
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-march=${ODEUM_MARCH} ODEUM_HAS_MARCH_NATIVE)
  check_cxx_compiler_flag(-mcpu=native ODEUM_HAS_MCPU_NATIVE)
  if(ODEUM_HAS_MARCH_NATIVE)
    add_compile_options(-march=${ODEUM_MARCH})
  elseif(ODEUM_HAS_MCPU_NATIVE)
    add_compile_options(-mcpu=native)
  endif()
endif()
string(REPLACE "-O2" "-O3" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")

# The rule of digits: the compiler joins no product and sum to one operation, since which ones it joins depends on what
# it inlines, and that on the other files of a unit. It may in odeum_timed: peers' templates, right-hand sides that are
# inlined, and vector code, one file a unit.
add_compile_options(-ffp-contract=off)
add_library(odeum_timed INTERFACE)
target_compile_options(odeum_timed INTERFACE -ffp-contract=fast)
target_compile_definitions(odeum_timed INTERFACE ODEUM_ROUNDING=joined)

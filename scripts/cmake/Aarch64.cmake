# SPDX-License-Identifier: BSD-3-Clause
# Cross-compiles for 64-bit ARM with Debian's g++-aarch64-linux-gnu, and runs programs under
# qemu-user-static. ODEUM_ARM_ROOT is a folder with the arm64 packages unpacked (dpkg -x):
#   cmake --preset portable -B build/aarch64 -DODEUM_ARM_ROOT=FOLDER \
#         -DCMAKE_TOOLCHAIN_FILE=$PWD/scripts/cmake/Aarch64.cmake
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ODEUM_ARM_ROOT)
set(CMAKE_FIND_ROOT_PATH ${ODEUM_ARM_ROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
# Debian keeps headers that differ by architecture (gmp.h) apart.
if(NOT EXISTS ${ODEUM_ARM_ROOT}/usr/include/gmp.h)
  set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${ODEUM_ARM_ROOT}/usr/include/aarch64-linux-gnu)
endif()
find_program(ODEUM_QEMU NAMES qemu-aarch64-static qemu-aarch64)
if(ODEUM_QEMU)
  set(CMAKE_CROSSCOMPILING_EMULATOR
      "${ODEUM_QEMU};-L;/usr/aarch64-linux-gnu;-E;LD_LIBRARY_PATH=${ODEUM_ARM_ROOT}/usr/lib/aarch64-linux-gnu")
endif()

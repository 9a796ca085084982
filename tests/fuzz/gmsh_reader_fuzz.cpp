// SPDX-License-Identifier: BSD-3-Clause
// The reader of Gmsh files under libFuzzer: any bytes give a mesh or an error with its place.
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I src -I tests \
//     tests/fuzz/gmsh_reader_fuzz.cpp src/odeum/fem/{gmsh_reader,triangle_mesh}.cpp \
//     src/odeum/input/*.cpp -lyaml-cpp -lfmt -o gmsh_reader_fuzz
//   ./gmsh_reader_fuzz -max_total_time=60
// The normal suite has a short deterministic run, tests/fem/gmsh_test.cpp.
#include "fuzz/read_any_mesh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (!odeum::fuzz::read_any_mesh({reinterpret_cast<const char*>(data), size})) __builtin_trap();
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// The scene reader under libFuzzer: any bytes give a scene or an error with its place.
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I src \
//     tests/fuzz/scene_reader_fuzz.cpp src/odeum/scene/reader*.cpp src/odeum/input/*.cpp \
//     -lyaml-cpp -lfmt -o scene_reader_fuzz
//   ./scene_reader_fuzz -max_total_time=60 cases/scenes
// The normal suite has a short deterministic run, tests/scene/scene_fuzz_test.cpp.
#include "fuzz/read_any.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (!odeum::fuzz::read_any({reinterpret_cast<const char*>(data), size})) __builtin_trap();
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// The reader of problem files under libFuzzer: any bytes give a problem or an error with its place.
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I src -I tests \
//     tests/fuzz/problem_reader_fuzz.cpp src/odeum/formula/{analysis,check,cursor,derivative}.cpp \
//     src/odeum/formula/{evaluator,graph,names,parser,series}.cpp src/odeum/formula/reader*.cpp \
//     src/odeum/input/*.cpp -lyaml-cpp -lfmt -o problem_reader_fuzz
//   ./problem_reader_fuzz -max_total_time=60 cases/problems
// The normal suite has a short deterministic run, tests/formula/fuzz_test.cpp.
#include "fuzz/read_any_problem.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (!odeum::fuzz::read_any_problem({reinterpret_cast<const char*>(data), size})) __builtin_trap();
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// SUNDIALS alone: whether its code is compiled without optimisation. g++ -O0 begins a function with
// a frame (push %rbp; mov %rsp,%rbp) and stores the first argument there (mov %rdi,...(%rbp))
// before anything else; with optimisation it does neither. Exits 0 where it is so, 1 where it is
// not.
#include <cvode/cvode.h>

#include <cstdio>
#include <cstring>

int main() {
#ifndef __x86_64__
  std::printf("not told: another processor\n");
  return 0;
#endif
  unsigned char code[32];
  std::memcpy(code, reinterpret_cast<const void*>(&CVodeGetNumSteps), sizeof code);
  const unsigned char frame[] = {0x55, 0x48, 0x89, 0xe5}, store[] = {0x48, 0x89, 0x7d};
  const unsigned char* const begin = code + (code[0] == 0xf3 ? 4 : 0);  // endbr64
  bool stored = false;
  for (int i = 0; i < 12; ++i) stored = stored || std::memcmp(begin + i, store, sizeof store) == 0;
  const bool unoptimised = std::memcmp(begin, frame, sizeof frame) == 0 && stored;
  std::printf("CVodeGetNumSteps begins");
  for (int i = 0; i < 16; ++i) std::printf(" %02x", begin[i]);
  std::printf(": %s\n",
              unoptimised ? "compiled without optimisation" : "compiled with optimisation");
  return unoptimised ? 0 : 1;
}

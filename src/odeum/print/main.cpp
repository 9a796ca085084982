// SPDX-License-Identifier: BSD-3-Clause
// Run by CMake: prints a problem file that is a built-in case as C++, into the folders `problems`
// and `cases` of a folder. A file is written only where its text changes.
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "odeum/formula/problem.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/print/print_text.hpp"

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  if (odeum::text_of_file(path) == text) return;
  std::filesystem::create_directories(path.parent_path());
  if (!odeum::write_text(path, text)) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: odeum_print FILE.yaml FOLDER\n", stderr), 2;
  try {
    const std::filesystem::path file = argv[1], folder = argv[2];
    const std::string stem = file.stem().string();
    const odeum::print::Printed printed =
        odeum::print::print_text(argv[1], odeum::formula::problem_text(argv[1]));
    write(folder / "problems" / (stem + ".hpp"), printed.header);
    write(folder / "cases" / (stem + ".cpp"), printed.unit);
    return 0;
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}

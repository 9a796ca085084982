// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/machine.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#ifdef __linux__
#include <elf.h>
#include <link.h>
#endif

namespace odeum {
#ifdef __linux__
namespace {

/// Whether a function begins as compilers leave it without optimisation: it makes a frame and
/// stores its first argument there.
bool stores_its_argument(std::string_view code) {
  using namespace std::string_view_literals;
  const auto skip = [&](std::string_view bytes) {
    if (!code.starts_with(bytes)) return false;
    code.remove_prefix(bytes.size());
    return true;
  };
  skip("\xf3\x0f\x1e\xfa"sv);                     // endbr64
  if (!skip("\x55\x48\x89\xe5"sv)) return false;  // push rbp; mov rbp, rsp
  skip("\x53"sv);                                 // push rbx
  if (skip("\x48\x83\xec"sv))                     // sub rsp, of one byte
    code.remove_prefix(std::min<std::size_t>(1, code.size()));
  else if (skip("\x48\x81\xec"sv))  // of four
    code.remove_prefix(std::min<std::size_t>(4, code.size()));
  for (const std::string_view store : {"\x48\x89\x7d"sv, "\x48\x89\xbd"sv, "\x89\x7d"sv,
                                       "\x89\xbd"sv, "\xf2\x0f\x11\x45"sv, "\xf2\x0f\x11\x85"sv})
    if (code.starts_with(store)) return true;
  return false;
}

/// An object of type T at a place of a file; zeros where the file ends before.
template <class T>
T object_at(std::string_view file, std::size_t place) {
  T object{};
  if (place <= file.size() && file.size() - place >= sizeof(T))
    std::memcpy(&object, file.data() + place, sizeof(T));
  return object;
}

}  // namespace
#endif

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos)
        return line.substr(colon + 2);
  return "unknown";
}

std::vector<std::string> loaded_libraries() {
  std::vector<std::string> files;
#ifdef __linux__
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* list) {
        // The program itself has no name here.
        if (*info->dlpi_name)
          static_cast<std::vector<std::string>*>(list)->emplace_back(info->dlpi_name);
        return 0;
      },
      &files);
#endif
  return files;
}

std::string how_compiled([[maybe_unused]] const std::string& path) {
#ifdef __linux__
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string_view file = bytes;
  const auto head = object_at<Elf64_Ehdr>(file, 0);
  if (!file.starts_with(ELFMAG) || head.e_machine != EM_X86_64) return "";
  const auto section = [&](std::size_t k) {
    return object_at<Elf64_Shdr>(file, head.e_shoff + k * sizeof(Elf64_Shdr));
  };
  std::size_t functions = 0, storing = 0;
  for (std::size_t k = 0; k < head.e_shnum; ++k) {
    const Elf64_Shdr symbols = section(k);
    if (symbols.sh_type != SHT_DYNSYM) continue;
    for (std::size_t at = 0; at < symbols.sh_size; at += sizeof(Elf64_Sym)) {
      const auto symbol = object_at<Elf64_Sym>(file, symbols.sh_offset + at);
      if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_shndx == SHN_UNDEF) continue;
      const Elf64_Shdr code = section(symbol.st_shndx);
      const std::size_t place = symbol.st_value - code.sh_addr + code.sh_offset;
      if (place >= file.size()) continue;
      ++functions;
      storing += stores_its_argument(file.substr(place, 32));
    }
  }
  if (functions == 0) return "";
  // Without optimisation 99 of 100 do, with it none; wrappers in another language may dilute them.
  return 4 * storing > functions ? unoptimised : "with optimisation";
#else
  return "";
#endif
}

double number_of_environment(const char* variable, double otherwise) {
  const char* const given = std::getenv(variable);
  const double number = given ? std::atof(given) : 0;
  return number > 0 ? std::min(number, 86400.0) : otherwise;
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace odeum

# SPDX-License-Identifier: BSD-3-Clause
# cmake -DCLANG_FORMAT=<program> -DROOT=<folder> -P CheckFormat.cmake
# Fails where clang-format would change a source file. Versions differ: with any but the project's
# version it prints a message and passes.
set(version_used 14)
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
if(NOT version MATCHES "version ${version_used}\\.")
  message("not checked: needs clang-format ${version_used}, found ${version}")
  return()
endif()
set(files "")
foreach(folder IN ITEMS src adapters cases tests reports)
  file(GLOB_RECURSE found ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
  list(FILTER found EXCLUDE REGEX "/node_modules/|/reports/out/")
  list(APPEND files ${found})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files} RESULT_VARIABLE result)
if(result)
  message(FATAL_ERROR "run clang-format -i on the files above")
endif()
list(LENGTH files count)
message("${count} files are formatted")

# SPDX-License-Identifier: BSD-3-Clause
# What cmake --install puts besides the program: headers, the CMake package Odeum with its targets, a
# pkg-config file, and a Debian package by CPack.
#   Odeum::integrators        own methods for a program of one's own: headers, the standard library only
#   Odeum::integrators_eigen  the same with the methods that need Eigen, see below
#   Odeum::plugin             the C header of plug-ins
#   Odeum::laboratory         cases, studies and verdicts: the static libraries of this build
include(CMakePackageConfigHelpers)

# The program holds every text that it needs and runs from any folder; beside it lies what there is to
# read, in the folders that the README names.
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
file(GLOB odeum_documents CONFIGURE_DEPENDS reports/*.md)
install(FILES ${odeum_documents} DESTINATION ${CMAKE_INSTALL_DOCDIR}/reports)
install(DIRECTORY reports/findings reports/docs reports/measured DESTINATION ${CMAKE_INSTALL_DOCDIR}/reports)
install(DIRECTORY cases/scenes cases/tableaus cases/reference DESTINATION ${CMAKE_INSTALL_DOCDIR}/cases)
install(FILES ${ODEUM_CASE_TEXTS} DESTINATION ${CMAKE_INSTALL_DOCDIR}/cases)
install(DIRECTORY cases/problems DESTINATION ${CMAKE_INSTALL_DOCDIR}/cases FILES_MATCHING PATTERN "*.yaml"
        PATTERN "README.md")
# The program writes its completions and its manual page. One for another processor runs in an emulator, or not at all.
if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  set(odeum_words ${PROJECT_BINARY_DIR}/completions)
  install(CODE "
    file(MAKE_DIRECTORY \"${odeum_words}\")
    foreach(what IN ITEMS bash zsh fish man)
      execute_process(COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} \"$<TARGET_FILE:odeum>\" completion \${what}
                      OUTPUT_FILE \"${odeum_words}/\${what}\" COMMAND_ERROR_IS_FATAL ANY)
    endforeach()")
  install(FILES ${odeum_words}/bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME odeum)
  install(FILES ${odeum_words}/zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _odeum)
  install(FILES ${odeum_words}/fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d RENAME odeum.fish)
  install(FILES ${odeum_words}/man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME odeum.1)
endif()
if(ODEUM_NATIVE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/${odeum_peers}/ DESTINATION ${odeum_peers} OPTIONAL
          FILES_MATCHING PATTERN "lib*.so*" PATTERN "cmake" EXCLUDE)
  if("sundials" IN_LIST ODEUM_ADAPTERS_BUILT)
    install(CODE "
      if(NOT EXISTS \"${PROJECT_SOURCE_DIR}/build/${odeum_peers}\")
        message(WARNING \"SUNDIALS is the system's, as odeum doctor shows; scripts/sundials builds it with optimisation\")
      endif()")
  endif()
  install(CODE "message(WARNING \"tuned for this processor, may not run on another: install the preset portable\")")
endif()

set(odeum_package ${CMAKE_INSTALL_LIBDIR}/cmake/Odeum)
set(odeum_lab_headers ${CMAKE_INSTALL_INCLUDEDIR}/odeum-laboratory)

add_library(odeum_integrators INTERFACE)
target_include_directories(odeum_integrators INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                       $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(odeum_integrators INTERFACE cxx_std_20)
# See OdeumOptions.cmake: this compiler spoils constant vectors with AVX-512.
target_compile_options(odeum_integrators INTERFACE
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-fno-tree-slp-vectorize>)

# The parts of kernels that are not templates and use Eigen, compiled by whoever uses them.
set(odeum_eigen_files src/odeum/kernel/stage_transform.cpp src/odeum/linear/eigenvalues.cpp
                      src/odeum/linear/matrix_exponential.cpp src/odeum/linear/sparse_system.cpp
                      src/odeum/linear/ordering.cpp src/odeum/linear/pattern_lu.cpp
                      src/odeum/linear/differenced_entries.cpp)
add_library(odeum_integrators_eigen INTERFACE)
target_link_libraries(odeum_integrators_eigen INTERFACE odeum_integrators Eigen3::Eigen)
foreach(file IN LISTS odeum_eigen_files)
  get_filename_component(name ${file} NAME)
  target_sources(odeum_integrators_eigen INTERFACE
                 $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/${file}>
                 $<INSTALL_INTERFACE:${CMAKE_INSTALL_DATADIR}/odeum/src/${name}>)
endforeach()

add_library(odeum_plugin_interface INTERFACE)
target_include_directories(odeum_plugin_interface INTERFACE
                           $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

set_target_properties(odeum_integrators PROPERTIES EXPORT_NAME integrators)
set_target_properties(odeum_integrators_eigen PROPERTIES EXPORT_NAME integrators_eigen)
set_target_properties(odeum_plugin_interface PROPERTIES EXPORT_NAME plugin)
install(TARGETS odeum_integrators odeum_integrators_eigen odeum_plugin_interface EXPORT OdeumIntegrators)
install(EXPORT OdeumIntegrators NAMESPACE Odeum:: DESTINATION ${odeum_package})

set(odeum_lab odeum_core odeum_cases odeum_study odeum_plugins odeum_fmi)
foreach(adapter IN LISTS ODEUM_ADAPTERS_BUILT)
  list(APPEND odeum_lab odeum_adapter_${adapter})
endforeach()
foreach(target IN LISTS odeum_lab)
  string(REPLACE "odeum_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endforeach()
set_target_properties(odeum_study PROPERTIES EXPORT_NAME laboratory)
target_compile_features(odeum_core INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
target_include_directories(odeum_core INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                                                $<INSTALL_INTERFACE:${odeum_lab_headers}>)
install(TARGETS ${odeum_lab} EXPORT OdeumLaboratory ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/odeum)
install(EXPORT OdeumLaboratory NAMESPACE Odeum:: DESTINATION ${odeum_package})

list(TRANSFORM odeum_eigen_files REPLACE "^src/" "" OUTPUT_VARIABLE odeum_units)
install(CODE "
  set(ODEUM_SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(ODEUM_INCLUDE \"${CMAKE_INSTALL_INCLUDEDIR}\")
  set(ODEUM_UNITS \"${odeum_units}\")")
install(SCRIPT scripts/cmake/InstallHeaders.cmake)
install(FILES src/odeum/api/plugin.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odeum)
install(FILES ${ODEUM_GENERATED}/odeum_methods.hpp DESTINATION ${odeum_lab_headers})
install(FILES ${odeum_eigen_files} DESTINATION ${CMAKE_INSTALL_DATADIR}/odeum/src)

get_property(odeum_dependency_items GLOBAL PROPERTY ODEUM_PACKAGES)
configure_package_config_file(scripts/cmake/OdeumConfig.cmake.in ${ODEUM_GENERATED}/OdeumConfig.cmake
                              INSTALL_DESTINATION ${odeum_package} PATH_VARS CMAKE_INSTALL_DATADIR CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${ODEUM_GENERATED}/OdeumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH odeum_pc_back /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(scripts/cmake/odeum.pc.in ${ODEUM_GENERATED}/odeum.pc @ONLY)
install(FILES ${ODEUM_GENERATED}/OdeumConfig.cmake ${ODEUM_GENERATED}/OdeumConfigVersion.cmake
              scripts/cmake/OdeumAccuracyTest.cmake scripts/cmake/OdeumCheckConsumer.cmake
        DESTINATION ${odeum_package})
install(FILES ${ODEUM_GENERATED}/odeum.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES scripts/cmake/accuracy_test.cpp.in DESTINATION ${CMAKE_INSTALL_DATADIR}/odeum)
install(FILES CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
# In the form that Debian asks for.
file(READ LICENSE odeum_licence)
string(REGEX REPLACE "\n\n" "\n.\n" odeum_licence "${odeum_licence}")
string(REGEX REPLACE "\n" "\n " odeum_licence "${odeum_licence}")
set(odeum_note "")
if("gsl" IN_LIST ODEUM_ADAPTERS_BUILT)
  set(odeum_note "Comment: the program and the laboratory's libraries use GSL and are distributed under\n GPL-3.0-or-later, see /usr/share/common-licenses/GPL-3.\n")
endif()
file(CONFIGURE OUTPUT ${ODEUM_GENERATED}/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: odeum

Files: *
Copyright: 2026, the Odeum authors
License: BSD-3-Clause
${odeum_note}
License: BSD-3-Clause
 ${odeum_licence}
")
install(FILES ${ODEUM_GENERATED}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME odeum)
set(CPACK_PACKAGE_VENDOR "the Odeum authors")
set(CPACK_PACKAGE_CONTACT "the Odeum authors <odeum@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_STRIP_FILES ON)
# To build against the static libraries; the program needs none of them.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libeigen3-dev, libfmt-dev, libyaml-cpp-dev, libgmp-dev, zlib1g-dev, libsundials-dev, libgsl-dev, libboost-dev, libbullet-dev, libzip-dev, libpugixml-dev")
include(CPack)

# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
# One interface target that every floor links: language, warnings, and the flags that keep results bit for bit the same.
add_library(isago_options INTERFACE)
target_compile_features(isago_options INTERFACE cxx_std_20)
target_include_directories(isago_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(isago_options INTERFACE -Wall -Wextra -Wpedantic -ffp-contract=off -fopenmp-simd -fno-math-errno -fno-trapping-math)
target_compile_definitions(isago_options INTERFACE OMPI_SKIP_MPICXX=1 ISAGO_VERSION="${PROJECT_VERSION}")
if(ISAGO_NATIVE)
  target_compile_options(isago_options INTERFACE -march=native)
endif()
if(ISAGO_ASSERTIONS)
  string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
endif()
if(ISAGO_TRAP_FPE)
  # Without -ftrapping-math the compiler may divide where the program does not, and the trap would be false.
  target_compile_options(isago_options INTERFACE -ftrapping-math)
  target_compile_definitions(isago_options INTERFACE ISAGO_TRAP_FPE=1)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON) # the cache does more, and precompiled headers would spoil it
endif()

# precompile(TARGET): the headers of precompiled.hpp, read once for all targets.
function(precompile target)
  if(TARGET isago_core AND NOT target STREQUAL isago_core)
    target_precompile_headers(${target} REUSE_FROM isago_core)
  else()
    target_precompile_headers(${target} PRIVATE ${CMAKE_SOURCE_DIR}/cmake/precompiled.hpp)
  endif()
endfunction()

# add_floor(NAME libraries...): the static library of one floor, from all sources under its folder.
function(add_floor name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/cli/")
  add_library(isago_${name} STATIC ${sources})
  set_target_properties(isago_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(isago_${name} PUBLIC isago_options ${ARGN})
  precompile(isago_${name})
endfunction()

# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
# The rules of the house, each a script that needs nothing but python3.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
file(GLOB checks CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/check_*.py)
foreach(check ${checks})
  get_filename_component(name ${check} NAME_WE)
  string(REPLACE check_ house_ name ${name})
  add_test(NAME ${name} COMMAND ${Python3_EXECUTABLE} -B ${check})
  set_tests_properties(${name} PROPERTIES LABELS "house;quick" TIMEOUT 60)
endforeach()

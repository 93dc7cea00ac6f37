# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, which adds one test to CTest for each suite of PROGRAM's: what the program itself
# lists, so that no test is left out. FILTER chooses as --gtest_filter does, EMULATOR (a list) runs
# the program.
cmake_policy(VERSION 3.18)

# The slowest first: nothing is left to wait for at the end.
set(cost_of_Parallel 30)
set(cost_of_OnRanks 25)
set(cost_of_NearestSources 20)
set(cost_of_ParallelFront 20)

execute_process(
  COMMAND ${EMULATOR} "${PROGRAM}" --gtest_list_tests "--gtest_filter=${FILTER}"
  OUTPUT_VARIABLE listed
  RESULT_VARIABLE result)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} does not list its tests: ${result}")
endif ()

# One string for each suite: its name with a dot, then its tests.
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}") # values of parameters
string(REGEX REPLACE "\n  " " " listed "${listed}")
string(REGEX MATCHALL "[^\n ]+\\. [^\n]+" suites "${listed}")
set(content)
set(count 0)
foreach (suite IN LISTS suites)
  string(REPLACE " " ";" tests "${suite}")
  list(POP_FRONT tests name)
  list(LENGTH tests number)
  math(EXPR count "${count} + ${number}")
  set(chosen "${name}*")
  if (NOT FILTER STREQUAL "*")
    list(TRANSFORM tests PREPEND "${name}")
    list(JOIN tests ":" chosen)
  endif ()
  string(REGEX REPLACE "\\.$" "" name "${name}")
  string(REGEX REPLACE "^.*/" "" short "${name}")
  set(cost 1)
  if (DEFINED cost_of_${short})
    set(cost "${cost_of_${short}}")
  endif ()
  set(command)
  foreach (word IN LISTS EMULATOR PROGRAM ITEMS "--gtest_filter=${chosen}")
    string(APPEND command " [==[${word}]==]")
  endforeach ()
  string(APPEND content
    "add_test([==[Core.${name}]==]${command})\n"
    "set_tests_properties([==[Core.${name}]==] PROPERTIES"
    " SKIP_RETURN_CODE 77 TIMEOUT 2700 COST ${cost})\n")
endforeach ()
if (count EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} has no test for \"${FILTER}\".")
endif ()
file(WRITE "${OUTPUT}" "# ${count} tests\n${content}")

# SPDX-License-Identifier: BSD-3-Clause

# Fails where a file of the filters calls a function of the library whose last bits depend on the system
# and the processor. Trigonometry.h has such functions, by which results are the same everywhere.
file(GLOB_RECURSE files "${FOLDER}/*.h" "${FOLDER}/*.cxx")
list(LENGTH files count)
if (count LESS 100)
  message(FATAL_ERROR "Only ${count} sources found in ${FOLDER}.")
endif ()

set(bad)
foreach (file IN LISTS files)
  file(STRINGS "${file}" lines
    REGEX "std::(a?(sin|cos|tan)h?|atan2|hypot|pow|exp2?|cbrt|log2|log10|tgamma|erf) *\\(")
  foreach (line IN LISTS lines)
    if (NOT line MATCHES "^ *//")
      string(APPEND bad "\n  ${file}: ${line}")
    endif ()
  endforeach ()
endforeach ()
if (bad)
  message(FATAL_ERROR "Results would depend on the processor (see Trigonometry.h):${bad}")
endif ()
message(STATUS "${count} sources that compute the same bits everywhere")

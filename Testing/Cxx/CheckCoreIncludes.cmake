# SPDX-License-Identifier: BSD-3-Clause

# Fails where a file of the engine includes a header of VTK.
file(GLOB_RECURSE files "${FOLDER}/*.h" "${FOLDER}/*.cxx")
list(LENGTH files count)
if (count LESS 30)
  message(FATAL_ERROR "Only ${count} sources found in ${FOLDER}.")
endif ()

set(bad)
foreach (file IN LISTS files)
  file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"][^>\"]*vtk")
  foreach (line IN LISTS lines)
    string(APPEND bad "\n  ${file}: ${line}")
  endforeach ()
endforeach ()
if (bad)
  message(FATAL_ERROR "The engine must not include VTK:${bad}")
endif ()
message(STATUS "${count} sources without VTK headers")

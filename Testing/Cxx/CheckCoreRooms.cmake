# SPDX-License-Identifier: BSD-3-Clause

cmake_minimum_required(VERSION 3.18...3.25)

# Fails where a file of the engine includes a header of a room after its own. A room is a folder; it
# uses only the rooms above it in the table of README.md, and files beside the folders use none.
set(rooms)
file(STRINGS "${FOLDER}/README.md" rows REGEX "^[|] `[a-z]+` [|]")
foreach (row IN LISTS rows)
  string(REGEX REPLACE "^[|] `([a-z]+)`.*" "\\1" room "${row}")
  list(APPEND rooms "${room}")
endforeach ()

file(GLOB_RECURSE files RELATIVE "${FOLDER}"
  "${FOLDER}/*.h" "${FOLDER}/*.cxx")
list(LENGTH files count)
if (count LESS 30)
  message(FATAL_ERROR "Only ${count} sources found in ${FOLDER}.")
endif ()

set(bad)
set(seen)
foreach (file IN LISTS files)
  get_filename_component(room "${file}" DIRECTORY)
  list(FIND rooms "${room}" place)
  if (room AND place EQUAL -1)
    string(APPEND bad "\n  ${file}: there is no room ${room}")
  endif ()
  list(APPEND seen "${room}")

  file(STRINGS "${FOLDER}/${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
  foreach (line IN LISTS lines)
    string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*$" "\\1" header "${line}")
    if (NOT EXISTS "${FOLDER}/${header}")
      string(APPEND bad "\n  ${file}: ${header} is not named from the engine's folder")
      continue ()
    endif ()
    get_filename_component(used "${header}" DIRECTORY)
    list(FIND rooms "${used}" usedPlace)
    if (usedPlace GREATER place)
      string(APPEND bad "\n  ${file}: ${header} is in a room after its own")
    endif ()
  endforeach ()
endforeach ()

foreach (room IN LISTS rooms)
  if (NOT room IN_LIST seen)
    string(APPEND bad "\n  the room ${room} is empty")
  endif ()
endforeach ()
if (bad)
  message(FATAL_ERROR "A room may use only the rooms before it (${rooms}):${bad}")
endif ()
message(STATUS "${count} sources, each of which uses its own room and those before it")

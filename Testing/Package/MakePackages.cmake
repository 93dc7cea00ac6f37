# SPDX-License-Identifier: BSD-3-Clause

# Makes packages of a build, and unpacks them into FOLDER/root, where nothing earlier hides what is
# missing.
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${CPACK}" -G "${GENERATOR}" -C "${CONFIG}" -B "${FOLDER}"
  WORKING_DIRECTORY "${BUILD}"
  RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "cpack -G ${GENERATOR} failed: ${result}")
endif ()

set(root "${FOLDER}/root")
file(MAKE_DIRECTORY "${root}")
file(GLOB packages "${FOLDER}/*.deb" "${FOLDER}/*.tar.gz")
if (NOT packages)
  message(FATAL_ERROR "cpack -G ${GENERATOR} made no package.")
endif ()
foreach (package IN LISTS packages)
  if (package MATCHES "\\.deb$")
    execute_process(COMMAND dpkg-deb -x "${package}" "${root}" RESULT_VARIABLE result)
  else ()
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -E tar xf "${package}"
      WORKING_DIRECTORY "${root}"
      RESULT_VARIABLE result)
  endif ()
  if (result)
    message(FATAL_ERROR "${package} cannot be unpacked: ${result}")
  endif ()
endforeach ()

# The list of plugins is written where the package is installed.
file(GLOB plugin "${FOLDER}/geodesic-distance_*.deb")
if (plugin)
  execute_process(COMMAND dpkg-deb -e "${plugin}" "${FOLDER}/control")
  file(MAKE_DIRECTORY "${root}/usr/bin")
  if (EXISTS "${FOLDER}/control/postinst")
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -E env "DPKG_ROOT=${root}" "${FOLDER}/control/postinst" configure
      RESULT_VARIABLE result)
    if (result)
      message(FATAL_ERROR "The script of ${plugin} failed: ${result}")
    endif ()
  endif ()
endif ()

# ParaView looks for this list beside the program that runs.
find_program(pvpython pvpython)
if (GENERATOR STREQUAL "DEB" AND pvpython)
  file(REAL_PATH "${pvpython}" pvpython)
  file(COPY_FILE "${pvpython}" "${root}/usr/bin/pvpython")
  message(STATUS "Unpacked into ${root}, with a copy of pvpython that runs there; "
    "bash Testing/package.sh installs the packages on a clean Debian.")
endif ()

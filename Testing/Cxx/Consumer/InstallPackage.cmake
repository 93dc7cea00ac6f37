# SPDX-License-Identifier: BSD-3-Clause

# Installs into an empty prefix, so that nothing of an earlier installation hides what is missing.
file(REMOVE_RECURSE "${PREFIX}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}" --config "${CONFIG}"
  RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "The installation failed: ${result}")
endif ()

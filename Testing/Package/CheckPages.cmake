# SPDX-License-Identifier: BSD-3-Clause

# Fails on anything that Doxygen complained about, and where it wrote no pages.
if (NOT EXISTS "${PAGES}/classvtkGeodesicDistanceField.html")
  message(FATAL_ERROR "There are no pages in ${PAGES}: build the target docs.")
endif ()
file(READ "${WARNINGS}" warnings)
if (warnings)
  message(FATAL_ERROR "Doxygen complains:\n${warnings}")
endif ()

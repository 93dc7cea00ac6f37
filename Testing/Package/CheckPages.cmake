# SPDX-License-Identifier: BSD-3-Clause

# Fails on anything that Doxygen complained about, where it wrote no pages, and where a page links a state
# of the gallery that was not made.
if (NOT EXISTS "${PAGES}/classvtkGeodesicDistanceField.html")
  message(FATAL_ERROR "There are no pages in ${PAGES}: build the target docs.")
endif ()
file(READ "${WARNINGS}" warnings)
if (warnings)
  message(FATAL_ERROR "Doxygen complains:\n${warnings}")
endif ()

file(STRINGS "${PAGES}/gallery.html" links REGEX "states/[a-z_]+\\.pvsm")
list(LENGTH links count)
message(STATUS "${count} states of the gallery")
foreach (link IN LISTS links)
  string(REGEX MATCH "states/[a-z_]+\\.pvsm" state "${link}")
  if (NOT EXISTS "${PAGES}/../${state}")
    message(FATAL_ERROR "The gallery links ${state}, which was not made.")
  endif ()
endforeach ()

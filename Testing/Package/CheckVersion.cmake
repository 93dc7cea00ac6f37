# SPDX-License-Identifier: BSD-3-Clause

# The version stands in CMakeLists.txt; the citation and the changelog must know it.
file(STRINGS "${SOURCE}/CITATION.cff" cited REGEX "^version: ")
if (NOT cited STREQUAL "version: ${VERSION}")
  message(FATAL_ERROR "The version is ${VERSION}, but CITATION.cff says \"${cited}\".")
endif ()
file(READ "${SOURCE}/CHANGELOG.md" changes)
string(FIND "${changes}" "\n## [${VERSION}] - " place)
if (place EQUAL -1)
  message(FATAL_ERROR "CHANGELOG.md has no heading \"## [${VERSION}] - date\".")
endif ()

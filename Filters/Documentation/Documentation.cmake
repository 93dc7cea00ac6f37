# SPDX-License-Identifier: BSD-3-Clause

# Pages and pictures lie as in the source tree, so that their links lead somewhere.
file(GLOB_RECURSE pages CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}"
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*.md" "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*.svg"
  "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Platforms.md" "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Benchmarks/*.md"
  "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Benchmarks/*.png" "${CMAKE_CURRENT_SOURCE_DIR}/Testing/Benchmarks/*.csv")
foreach (page IN ITEMS ${pages} README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE)
  get_filename_component(folder "${page}" DIRECTORY)
  install(
    FILES       "${CMAKE_CURRENT_SOURCE_DIR}/${page}"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}/${folder}"
    COMPONENT   documentation)
endforeach ()
install(
  DIRECTORY   "${CMAKE_CURRENT_SOURCE_DIR}/Examples/"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}/Examples"
  COMPONENT   documentation
  PATTERN     "*.sh" EXCLUDE
  PATTERN     "__pycache__" EXCLUDE)

# API pages: `cmake --build build --target docs` writes docs/html/index.html into the build folder.
# Where Doxygen is installed they are a part of the whole build, so that packages have them. What
# Doxygen complains about is printed, and a test fails on it.
find_package(Doxygen QUIET)
option(GEODESIC_BUILD_DOCS "Build the API pages with everything else" "${DOXYGEN_FOUND}")

if (NOT DOXYGEN_FOUND)
  if (GEODESIC_BUILD_DOCS)
    message(FATAL_ERROR "GEODESIC_BUILD_DOCS needs Doxygen (Debian: doxygen).")
  endif ()
  message(STATUS "Doxygen not found (Debian: doxygen): there are no API pages.")
  add_custom_target(docs
    COMMAND "${CMAKE_COMMAND}" -E echo "The API pages need Doxygen (Debian: doxygen); then configure again."
    COMMAND "${CMAKE_COMMAND}" -E false
    VERBATIM)
  return ()
endif ()

set(all)
if (GEODESIC_BUILD_DOCS)
  set(all ALL)
endif ()
set(geodesic_docs_dir "${CMAKE_BINARY_DIR}/docs")
foreach (name IN ITEMS Doxyfile DoxyfilePublic)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/${name}.in" "${geodesic_docs_dir}/${name}" @ONLY)
endforeach ()

# The gallery's state files for ParaView. They need the plugin, but no screen.
find_program(GEODESIC_PVPYTHON pvpython)
mark_as_advanced(GEODESIC_PVPYTHON)
set(states)
if (GEODESIC_BUILD_PLUGIN AND GEODESIC_PVPYTHON)
  set(states "${geodesic_docs_dir}/states")
  file(GLOB scripts CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/Examples/gallery/*.py")
  add_custom_command(
    OUTPUT  "${states}/made"
    COMMAND "${CMAKE_COMMAND}" -E env --unset=DISPLAY PYTHONDONTWRITEBYTECODE=1
      "PV_PLUGIN_PATH=$<TARGET_FILE_DIR:GeodesicDistance>" "${GEODESIC_PVPYTHON}" --dr
      "${CMAKE_CURRENT_SOURCE_DIR}/Examples/gallery/all.py" --states "${states}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${states}/made"
    DEPENDS ${scripts}
    COMMENT "Writing the gallery's states into ${states}"
    VERBATIM)
  add_custom_target(gallery-states ${all} DEPENDS "${states}/made")
  add_dependencies(gallery-states GeodesicDistance)
  install(
    DIRECTORY   "${states}"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    COMPONENT   documentation
    OPTIONAL
    PATTERN     "made" EXCLUDE)
endif ()

# Scripts whose surface is a scan, where the scans are not installed.
set(geodesic_without_scan)
file(GLOB scripts CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/Examples/gallery/*.py")
foreach (script IN LISTS scripts)
  file(STRINGS "${script}" uses_scan REGEX "^[a-z_]+ = scan\\.")
  if (uses_scan AND NOT EXISTS "/usr/share/mricron/templates")
    get_filename_component(name "${script}" NAME_WE)
    list(APPEND geodesic_without_scan "${name}")
  endif ()
endforeach ()
if (geodesic_without_scan)
  message(STATUS "No scans (Debian: mricron-data): there are no states of ${geodesic_without_scan}.")
endif ()

# The gallery as a page. Its links lead to the examples and states beside the pages, in the build folder
# and where they are installed.
set(examples "${CMAKE_CURRENT_SOURCE_DIR}/Examples")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${examples}/README.md")
file(READ "${examples}/README.md" page)
if (states)
  string(REGEX REPLACE "(\\[Script\\]\\(gallery/([a-z_]+)\\.py\\))" "\\1, [state](../states/\\2.pvsm)"
    page "${page}")
endif ()
foreach (name IN LISTS geodesic_without_scan)
  string(REPLACE ", [state](../states/${name}.pvsm)" "" page "${page}")
endforeach ()
string(REGEX REPLACE "\\]\\((gallery/[a-z_]+\\.py)\\)" "](../Examples/\\1)" page "${page}")
string(REGEX REPLACE "\\[([a-z ]+)\\]\\(#[a-z-]+\\)" "\\1" page "${page}")
string(REPLACE "\n# Gallery\n" "\n# Gallery {#gallery}\n" page "\n${page}")
file(CONFIGURE OUTPUT "${geodesic_docs_dir}/Gallery.md" CONTENT "${page}" @ONLY)
file(CREATE_LINK "${examples}" "${geodesic_docs_dir}/Examples" SYMBOLIC RESULT result)
if (result) # where links are not allowed
  file(COPY "${examples}/" DESTINATION "${geodesic_docs_dir}/Examples")
endif ()

file(GLOB_RECURSE headers CONFIGURE_DEPENDS
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*.h" "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*.md")
add_custom_command(
  OUTPUT  "${geodesic_docs_dir}/warnings.txt"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${geodesic_docs_dir}/html"
  COMMAND Doxygen::doxygen "${geodesic_docs_dir}/Doxyfile"
  COMMAND "${CMAKE_COMMAND}" -E cat "${geodesic_docs_dir}/warnings.txt"
  DEPENDS "${geodesic_docs_dir}/Doxyfile" "${geodesic_docs_dir}/Gallery.md" ${headers}
  COMMENT "Writing the API pages into ${geodesic_docs_dir}/html"
  VERBATIM)
add_custom_target(docs ${all} DEPENDS "${geodesic_docs_dir}/warnings.txt")

install(
  DIRECTORY   "${geodesic_docs_dir}/html"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT   documentation
  OPTIONAL)

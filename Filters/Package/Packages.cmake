# SPDX-License-Identifier: BSD-3-Clause

# Packages: after a build `cpack -G TGZ` and `cpack -G DEB` in its folder, or `cpack` for both.
# Installed files belong to the components runtime (the library), plugin, python, development,
# documentation and licenses. The archive has all of them; Debian's packages are made of them in
# CPackGenerator.cmake.
set(CPACK_PACKAGE_NAME "geodesic-distance")
set(CPACK_PACKAGE_VENDOR "Geodesic Distance authors")
# Debian wants an address: this one stands for that of whoever makes the packages (.example is reserved for
# such), which CPackGenerator.cmake takes from the environment.
set(CPACK_PACKAGE_CONTACT "Geodesic Distance authors <geodesic-distance@maintainer.example>")
set(GEODESIC_HOMEPAGE "" CACHE STRING "Address of the project's page, for the packages' Homepage")
set(CPACK_PACKAGE_HOMEPAGE_URL "${GEODESIC_HOMEPAGE}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_RESOURCE_FILE_README "${PROJECT_SOURCE_DIR}/README.md")
set(CPACK_PACKAGE_FILE_NAME
  "geodesic-distance-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_GENERATOR TGZ)
if (EXISTS "/etc/debian_version" AND (ParaView_FOUND OR GEODESIC_BUILD_PYTHON))
  list(APPEND CPACK_GENERATOR DEB)
endif ()
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/CPackGenerator.cmake")

# What the scripts that CPack runs have to know of this build.
set(CPACK_GEODESIC_SOURCE_DIR "${PROJECT_SOURCE_DIR}")
set(CPACK_GEODESIC_LIBRARIES "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_GEODESIC_LIBDIR "${CMAKE_INSTALL_LIBDIR}")
set(CPACK_GEODESIC_STRIP "${CMAKE_STRIP}")
set(CPACK_GEODESIC_BUILD_DIR "${PROJECT_BINARY_DIR}")
set(CPACK_GEODESIC_PAGES)
set(CPACK_GEODESIC_PAGES_TARGETS docs)
if (DOXYGEN_FOUND)
  set(CPACK_GEODESIC_PAGES "${geodesic_docs_dir}/html/index.html")
endif ()
if (TARGET gallery-states)
  list(APPEND CPACK_GEODESIC_PAGES_TARGETS gallery-states)
endif ()
set(CPACK_GEODESIC_HAS_PARAVIEW "${ParaView_FOUND}")
# Debian's ParaView 6 uses Debian's VTK, whose headers its own headers' package does not bring.
set(CPACK_GEODESIC_VTK_HEADERS)
if (ParaView_FOUND AND NOT geodesic_vtk_path)
  set(CPACK_GEODESIC_VTK_HEADERS ", libvtk9-dev")
endif ()
set(CPACK_GEODESIC_PLUGINS_FILE)
if (GEODESIC_BUILD_PLUGIN)
  set(CPACK_GEODESIC_PLUGINS_FILE
    "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/${geodesic_plugins_file}")
endif ()
# The folder for plugins of other packages, where Debian's ParaView has one.
set(CPACK_GEODESIC_OTHER_PLUGINS)
set(debian_list "${ParaView_PREFIX_PATH}/lib/${CMAKE_LIBRARY_ARCHITECTURE}")
string(APPEND debian_list "/paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/paraview.conf")
if (ParaView_FOUND AND EXISTS "${debian_list}")
  file(STRINGS "${debian_list}" CPACK_GEODESIC_OTHER_PLUGINS REGEX "^/usr/share/paraview/plugins$")
endif ()
set(CPACK_GEODESIC_PYTHON_DESTINATION)
if (GEODESIC_BUILD_PYTHON)
  set(CPACK_GEODESIC_PYTHON_DESTINATION "${GEODESIC_PYTHON_DESTINATION}")
endif ()
set(CPACK_GEODESIC_PYTHON "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
set(CPACK_GEODESIC_NEXT_PYTHON)
if (Python3_FOUND)
  math(EXPR minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_GEODESIC_NEXT_PYTHON "${Python3_VERSION_MAJOR}.${minor}")
endif ()

# Which package has the library, for packages that link it; and that installing it tells the linker.
set(CPACK_GEODESIC_CONTROL_DIR "${CMAKE_BINARY_DIR}/Module/Debian")
get_target_property(soversion FiltersGeodesic SOVERSION)
if (NOT soversion)
  set(soversion "${PROJECT_VERSION}")
endif ()
file(WRITE "${CPACK_GEODESIC_CONTROL_DIR}/shlibs"
  "libvtkFiltersGeodesic ${soversion} geodesic-distance (>= ${PROJECT_VERSION})\n")
file(WRITE "${CPACK_GEODESIC_CONTROL_DIR}/triggers" "activate-noawait ldconfig\n")
# The scripts of the plugin's package, where all packages share one list of plugins. Elsewhere it has none:
# names of files that are not there keep CPack from making scripts that call ldconfig (Debian has a trigger).
set(CPACK_GEODESIC_PLUGIN_SCRIPTS
  "${CPACK_GEODESIC_CONTROL_DIR}/none/postinst;${CPACK_GEODESIC_CONTROL_DIR}/none/postrm")
if (GEODESIC_BUILD_PLUGIN AND NOT CPACK_GEODESIC_OTHER_PLUGINS)
  file(RELATIVE_PATH geodesic_plugins_line "/usr/bin" "/usr/${CPACK_GEODESIC_PLUGINS_FILE}")
  set(CPACK_GEODESIC_PLUGIN_SCRIPTS)
  foreach (script IN ITEMS postinst postrm)
    configure_file("${CMAKE_CURRENT_LIST_DIR}/plugin/${script}.in" "${CPACK_GEODESIC_CONTROL_DIR}/${script}" @ONLY)
    list(APPEND CPACK_GEODESIC_PLUGIN_SCRIPTS "${CPACK_GEODESIC_CONTROL_DIR}/${script}")
  endforeach ()
endif ()
# The scripts of the Python package, for that with plain VTK.
foreach (script IN ITEMS postinst prerm)
  file(READ "${CMAKE_CURRENT_LIST_DIR}/python3/${script}" text)
  string(REPLACE "python3-geodesicdistance" "python3-geodesicdistance-vtk9" text "${text}")
  file(WRITE "${CMAKE_BINARY_DIR}/Module/${script}" "${text}")
  file(COPY "${CMAKE_BINARY_DIR}/Module/${script}" DESTINATION "${CPACK_GEODESIC_CONTROL_DIR}/vtk9"
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach ()

include(CPack)

# SPDX-License-Identifier: BSD-3-Clause

# Read by CPack once for each kind of package. All files go into one archive; Debian gets
#
#   geodesic-distance          the library and the ParaView plugin
#   python3-geodesicdistance   the Python module
#   geodesic-distance-dev      headers and the CMake package
#   geodesic-distance-doc      API pages and examples
#
# and of a build against plain VTK, whose Python excludes ParaView's,
#
#   python3-geodesicdistance-vtk9   the Python module, with the library in its folder
if (NOT CPACK_GENERATOR STREQUAL "DEB")
  return ()
endif ()
if (NOT CPACK_GEODESIC_PYTHON_DESTINATION)
  message(FATAL_ERROR "Debian packages have the Python module (GEODESIC_BUILD_PYTHON).")
endif ()
if (CPACK_GEODESIC_HAS_PARAVIEW AND NOT CPACK_GEODESIC_PLUGINS_FILE)
  message(FATAL_ERROR "Debian packages of a build with ParaView have the plugin (GEODESIC_BUILD_PLUGIN).")
endif ()

# Pages that were not built are built now.
if (CPACK_GEODESIC_PAGES AND NOT EXISTS "${CPACK_GEODESIC_PAGES}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" --build "${CPACK_GEODESIC_BUILD_DIR}" --target ${CPACK_GEODESIC_PAGES_TARGETS}
    RESULT_VARIABLE result)
  if (result OR NOT EXISTS "${CPACK_GEODESIC_PAGES}")
    message(FATAL_ERROR "The API pages could not be built: ${result}")
  endif ()
endif ()

set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
if (CPACK_GEODESIC_HAS_PARAVIEW)
  set(CPACK_COMPONENTS_ALL runtime plugin python development)
  set(CPACK_COMPONENT_RUNTIME_GROUP application)
  set(CPACK_COMPONENT_PLUGIN_GROUP application)
  set(CPACK_GEODESIC_PACKAGES
    application:geodesic-distance
    python:python3-geodesicdistance
    development:geodesic-distance-dev)
  if (CPACK_GEODESIC_PAGES)
    list(APPEND CPACK_COMPONENTS_ALL documentation)
    list(APPEND CPACK_GEODESIC_PACKAGES documentation:geodesic-distance-doc)
  else ()
    message("There is no package geodesic-distance-doc: its pages need Doxygen (Debian: doxygen). Install it "
      "and run cmake again.")
  endif ()
else ()
  set(CPACK_COMPONENTS_ALL runtime python)
  set(CPACK_COMPONENT_RUNTIME_GROUP module)
  set(CPACK_COMPONENT_PYTHON_GROUP module)
  set(CPACK_GEODESIC_PACKAGES module:python3-geodesicdistance-vtk9)
endif ()

# ----------------------------------------------------------------------------------- all packages
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE "geodesic-distance")
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CPACK_GEODESIC_LIBRARIES}")
set(same_version "(= ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# The maintainer is whoever makes the packages, by the variables of Debian's own tools.
if (NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(name "$ENV{DEBFULLNAME}")
  if (NOT name)
    set(name "Geodesic Distance authors")
  endif ()
  set(CPACK_PACKAGE_CONTACT "${name} <$ENV{DEBEMAIL}>")
endif ()

# A description's first line is the summary: CPack's own would come before it.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY)
set(what_it_is
  "The length of the shortest path on a surface of triangles to points, polylines
or the boundary: exact, or faster within a certified error, on a mesh that is
refined until linear interpolation is within a tolerance.")

# ----------------------------------------------------------------------------- library and plugin
set(CPACK_DEBIAN_APPLICATION_PACKAGE_NAME "geodesic-distance")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_SECTION science)
set(CPACK_DEBIAN_APPLICATION_PACKAGE_RECOMMENDS "python3-paraview")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_SUGGESTS
  "python3-geodesicdistance, geodesic-distance-dev, geodesic-distance-doc")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_CONTROL_EXTRA
  "${CPACK_GEODESIC_CONTROL_DIR}/shlibs;${CPACK_GEODESIC_CONTROL_DIR}/triggers"
  ${CPACK_GEODESIC_PLUGIN_SCRIPTS})
set(CPACK_DEBIAN_APPLICATION_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_APPLICATION_DESCRIPTION
  "geodesic distance on triangle meshes, ParaView plugin
${what_it_is}
.
This package has the VTK filters and the ParaView plugin, which ParaView
")
if (CPACK_GEODESIC_OTHER_PLUGINS)
  string(APPEND CPACK_DEBIAN_APPLICATION_DESCRIPTION
    "offers in Tools > Manage Plugins: Filters > Geodesic.")
else ()
  string(APPEND CPACK_DEBIAN_APPLICATION_DESCRIPTION
    "loads when it starts: Filters > Geodesic.")
endif ()

# ----------------------------------------------------------------------------------------- Python
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME "python3-geodesicdistance")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "geodesic-distance ${same_version}, python3-paraview, python3-numpy, "
  "python3 (>= ${CPACK_GEODESIC_PYTHON}), python3 (<< ${CPACK_GEODESIC_NEXT_PYTHON})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_LIST_DIR}/python3/postinst;${CMAKE_CURRENT_LIST_DIR}/python3/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "geodesic distance on triangle meshes, Python module
${what_it_is}
.
This package has the VTK filters as a Python module.")

# ------------------------------------------------------------------------- Python with plain VTK
set(CPACK_DEBIAN_MODULE_PACKAGE_NAME "python3-geodesicdistance-vtk9")
set(CPACK_DEBIAN_MODULE_PACKAGE_SECTION python)
string(CONCAT CPACK_DEBIAN_MODULE_PACKAGE_DEPENDS
  "python3-vtk9, python3-numpy, "
  "python3 (>= ${CPACK_GEODESIC_PYTHON}), python3 (<< ${CPACK_GEODESIC_NEXT_PYTHON})")
set(CPACK_DEBIAN_MODULE_PACKAGE_CONFLICTS "python3-geodesicdistance")
set(CPACK_DEBIAN_MODULE_PACKAGE_CONTROL_EXTRA
  "${CPACK_GEODESIC_CONTROL_DIR}/vtk9/postinst;${CPACK_GEODESIC_CONTROL_DIR}/vtk9/prerm")
set(CPACK_DEBIAN_MODULE_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_MODULE_DESCRIPTION "geodesic distance on triangle meshes, Python module for VTK
${what_it_is}
.
This package has the filters of VTK 9 as a Python module, without ParaView, and
functions for numpy arrays.")

# ------------------------------------------------------------------------------------ development
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME "geodesic-distance-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
# ParaView's CMake package asks for Open MPI, which paraview-dev does not bring.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "geodesic-distance ${same_version}, paraview-dev, libopenmpi-dev${CPACK_GEODESIC_VTK_HEADERS}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "geodesic distance on triangle meshes, C++ headers
${what_it_is}
.
This package has the headers and the CMake package GeodesicDistance.")

# ---------------------------------------------------------------------------------- documentation
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME "geodesic-distance-doc")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SUGGESTS "geodesic-distance, mricron-data")
set(CPACK_DEBIAN_DOCUMENTATION_DESCRIPTION "geodesic distance on triangle meshes, documentation
${what_it_is}
.
This package has the API pages, examples in C++ and Python, and the gallery's
states for ParaView.")

# Debian's own files are made where CPack has put together those of the packages.
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/DebianFiles.cmake")

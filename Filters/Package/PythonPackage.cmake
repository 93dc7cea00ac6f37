# SPDX-License-Identifier: BSD-3-Clause

# The Python package geodesicdistance: from geodesicdistance import vtkGeodesicDistanceField
find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
set(geodesic_packages site-packages)
if (EXISTS "/etc/debian_version")
  set(geodesic_packages dist-packages)
endif ()
set(GEODESIC_PYTHON_DESTINATION
  "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/${geodesic_packages}" CACHE STRING
  "Where the Python package goes, relative to the installation prefix")
file(RELATIVE_PATH geodesic_python_to_lib
  "${CMAKE_INSTALL_PREFIX}/${GEODESIC_PYTHON_DESTINATION}/geodesicdistance"
  "${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}")

function (geodesic_wrap_python)
  if (NOT SKBUILD) # a wheel has no library of ours
    list(APPEND CMAKE_INSTALL_RPATH "${geodesic_origin}/${geodesic_python_to_lib}")
  endif ()
  vtk_module_wrap_python(
    MODULES             ${geodesic_modules}
    TARGET              GeodesicDistance::Python
    PYTHON_PACKAGE      geodesicdistance
    MODULE_DESTINATION  "${GEODESIC_PYTHON_DESTINATION}"
    CMAKE_DESTINATION   "${CMAKE_INSTALL_LIBDIR}/cmake/GeodesicDistance"
    INSTALL_HEADERS     OFF
    BUILD_STATIC        OFF)
endfunction ()
geodesic_wrap_python()

set(GEODESIC_PYTHONPATH "${CMAKE_BINARY_DIR}/${GEODESIC_PYTHON_DESTINATION}")
string(REPLACE ";" ", vtkmodules.vtk" geodesic_vtk_modules "vtkmodules.vtk${geodesic_vtk_components}")
if (ParaView_FOUND)
  set(geodesic_vtk_name "the VTK ${VTK_VERSION} in ParaView ${ParaView_VERSION}")
  set(geodesic_vtk_advice "install python3-paraview, or the geodesicdistance for plain VTK.")
else ()
  set(geodesic_vtk_name "VTK ${VTK_VERSION}")
  set(geodesic_vtk_advice "install python3-vtk9, or the geodesicdistance for ParaView.")
endif ()
if (SKBUILD)
  set(geodesic_vtk_advice "install that VTK, or build geodesicdistance again for the VTK that you have.")
endif ()
configure_file("${PROJECT_SOURCE_DIR}/Filters/Python/__init__.py.in"
  "${GEODESIC_PYTHONPATH}/geodesicdistance/__init__.py" @ONLY)
set(geodesic_python_files "${GEODESIC_PYTHONPATH}/geodesicdistance/__init__.py")
foreach (name IN ITEMS arrays functions inputs messages pairs pickling surface)
  set(file "${GEODESIC_PYTHONPATH}/geodesicdistance/${name}.py")
  configure_file("${PROJECT_SOURCE_DIR}/Filters/Python/${name}.py" "${file}" COPYONLY)
  list(APPEND geodesic_python_files "${file}")
endforeach ()
install(
  FILES       ${geodesic_python_files}
  DESTINATION "${GEODESIC_PYTHON_DESTINATION}/geodesicdistance"
  COMPONENT   python)
if (SKBUILD)
  return ()
endif ()
# Its folder, by the same name in the build tree with any Python.
file(CREATE_LINK "${GEODESIC_PYTHON_DESTINATION}" "${CMAKE_BINARY_DIR}/python"
  RESULT geodesic_no_link SYMBOLIC)
message(STATUS "Python package in the build tree: PYTHONPATH=${CMAKE_BINARY_DIR}/python")

# SPDX-License-Identifier: BSD-3-Clause

# Debian 13 installs the Python modules of ParaView as vtkCommonCore.cpython-313-x86_64-linux-gnu.so and
# the like, while ParaView's CMake files name them vtkCommonCore.so and stop where there is no such file.
# Nothing links these modules. A package leaves a file of targets out if all of its targets are there
# already: they are declared before the package is loaded, where a module is missing only.

# Declares the targets of Python modules in the file of targets, if it names modules that are missing.
function (geodesic_declare_python_targets targets_file prefix)
  string(REGEX REPLACE "\\.cmake$" "-*.cmake" locations_files "${targets_file}")
  file(GLOB locations_files "${locations_files}")
  set(missing OFF)
  foreach (locations_file IN LISTS locations_files)
    file(STRINGS "${locations_file}" locations REGEX "^ *IMPORTED_LOCATION_")
    foreach (location IN LISTS locations)
      string(REGEX REPLACE ".*\"\\\${_IMPORT_PREFIX}(.*)\".*" "\\1" location "${location}")
      if (NOT EXISTS "${prefix}${location}")
        set(missing ON)
      endif ()
    endforeach ()
  endforeach ()
  if (NOT missing)
    return ()
  endif ()
  message(VERBOSE "Leaving out the Python modules of ${targets_file}")
  file(STRINGS "${targets_file}" declarations REGEX "^add_library\\(.* IMPORTED\\)$")
  foreach (declaration IN LISTS declarations)
    string(REGEX REPLACE "add_library\\(([^ ]*) .*" "\\1" target "${declaration}")
    if (NOT TARGET "${target}")
      add_library("${target}" INTERFACE IMPORTED)
    endif ()
  endforeach ()
endfunction ()

# Declares them for the package, ParaView or VTK, whose CMake files lie in the folder.
function (geodesic_declare_python_modules folder package)
  string(TOLOWER "${package}" name)
  if (NOT EXISTS "${folder}/${name}-prefix.cmake")
    return ()
  endif ()
  include("${folder}/${name}-prefix.cmake")
  file(GLOB targets_files "${folder}/${package}Python*-targets.cmake")
  foreach (targets_file IN LISTS targets_files)
    geodesic_declare_python_targets("${targets_file}" "${_vtk_module_import_prefix}")
  endforeach ()
endfunction ()

# Declares them for the ParaView, with its VTK, that find_package(ParaView) will find.
function (geodesic_prepare_paraview)
  if (ParaView_DIR)
    set(folder "${ParaView_DIR}")
  else ()
    find_package(ParaView 1000000 QUIET CONFIG) # no such version: finds the folder, loads nothing
    unset(ParaView_DIR CACHE)
    list(APPEND ParaView_CONSIDERED_CONFIGS "") # an empty list has no first entry
    list(GET ParaView_CONSIDERED_CONFIGS 0 config)
    get_filename_component(folder "${config}" DIRECTORY)
  endif ()
  geodesic_declare_python_modules("${folder}" ParaView)
  geodesic_declare_python_modules("${folder}/vtk" VTK)
endfunction ()

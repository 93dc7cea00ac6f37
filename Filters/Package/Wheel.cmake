# SPDX-License-Identifier: BSD-3-Clause

# A wheel (pyproject.toml): the Python module with the filters in it, beside the package vtkmodules.

# VTK's libraries are in vtkmodules, or installed where the system finds them. A path to those that are
# linked here would name a folder that is gone after the build.
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH OFF)
set(CMAKE_INSTALL_RPATH "${geodesic_origin}/../vtkmodules")
if (APPLE)
  list(APPEND CMAKE_INSTALL_RPATH "${geodesic_origin}/../vtkmodules/.dylibs")
endif ()

# VTK's own wheels for Linux on x86-64 have the std::string of before C++11, which no CMake file of theirs
# tells. Whoever links them has to use it too.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_LIBRARIES VTK::CommonCore VTK::vtksys)
set(geodesic_uses_strings "#include <string>
  #include <vtksys/SystemTools.hxx>
  int main() { return static_cast<int>(vtksys::SystemTools::LowerCase(std::string(\"A\")).size()); }")
check_cxx_source_compiles("${geodesic_uses_strings}" GEODESIC_VTK_HAS_STRINGS_OF_CXX11)
if (NOT GEODESIC_VTK_HAS_STRINGS_OF_CXX11)
  set(CMAKE_REQUIRED_DEFINITIONS -D_GLIBCXX_USE_CXX11_ABI=0)
  check_cxx_source_compiles("${geodesic_uses_strings}" GEODESIC_VTK_HAS_STRINGS_OF_CXX98)
  if (GEODESIC_VTK_HAS_STRINGS_OF_CXX98)
    add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
  endif ()
endif ()
unset(CMAKE_REQUIRED_DEFINITIONS)
unset(CMAKE_REQUIRED_LIBRARIES)

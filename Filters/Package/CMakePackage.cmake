# SPDX-License-Identifier: BSD-3-Clause

# The CMake package: find_package(GeodesicDistance) gives VTK::FiltersGeodesic. It works from the
# build tree too.
include(CMakePackageConfigHelpers)

set(geodesic_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/GeodesicDistance")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/GeodesicDistanceConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/Module/${geodesic_package_dir}/GeodesicDistanceConfig.cmake"
  INSTALL_DESTINATION "${geodesic_package_dir}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/Module/${geodesic_package_dir}/GeodesicDistanceConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
file(COPY "${CMAKE_CURRENT_LIST_DIR}/PythonTargets.cmake"
  DESTINATION "${CMAKE_BINARY_DIR}/Module/${geodesic_package_dir}")
install(
  FILES
    "${CMAKE_CURRENT_LIST_DIR}/PythonTargets.cmake"
    "${CMAKE_BINARY_DIR}/Module/${geodesic_package_dir}/GeodesicDistanceConfig.cmake"
    "${CMAKE_BINARY_DIR}/Module/${geodesic_package_dir}/GeodesicDistanceConfigVersion.cmake"
  DESTINATION "${geodesic_package_dir}"
  COMPONENT   development)
install(
  FILES       "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/GeodesicDistance"
  COMPONENT   licenses)

# SPDX-License-Identifier: BSD-3-Clause

# Run by CPack when the files of the Debian packages lie in their folders, a folder a component:
# puts them where Debian wants them, and adds what only Debian has.
set(packages "${CPACK_TEMPORARY_DIRECTORY}")
set(docs "usr/share/doc")

# The dynamic linker finds the library in its folder; a path of our own is not needed.
file(GLOB_RECURSE libraries "${packages}/*.so" "${packages}/*.so.*")
foreach (library IN LISTS libraries)
  if (IS_SYMLINK "${library}")
    continue ()
  elseif (NOT CPACK_GEODESIC_HAS_PARAVIEW AND library MATCHES "/vtkFiltersGeodesic[^/]*$")
    file(RPATH_SET FILE "${library}" NEW_RPATH "$ORIGIN") # the library will be beside it
  else ()
    file(RPATH_REMOVE FILE "${library}")
  endif ()
  execute_process(COMMAND "${CPACK_GEODESIC_STRIP}" --strip-unneeded --remove-section=.comment "${library}")
endforeach ()

# Debian has one folder of modules for all versions of Python 3.
set(python "${packages}/python/usr")
if (NOT CPACK_GEODESIC_HAS_PARAVIEW)
  set(python "${packages}/module/usr")
endif ()
set(modules "${python}/lib/python3/dist-packages")
file(MAKE_DIRECTORY "${modules}")
file(RENAME "${python}/${CPACK_GEODESIC_PYTHON_DESTINATION}/geodesicdistance" "${modules}/geodesicdistance")
file(REMOVE_RECURSE "${python}/lib/python${CPACK_GEODESIC_PYTHON}")

# With plain VTK the library is for the module alone, and lies in its folder: the one of the plugin, which
# may be there as well, has the same name.
if (NOT CPACK_GEODESIC_HAS_PARAVIEW)
  file(GLOB libraries "${python}/${CPACK_GEODESIC_LIBDIR}/libvtkFiltersGeodesic.so.*")
  file(COPY ${libraries} DESTINATION "${modules}/geodesicdistance")
  file(REMOVE_RECURSE "${python}/${CPACK_GEODESIC_LIBDIR}")
endif ()

# A by-product of the plugin's build, of use to nobody who has the plugin.
file(GLOB archives "${packages}/development/usr/${CPACK_GEODESIC_LIBDIR}/*.a")
if (archives)
  file(REMOVE ${archives})
endif ()

# Debian's ParaView from 5.13 on has a folder for the plugins of other packages, which it offers in the Plugin
# Manager: a link leads from there to ours. ParaView 5.11 loads the plugin by plugin/postinst.in.
if (CPACK_GEODESIC_HAS_PARAVIEW AND CPACK_GEODESIC_OTHER_PLUGINS)
  set(offered "${packages}/application${CPACK_GEODESIC_OTHER_PLUGINS}")
  get_filename_component(folder "/usr/${CPACK_GEODESIC_PLUGINS_FILE}" DIRECTORY)
  file(RELATIVE_PATH target "${CPACK_GEODESIC_OTHER_PLUGINS}" "${folder}/GeodesicDistance/GeodesicDistance.so")
  file(MAKE_DIRECTORY "${offered}")
  file(CREATE_LINK "${target}" "${offered}/GeodesicDistance.so" SYMBOLIC)
endif ()

# The library is in the plugin's package: it is for the plugin, and for whoever builds with this version.
if (CPACK_GEODESIC_HAS_PARAVIEW)
  file(WRITE "${packages}/application/usr/share/lintian/overrides/geodesic-distance"
    "# The library comes with the plugin that needs it; geodesic-distance-dev depends on this very version.\n"
    "geodesic-distance: package-name-doesnt-match-sonames *\n")
endif ()

# Debian's index of documents.
if (CPACK_GEODESIC_HAS_PARAVIEW AND CPACK_GEODESIC_PAGES)
  file(WRITE "${packages}/documentation/usr/share/doc-base/geodesic-distance-doc.geodesic-distance"
"Document: geodesic-distance
Title: Geodesic Distance: classes and gallery
Abstract: Exact geodesic distance on triangle meshes for VTK and ParaView.
Section: Science/Mathematics

Format: HTML
Index: /${docs}/geodesic-distance/html/index.html
Files: /${docs}/geodesic-distance/html/*
")
  # The license is in the copyright file; pages link it by its name.
  file(REMOVE "${packages}/documentation/${docs}/geodesic-distance/LICENSE")
  file(CREATE_LINK ../geodesic-distance-doc/copyright "${packages}/documentation/${docs}/geodesic-distance/LICENSE"
    SYMBOLIC)
endif ()

# ------------------------------------------------------------------------- copyright and changelogs
file(READ "${CPACK_GEODESIC_SOURCE_DIR}/LICENSE" license)
string(STRIP "${license}" license)
string(REGEX REPLACE "^BSD 3-Clause License\n+" "" license "${license}")
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" holders "${license}")
set(holders "${CMAKE_MATCH_1}")
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license "${license}")
file(WRITE "${packages}/copyright"
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Geodesic Distance

Files: *
Copyright: 2026 ${holders}
License: BSD-3-Clause

License: BSD-3-Clause
 ${license}
")

# An entry for each version in the changelog.
file(STRINGS "${CPACK_GEODESIC_SOURCE_DIR}/CHANGELOG.md" versions REGEX "^## \\[[0-9.]+\\] - ")
file(REMOVE "${packages}/changelog.Debian")
foreach (version IN LISTS versions)
  string(REGEX MATCH "\\[([0-9.]+)\\] - ([0-9-]+)" version "${version}")
  set(number "${CMAKE_MATCH_1}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env LC_ALL=C date -u -R -d "${CMAKE_MATCH_2}"
    OUTPUT_VARIABLE date
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  file(APPEND "${packages}/changelog.Debian"
"geodesic-distance (${number}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Packages of version ${number}; changelog.gz says what has changed.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}

")
endforeach ()
configure_file("${CPACK_GEODESIC_SOURCE_DIR}/CHANGELOG.md" "${packages}/changelog" COPYONLY)

# -n: no time in the file, so that the same build gives the same bytes.
execute_process(
  COMMAND gzip -9nf changelog changelog.Debian
  WORKING_DIRECTORY "${packages}"
  RESULT_VARIABLE result)
if (result)
  message(FATAL_ERROR "gzip failed: ${result}")
endif ()
foreach (package IN LISTS CPACK_GEODESIC_PACKAGES)
  string(REPLACE ":" ";" package "${package}")
  list(GET package 0 component)
  list(GET package 1 name)
  file(COPY "${packages}/copyright" "${packages}/changelog.gz" "${packages}/changelog.Debian.gz"
    DESTINATION "${packages}/${component}/${docs}/${name}"
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endforeach ()

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Debian packages and tries them on a clean Debian of this release, as root and with a network:
#
#   bash Testing/package.sh            takes a quarter of an hour; leaves the packages in build-package/
#
# The packages for plain VTK, which excludes ParaView's, are tried on a Debian of their own. Both are folders
# made by debootstrap, with the sources of packages that this system has; they go in the end. Without root, or
# without a network, CTest's tests named package-deb-* use the packages from a folder that they are unpacked into.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
. "$top/Testing/clean_debian.sh"
build=$top/build-package
with_own_mounts "$@"

install_missing "${build_packages[@]}" doxygen dpkg-dev file lintian mricron-data \
  "${plain_vtk_packages[@]}"

# ------------------------------------------------------------------------------------- the packages
vtk=$(find_vtk "$build/vtk-$plain_vtk")
[ -n "$vtk" ] || give_up "Plain VTK could not be downloaded, and VTK_DIR is not set."
unset VTK_DIR

# Makes packages in a folder; further arguments go to CMake.
make_packages()
{
  local folder=$1
  shift
  printf '\n== Building the packages in %s ==\n' "$folder"
  cmake -S "$top" -B "$folder" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DGEODESIC_BUILD_TESTING=OFF -DGEODESIC_BUILD_BENCHMARKS=OFF "$@"
  cmake --build "$folder"
  rm -f "$folder"/*.deb "$folder"/*.tar.gz
  (cd "$folder" && cpack)
  lintian --allow-root --fail-on error,warning "$folder"/*.deb
}

make_packages "$build"
make_packages "$build/plain-vtk" "-DVTK_DIR=$vtk"

# ------------------------------------------------------------------------------------ a clean Debian
printf '\n== Making a clean Debian ==\n'
roots=$(mktemp -d "${TMPDIR:-/tmp}/geodesic-debian.XXXXXX")
trap 'remove_clean_debians "$roots"' EXIT
root=$roots/paraview
make_clean_debian "$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")" "$root"

# --------------------------------------------------------------------------- installed, and at work
mkdir "$root/packages" "$root/checks"
cp -r "$top"/Testing/Package/*.py "$top/Testing/Cxx/Consumer/Project" "$root/checks"
cp "$top/README.md" "$root" # four folders above the project, as far as there are any

cp -a "$root" "$roots/vtk"
cp "$build"/*.deb "$root/packages"
cp "$build"/plain-vtk/*.deb "$roots/vtk/packages"
mount_clean_debian "$root"
mount_clean_debian "$roots/vtk"

printf '\n== Installing the plugin, the Python module and the documentation ==\n'
on_clean_debian "$root" '
  apt-get update -qq
  cd /packages
  apt-get install -y -qq --no-install-recommends \
    ./geodesic-distance_*.deb ./python3-geodesicdistance_*.deb ./geodesic-distance-doc_*.deb > /install.log ||
    { tail -n 20 /install.log; exit 1; }
  cd /checks
  pvpython check_plugin.py /usr
  pvpython check_module.py /usr
  python3 check_module.py /usr
  python3 check_links.py /usr/share/doc/geodesic-distance
  [ -f /usr/share/doc/geodesic-distance/html/index.html ]'

printf '\n== Installing the C++ headers ==\n'
on_clean_debian "$root" '
  cd /packages
  apt-get install -y -qq --no-install-recommends ./geodesic-distance-dev_*.deb g++ make cmake > /install.log ||
    { tail -n 20 /install.log; exit 1; }
  cd /root
  cmake -S /checks/Project -B consumer
  cmake --build consumer
  consumer/consumer
  cmake -S /usr/share/doc/geodesic-distance/Examples -B example
  cmake --build example
  example/GeodesicDistance'

printf '\n== And taking them away again ==\n'
# shellcheck disable=SC2016 # expanded there
on_clean_debian "$root" '
  apt-get purge -y -qq geodesic-distance geodesic-distance-doc > /install.log
  left=$(find /usr /etc -name "*FiltersGeodesic*" -o -name "GeodesicDistance*" \
    -o -name "*geodesicdistance*" -o -name "geodesic-distance*" -o -path /usr/bin/paraview.conf)
  [ -z "$left" ] || { echo "Left behind: $left"; exit 1; }'

printf '\n== The Python module for plain VTK ==\n'
mkdir "$roots/vtk/other"
dpkg -x "$build"/python3-geodesicdistance_*.deb "$roots/vtk/other"
root=$roots/vtk
# shellcheck disable=SC2016 # expanded there
on_clean_debian "$root" '
  apt-get update -qq
  cd /packages
  apt-get install -y -qq --no-install-recommends ./*.deb > /install.log || { tail -n 20 /install.log; exit 1; }
  cd /checks
  python3 check_module.py /usr
  # The module for ParaView says that it is the wrong one.
  ! PYTHONPATH=/other/usr/lib/python3/dist-packages python3 -c "import geodesicdistance" 2> /message
  tail -n 1 /message | grep -F "ImportError: This geodesicdistance is made for the VTK"
  apt-get purge -y -qq python3-geodesicdistance-vtk9 > /install.log
  left=$(find /usr /etc -name "*FiltersGeodesic*" -o -name "*geodesicdistance*")
  [ -z "$left" ] || { echo "Left behind: $left"; exit 1; }'

printf '\nThe packages:\n'
ls "$build"/*.deb "$build"/*.tar.gz "$build"/plain-vtk/*.deb

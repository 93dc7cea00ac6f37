#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Debian packages and tries them on a clean Debian of this release, as root and with a network:
#
#   bash Testing/package.sh            takes a quarter of an hour; leaves the packages in build-package/
#
# The packages for plain VTK, which excludes ParaView's, are tried on a Debian of their own. Both are folders
# made by debootstrap, with the sources of packages that this system has; they go in the end. Without root, or without a network, CTest's tests named package-deb-*
# use the packages from a folder that they are unpacked into.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
build=$top/build-package

[ "$(id -u)" -eq 0 ] || give_up "Only root can make a clean Debian to install the packages on." \
  "Without root: bash Testing/run.sh -R package"

install_missing "${build_packages[@]}" doxygen dpkg-dev file lintian debootstrap mricron-data \
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
chmod 755 "$roots"
root=$roots/paraview

remove_roots()
{
  umount "$roots"/*/proc 2> /dev/null || true
  rm -rf --one-file-system "$roots"
}
trap remove_roots EXIT

# Those of this system's sources that are its release's, and its way through a proxy.
suite=$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")
# shellcheck disable=SC2016 # apt-get fills in the names
format='deb $(SITE) $(CODENAME) main'
sources=$(apt-get indextargets --format "$format" 'Created-By: Packages' 'Origin: Debian' |
  grep " $suite" | sort -u || true)
[ -n "$sources" ] || give_up "This system does not say where its packages come from: run apt-get update first."
mirror=$(awk -v suite="$suite" '$3 == suite { print $2; exit }' <<< "$sources")
debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" "$mirror" > "$root.log" ||
  give_up "debootstrap failed; the end of $root.log:" "$(tail -n 5 "$root.log")"
rm "$root.log"
printf '%s\n' "$sources" > "$root/etc/apt/sources.list"
{
  apt-config dump | grep -i '^Acquire::https\?::Proxy' || true
  echo 'Dpkg::Use-Pty "0";' # there are no terminals
} > "$root/etc/apt/apt.conf.d/90clean-debian"

# --------------------------------------------------------------------------- installed, and at work
mkdir "$root/packages" "$root/checks"
cp -r "$top"/Testing/Package/*.py "$top/Testing/Cxx/Consumer/Project" "$root/checks"
cp "$top/README.md" "$root" # four folders above the project, as far as there are any

# Nothing here has to survive a loss of power: dpkg need not wait for the disk.
echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
cp -a "$root" "$roots/vtk"
mount -t proc proc "$root/proc"
mount -t proc proc "$roots/vtk/proc"
cp "$build"/*.deb "$root/packages"
cp "$build"/plain-vtk/*.deb "$roots/vtk/packages"

# Runs a script on the clean Debian in $root.
on_clean_debian()
{
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    chroot "$root" bash -euc "$1"
}

printf '\n== Installing the plugin, the Python module and the documentation ==\n'
on_clean_debian '
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
on_clean_debian '
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
on_clean_debian '
  apt-get purge -y -qq geodesic-distance geodesic-distance-doc > /install.log
  left=$(find /usr /etc -name "*FiltersGeodesic*" -o -name "GeodesicDistance*" \
    -o -name "*geodesicdistance*" -o -name "geodesic-distance*" -o -name paraview.conf)
  [ -z "$left" ] || { echo "Left behind: $left"; exit 1; }'

printf '\n== The Python module for plain VTK ==\n'
mkdir "$roots/vtk/other"
dpkg -x "$build"/python3-geodesicdistance_*.deb "$roots/vtk/other"
root=$roots/vtk
# shellcheck disable=SC2016 # expanded there
on_clean_debian '
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

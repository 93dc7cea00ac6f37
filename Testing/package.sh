#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the Debian packages and tries them on a clean Debian 12, as root and with a network:
#
#   bash Testing/package.sh            takes some ten minutes; leaves the packages in build-package/
#
# The clean Debian is a folder made by debootstrap, with the sources of packages that this system has;
# the folder goes in the end. Without root, or without a network, CTest's tests named package-deb-*
# use the packages from a folder that they are unpacked into.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
build=$top/build-package

[ "$(id -u)" -eq 0 ] || give_up "Only root can make a clean Debian to install the packages on." \
  "Without root: bash Testing/run.sh -R package"

install_missing "${build_packages[@]}" doxygen dpkg-dev file lintian debootstrap

# ------------------------------------------------------------------------------------- the packages
printf '\n== Building the packages ==\n'
cmake -S "$top" -B "$build" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 -DCMAKE_INSTALL_PREFIX=/usr \
  -DGEODESIC_BUILD_TESTING=OFF -DGEODESIC_BUILD_BENCHMARKS=OFF
cmake --build "$build"
rm -f "$build"/*.deb "$build"/*.tar.gz
(cd "$build" && cpack)
lintian --allow-root --fail-on error "$build"/*.deb

# ------------------------------------------------------------------------------------ a clean Debian
printf '\n== Making a clean Debian ==\n'
root=$(mktemp -d "${TMPDIR:-/tmp}/geodesic-debian.XXXXXX")
chmod 755 "$root"

remove_root()
{
  umount "$root/proc" 2> /dev/null || true
  rm -rf --one-file-system "$root"
}
trap remove_root EXIT

# Those of this system's sources that are Debian 12's, and its way through a proxy.
# shellcheck disable=SC2016 # apt-get fills in the names
format='deb $(SITE) $(CODENAME) main'
sources=$(apt-get indextargets --format "$format" 'Created-By: Packages' 'Origin: Debian' |
  grep ' bookworm' | sort -u || true)
sources=${sources:-deb http://deb.debian.org/debian bookworm main}
mirror=$(awk '$3 == "bookworm" { print $2; exit }' <<< "$sources")
debootstrap --variant=minbase --include=ca-certificates bookworm "$root" "$mirror" > "$root.log" ||
  give_up "debootstrap failed; the end of $root.log:" "$(tail -n 5 "$root.log")"
rm "$root.log"
printf '%s\n' "$sources" > "$root/etc/apt/sources.list"
{
  apt-config dump | grep -i '^Acquire::https\?::Proxy' || true
  echo 'Dpkg::Use-Pty "0";' # there are no terminals
} > "$root/etc/apt/apt.conf.d/90clean-debian"
mount -t proc proc "$root/proc"

# --------------------------------------------------------------------------- installed, and at work
mkdir "$root/packages" "$root/checks"
cp "$build"/*.deb "$root/packages"
cp -r "$top"/Testing/Package/*.py "$top/Testing/Cxx/Consumer/Project" "$root/checks"
cp "$top/README.md" "$root" # four folders above the project, as far as there are any

# Nothing here has to survive a loss of power: dpkg need not wait for the disk.
echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io"

# Runs a script on the clean Debian.
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

printf '\nThe packages:\n'
ls "$build"/*.deb "$build"/*.tar.gz

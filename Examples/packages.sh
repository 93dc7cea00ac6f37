# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2034 # variables are for whoever sources it
# Debian packages, for the scripts that build this project (to be sourced).

# This release's number or, while it is in testing, its name.
release=$({ . /etc/os-release || true; } 2> /dev/null; printf '%s' "${VERSION_ID:-${VERSION_CODENAME:-}}")

# What a build with the plugin and a picture without a screen need, and ParaView's window for its icons.
build_packages=(g++ cmake ninja-build paraview paraview-dev python3-paraview python3-numpy
  libopenmpi-dev xvfb xauth libgl1-mesa-dri)
# The version of plain VTK where ParaView has a VTK of its own, and what building against it needs.
plain_vtk=
plain_vtk_packages=()
# What more tests can use on this release.
test_packages=()
case $release in
  12 | 24.04) # ParaView 5.11
    build_packages+=(qtbase5-dev qhelpgenerator-qt5 libqt5svg5)
    plain_vtk=9.1
    plain_vtk_packages+=(libvtk9.1 libtbb-dev)
    ;;
  13) # ParaView 5.13
    build_packages+=(qt6-base-dev qt6-svg-plugins python3-dev)
    plain_vtk=9.3
    plain_vtk_packages+=(libvtk9.3 libtbb-dev libjsoncpp-dev)
    test_packages+=(python3-pyvista python3-trimesh)
    ;;
  *) # ParaView 6, which uses Debian's VTK
    build_packages+=(qt6-base-dev qt6-svg-plugins qt6-documentation-tools python3-dev libvtk9-dev libjsoncpp-dev)
    test_packages+=(python3-pyvista python3-trimesh)
    ;;
esac

# Prints the message and ends the script.
give_up()
{
  printf '%s\n' "$@" >&2
  exit 1
}

# Prints those of the packages that are not installed.
missing_packages()
{
  local package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -qx installed ||
      printf '%s\n' "$package"
  done
}

# Installs those of the packages that are missing; ends the script where that cannot be done.
install_missing()
{
  if ! command -v dpkg-query > /dev/null; then
    echo "This is not a Debian system: taking what is installed (CMake says what is missing)." >&2
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0

  # --no-upgrade: with a newer libexpat1, ParaView 5.11 cannot read its own appended XML files.
  # --no-remove: plain VTK's Python package and ParaView's exclude each other; never take one away.
  local install=(apt-get install -y --no-upgrade --no-remove --no-install-recommends "${missing[@]}")
  local advice=("Missing packages: ${missing[*]}" "Install them as root with:"
    "  apt-get update && ${install[*]}")
  [ "$(id -u)" -eq 0 ] || give_up "${advice[@]}"

  echo "Installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq || echo "The package lists could not be updated; trying with those at hand." >&2
  "${install[@]}" || give_up "" "The installation failed (is there a network?)." "${advice[@]}"
}

# Prints the first folder that a pattern finds and that holds a VTK to build against.
vtk_below()
{
  local config
  for config in "$1"/usr/lib/*/cmake/vtk-9.*/vtk-config.cmake; do
    [ ! -f "$config" ] || dirname "$config"
  done | head -n 1
}

# Unpacks plain VTK for building below the given folder. It cannot be installed: its Python package and
# ParaView's exclude each other.
download_vtk()
{
  [ -n "$plain_vtk" ] || return
  mkdir -p "$1/packages"
  (cd "$1/packages" &&
    apt-get download libvtk9-dev "libvtk$plain_vtk" "libvtk$plain_vtk-qt" python3-vtk9 vtk9) || return
  local package
  for package in "$1"/packages/*.deb; do
    dpkg -x "$package" "$1"
  done
}

# Prints the folder of plain VTK: VTK_DIR, or the system's, or one unpacked below the given folder;
# nothing where there is none.
find_vtk()
{
  local vtk=${VTK_DIR:-$(vtk_below "")}
  vtk=${vtk:-$(vtk_below "$1")}
  if [ -z "$vtk" ] && download_vtk "$1" >&2; then
    vtk=$(vtk_below "$1")
  fi
  printf '%s' "$vtk"
}

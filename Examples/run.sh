#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the plugin and the example, and draws the geodesic distance to a curve on a surface:
#
#   bash Examples/run.sh                   on a surface and a curve that the example makes
#   bash Examples/run.sh SURFACE CURVE     on yours, in any format that ParaView reads
#
# Writes build/example/geodesic-distance.vtp and .png.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"

if [ $# -ne 0 ] && [ $# -ne 2 ]; then
  give_up "usage: bash Examples/run.sh [SURFACE CURVE]"
fi
for file in "$@"; do
  [ -r "$file" ] || give_up "There is no file $file."
done

install_missing "${build_packages[@]}"

build=$top/build
[ -f "$build/build.ninja" ] || [ -f "$build/Makefile" ] ||
  cmake -S "$top" -B "$build" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DGEODESIC_BUILD_TESTING=OFF -DGEODESIC_BUILD_BENCHMARKS=OFF
cmake --build "$build" --target GeodesicDistance GeodesicDistanceExample

output=$build/example
mkdir -p "$output"
if [ $# -eq 2 ]; then
  surface=$(realpath "$1")
  curve=$(realpath "$2")
else
  (cd "$output" && "$build/bin/GeodesicDistance")
  surface=$output/surface.vtp
  curve=$output/curve.vtp
fi
# Display numbers are searched from a random one on: those in use outside a chroot are not seen. A
# display that resets when its last client goes refuses the next one for a moment.
xvfb-run -n $((100 + RANDOM % 900)) -a -s "-screen 0 1280x1024x24 -noreset" \
  pvpython "$top/Examples/geodesic_distance.py" "$surface" "$curve" "$output/geodesic-distance"

printf '\nThe field:   %s\nIts picture: %s\n' "$output"/geodesic-distance.{vtp,png}

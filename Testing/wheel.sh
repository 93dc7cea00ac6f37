#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes a wheel of the Python package for the VTK that is installed, from a source distribution, installs it
# into a virtual environment and runs the package's tests and PyVista's page on it, in build-wheel/:
#
#   bash Testing/wheel.sh [ARGUMENTS]      arguments go to pip: -C cmake.define.VTK_DIR=FOLDER, ...
#
# As root for the first time (missing packages are installed). Where python3-paraview is installed, which
# excludes plain VTK's Python package, the wheel is for ParaView's VTK.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
case $release in
  12 | 24.04)
    echo "Skipped: this release has no scikit-build-core that makes the wheel (from 0.11 on; Debian 13 has it)."
    exit 77
    ;;
esac

needed=(python3-numpy python3-pyvista python3-trimesh xvfb xauth libgl1-mesa-dri)
options=(--no-build-isolation --no-deps)
if [ -z "$(missing_packages python3-paraview)" ]; then
  needed+=(g++ cmake ninja-build python3-dev python3-venv python3-scikit-build-core)
  options+=(-C cmake.define.GEODESIC_USE_PARAVIEW=ON)
else # the packages that the page names have to do
  read -ra named < <(sed -n 's/^apt-get install --no-remove //p' "$top/Examples/Python.md")
  needed+=("${named[@]}")
fi
install_missing "${needed[@]}"

folder=$top/build-wheel
rm -rf "$folder"
mkdir "$folder"
/usr/bin/python3 -m venv --system-site-packages "$folder/venv"
python=$folder/venv/bin/python

printf '\n== Building the wheel ==\n'
(cd "$top" && "$python" -c "import scikit_build_core.build as build; build.build_sdist('$folder')")
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)} \
  "$python" -m pip wheel "${options[@]}" "$@" --wheel-dir "$folder" "$folder"/*.tar.gz
"$python" "$top/Testing/Package/check_wheel.py" "$folder"/*.whl
"$python" -m pip install --no-deps --no-index "$folder"/*.whl

cd "$folder" # nothing of the source tree is found from here
for name in module functions inputs messages seam surface wrong_vtk; do
  printf '\n== test_%s.py ==\n' "$name"
  "$python" "$top/Testing/Python/test_$name.py"
done
printf '\n== Examples/Python.md ==\n'
"$python" "$top/Testing/Python/test_python_page.py" "$top/Examples" 0
xvfb-run -n $((100 + RANDOM % 900)) -a -s "-screen 0 1280x1024x24 -noreset" \
  "$python" "$top/Testing/Python/test_python_page.py" "$top/Examples" 1
printf '\nThe wheel passed: %s\n' "$(basename "$folder"/*.whl)"

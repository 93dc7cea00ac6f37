#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Whether the engine computes the same bits on ARM (aarch64), for which an emulator stands in, as on this processor;
# then its tests there, with two random meshes of each kind:
#
#   bash Testing/aarch64.sh [ARGUMENTS]   arguments go to CTest: -R NAME, -j N, ...
#
# Builds in build-testing/aarch64.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
build=$top/build-testing/aarch64
install_missing cmake ninja-build g++ g++-aarch64-linux-gnu qemu-user libgtest-dev googletest
emulator=(qemu-aarch64 -L /usr/aarch64-linux-gnu)

mkdir -p "$build"
cat > "$build/toolchain.cmake" << EOF
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR ${emulator[*]})
EOF
release=(-G Ninja -DCMAKE_BUILD_TYPE=Release)
cross=("${release[@]}" "-DCMAKE_TOOLCHAIN_FILE=$build/toolchain.cmake")

# The package of GoogleTest is for this processor, its sources are for all.
cmake -S /usr/src/googletest -B "$build/googletest" "${cross[@]}" -DBUILD_GMOCK=OFF "-DCMAKE_INSTALL_PREFIX=$build/prefix"
cmake --build "$build/googletest" --target install
cmake -S "$top" -B "$build/engine" "${cross[@]}" -DGEODESIC_CORE_ONLY=ON -DGEODESIC_FEW_MESHES=ON \
  "-DGTest_DIR=$build/prefix/lib/cmake/GTest"
cmake --build "$build/engine"
cmake -S "$top" -B "$build/here" "${release[@]}" -DGEODESIC_CORE_ONLY=ON
cmake --build "$build/here" --target geodesicBits

failed=0
"$build/here/bin/geodesicBits" > "$build/bits-here"
"${emulator[@]}" "$build/engine/bin/geodesicBits" > "$build/bits-aarch64"
if diff "$build/bits-here" "$build/bits-aarch64"; then
  echo "All bits are the same here and on aarch64."
else
  echo "Some bits differ here and on aarch64." >&2
  failed=1
fi
ctest --test-dir "$build/engine" --output-on-failure -j "$(nproc)" "$@" || failed=1
exit $failed

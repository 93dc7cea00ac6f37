#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Whether the engine computes the same bits on another platform as here; then its tests there, with two random
# meshes of each kind. Slow, and with the sources of GoogleTest from Debian's package:
#
#   bash Testing/platforms.sh PLATFORM [ARGUMENTS]   arguments go to CTest: -R NAME, -j N, ...
#
#   aarch64   GCC for ARM, by an emulator
#   windows   GCC and the C library of Windows, by Wine. Two tests fail there: Windows' cosines, which one compares
#             with, are wrong beside multiples of pi, and std::clock(), which another asks, counts idle time.
#   libcxx    Clang with its own standard library, which is that of macOS and here shuffles what it sorts: equal
#             items come in any order
#
# Builds in build-testing/PLATFORM.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
platform=${1:-}
emulator=()
case $platform in
  aarch64)
    packages=(g++-aarch64-linux-gnu qemu-user)
    emulator=(qemu-aarch64 -L /usr/aarch64-linux-gnu)
    toolchain="set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)"
    ;;
  windows)
    packages=(g++-mingw-w64-x86-64-posix wine64)
    emulator=(/usr/lib/wine/wine64)
    export WINEDEBUG=-all
    toolchain='set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)'
    ;;
  libcxx)
    packages=(clang libc++-dev libc++abi-dev)
    toolchain='set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_FLAGS_INIT "-stdlib=libc++ -D_LIBCPP_DEBUG_RANDOMIZE_UNSPECIFIED_STABILITY")'
    ;;
  *) give_up "usage: bash Testing/platforms.sh aarch64|windows|libcxx [ARGUMENTS]" ;;
esac
shift
install_missing cmake ninja-build g++ libgtest-dev googletest "${packages[@]}"

build=$top/build-testing/$platform
mkdir -p "$build"
printf '%s\n' "$toolchain" "set(CMAKE_CROSSCOMPILING_EMULATOR ${emulator[*]})" > "$build/toolchain.cmake"
release=(-G Ninja -DCMAKE_BUILD_TYPE=Release)
there=("${release[@]}" "-DCMAKE_TOOLCHAIN_FILE=$build/toolchain.cmake")

# The package of GoogleTest is for this platform, its sources are for all.
cmake -S /usr/src/googletest -B "$build/googletest" "${there[@]}" -DBUILD_GMOCK=OFF "-DCMAKE_INSTALL_PREFIX=$build/prefix"
cmake --build "$build/googletest" --target install
cmake -S "$top" -B "$build/engine" "${there[@]}" -DGEODESIC_CORE_ONLY=ON -DGEODESIC_FEW_MESHES=ON \
  "-DGTest_DIR=$build/prefix/lib/cmake/GTest"
cmake --build "$build/engine"
cmake -S "$top" -B "$build/here" "${release[@]}" -DGEODESIC_CORE_ONLY=ON
cmake --build "$build/here" --target geodesicBits

failed=0
"$build/here/bin/geodesicBits" > "$build/bits-here"
"${emulator[@]}" "$build/engine"/bin/geodesicBits* | tr -d '\r' > "$build/bits-$platform"
if diff "$build/bits-here" "$build/bits-$platform"; then
  echo "All bits are the same here and on $platform."
else
  echo "Some bits differ here and on $platform." >&2
  failed=1
fi
ctest --test-dir "$build/engine" --output-on-failure -j "$(nproc)" "$@" || failed=1
exit $failed

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds everything against ParaView and its VTK (engine, filter, plugin, Python, GUI) and runs the
# tests with CTest, in build, which Examples/run.sh uses, too:
#
#   bash Testing/run.sh [ARGUMENTS]         arguments go to CTest: -R NAME, -j N, ...
#   bash Testing/run.sh --all [ARGUMENTS]   these, four more builds in build-testing/, and a test debian-13:
#
#   sanitize    the engine's tests under AddressSanitizer and UndefinedBehaviorSanitizer, compiled for
#               processors with fused multiply-add where this is one
#   threads     those of the engine's tests that run on threads, under ThreadSanitizer
#   v3          the engine as somebody builds it who asks for fused multiply-add and fast math: the same
#               bits, and tests that fail where the compiler makes use of it
#   vtk         all compiled against plain VTK, without ParaView, and the filters' tests
#   debian-13   README's two commands on a clean Debian 13 (Testing/debian.sh), where this is another system
#
# In sanitize and vtk, which compile all but the plugin, warnings are errors.
#
# Plain VTK (Debian 12: 9.1, 13: 9.3) is taken from VTK_DIR where that is set, else from the system, else downloaded.
set -eu
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$top/Examples/packages.sh"
builds=$top/build-testing
all=
if [ "${1:-}" = --all ]; then
  all=yes
  shift
fi

install_missing "${build_packages[@]}" libgtest-dev openmpi-bin libglew-dev libgl-dev \
  libfreetype-dev libpng-dev libtiff-dev libjpeg-dev doxygen dpkg-dev file lintian mricron-data \
  "${test_packages[@]}" ${all:+"${plain_vtk_packages[@]}"}

# Configures and builds into a folder; its tests are CTest's.
suites=()
build()
{
  local folder=$1
  shift
  printf '\n== Building %s ==\n' "$(basename "$folder")"
  local generator=(-G Ninja)
  [ ! -f "$folder/CMakeCache.txt" ] || generator=() # somebody's own choice
  cmake -S "$top" -B "$folder" "${generator[@]}" -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
  cmake --build "$folder"
  suites+=("$folder")
}

# Adds a test to CTest that is skipped for a reason.
skip()
{
  printf '\n%s\n' "$2" >&2
  echo "add_test($1 sh -c \"echo 'Skipped: $2'; exit 77\")"
  echo "set_tests_properties($1 PROPERTIES SKIP_RETURN_CODE 77)"
}

strict=(-DGEODESIC_WARNINGS=ON -DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
mkdir -p "$builds"
vtk=
[ -z "$all" ] || vtk=$(find_vtk "$builds/vtk-$plain_vtk")
unset VTK_DIR

# Examples/run.sh switches these off.
build "$top/build" -UGEODESIC_BUILD_TESTING -UGEODESIC_BUILD_BENCHMARKS
v3=
if [ -n "$all" ] && echo | "${CXX:-c++}" -march=x86-64-v3 -x c++ -fsyntax-only - 2> /dev/null &&
  /lib64/ld-linux-x86-64.so.2 --help | grep -q 'x86-64-v3 (supported'; then
  v3=-march=x86-64-v3
fi
if [ -n "$all" ]; then
  # Half of a sanitizer's time is the compiler's: little optimization, and of debug information only
  # the lines that a report names. So little that GCC fuses nothing without -fexpensive-optimizations.
  sanitized=(-DGEODESIC_CORE_ONLY=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo
    "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1 -DNDEBUG")
  build "$builds/sanitize" "${sanitized[@]}" "${strict[@]}" -DGEODESIC_SANITIZE=address,undefined \
    "-DCMAKE_CXX_FLAGS=$v3 -fexpensive-optimizations"
  build "$builds/threads" "${sanitized[@]}" -DGEODESIC_SANITIZE=thread
fi
if [ -n "$v3" ]; then
  build "$builds/v3" -DGEODESIC_CORE_ONLY=ON "-DCMAKE_CXX_FLAGS=$v3 -ffast-math" \
    "-DGEODESIC_TEST_FILES=TestShortestPath|TestFacePropagation|TestTrigonometry"
fi
if [ -n "$vtk" ]; then
  # The first build tests the same engine, and measures.
  build "$builds/vtk" "${strict[@]}" -DVTK_DIR="$vtk" -DGEODESIC_TEST_CORE=OFF "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
fi

# One CTest run over all builds, so that its closing line speaks for all.
{
  printf 'subdirs("%s")\n' "${suites[@]}"
  if [ -n "$all" ] && [ "$release" != 13 ]; then
    # By itself, as its own tests use all processors.
    echo "add_test(debian-13 bash \"$top/Testing/debian.sh\" 13 first second)"
    echo "set_tests_properties(debian-13 PROPERTIES SKIP_RETURN_CODE 77 RUN_SERIAL ON TIMEOUT 3600)"
  fi
  if [ -n "$all" ] && [ -z "$vtk" ]; then
    skip plain-vtk-build "plain VTK could not be downloaded and VTK_DIR is not set: that build was not tested."
  fi
  if [ -n "$v3" ]; then
    echo 'add_test(same-bits-with-fused-multiply-add sh -c
      "../build/bin/geodesicBits > bits && v3/bin/geodesicBits > bits-v3 && diff bits bits-v3")'
  elif [ -n "$all" ]; then
    skip same-bits-with-fused-multiply-add "this processor or compiler has no x86-64-v3: that build was not tested."
  fi
} > "$builds/CTestTestfile.cmake"

# The same names come from more than one build: tell which numbers are whose.
printf '\n== Testing ==\n'
first=1
for suite in "${suites[@]}"; do
  count=$(ctest --test-dir "$suite" -N | sed -n 's/^Total Tests: //p')
  echo "$(basename "$suite"): tests $first to $((first + count - 1))"
  first=$((first + count))
done
log=$builds/Testing/Temporary/LastTest.log
rm -f "$log"
result=0
set -o pipefail
ctest --test-dir "$builds" --output-on-failure --timeout 300 -j "$(nproc)" "$@" | tee "$builds/ctest.log" || result=$?
# CTest does not print why tests were skipped. Its own words come last.
if grep -qs '^Skipped: ' "$log"; then
  printf '\n'
  grep '^Skipped: ' "$log" | sort -u
  printf '\n'
  sed -n '/^[0-9]*% tests passed/,$p' "$builds/ctest.log"
fi
exit $result

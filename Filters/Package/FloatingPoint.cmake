# SPDX-License-Identifier: BSD-3-Clause

# GCC and Clang make one instruction with one rounding of a * b + c where the processor has such (all ARM,
# -march=x86-64-v3), in one place of two that compute the same number. The engine compares such numbers,
# and error bounds here count two roundings: paths were wrong by it. MSVC does so only if asked to.
add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>")

# GCC 12 does so nevertheless where it vectorizes a * b - c beside a * b + c, and there it forgets the
# roundings of double(float(x)). GCC 14 does neither. The engine's hot path has vectors of its own.
add_compile_options(
  "$<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,14>>:-fno-tree-vectorize>")

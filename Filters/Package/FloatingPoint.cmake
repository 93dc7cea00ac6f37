# SPDX-License-Identifier: BSD-3-Clause

# The engine computes some numbers in two places and compares them, and its error bounds count roundings.
# So each operation is rounded by itself, as the source has it:
# - GCC and Clang make one instruction with one rounding of a * b + c where the processor has such (all
#   ARM, -march=x86-64-v3), in one place of two. Paths were wrong by it. MSVC did so before 19.30.
# - Fast math, which Intel's compiler has switched on unless told otherwise, changes the order of
#   operations. It is taken back where somebody's flags ask for it: these options come after those.
add_compile_options(
  "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-fno-fast-math;-ffp-contract=off>"
  "$<$<COMPILE_LANG_AND_ID:CXX,IntelLLVM>:-fp-model=precise;-ffp-contract=off>"
  "$<$<COMPILE_LANG_AND_ID:CXX,MSVC>:$<IF:$<VERSION_LESS:$<CXX_COMPILER_VERSION>,19.30>,/fp:strict,/fp:precise>>")

# GCC 12 fuses nevertheless where it vectorizes a * b - c beside a * b + c, and there it forgets the
# roundings of double(float(x)). GCC 14 does neither. The engine's hot path has vectors of its own.
add_compile_options(
  "$<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,14>>:-fno-tree-vectorize>")

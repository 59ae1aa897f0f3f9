#!/usr/bin/env bash
# The folder that the tool writes is a complete project. usage: standalone.sh CMAKE SYMPLANT PLANT CONFIGURE-ARGUMENT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cmake=$1 tool=$2 list=$3
shift 3

"$tool" generate "$list" -o "$work/plant" || fail "symplant generate"
"$cmake" -S "$work/plant" -B "$work/build" "$@" >"$work/configure.log" 2>&1 || fail "configuring" "$work/configure.log"
build "$cmake" "$work/build.log"
name=$(sed -n 's/^project(\([^ ]*\) .*/\1/p' "$work/plant/CMakeLists.txt")
"$work/build/$name" --until 1s --clock virtual >"$work/run.log" || fail "the plant does not run" "$work/run.log"
if grep "has no code" "$work/run.log"; then fail "a behavior has no code" "$work/run.log"; fi

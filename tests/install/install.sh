#!/usr/bin/env bash
# Installs a build to an empty folder and checks the installed files. usage: install.sh CMAKE BUILD PREFIX
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cmake=$1 build_dir=$2 prefix=$3

rm -rf "$prefix"
"$cmake" --install "$build_dir" --prefix "$prefix" >"$work/log" || fail "cmake --install" "$work/log"
"$prefix/bin/symplant" --version || fail "the installed tool does not run"
[[ -n $(find "$prefix" -name symplantConfig.cmake) ]] || fail "no package file"
[[ -n $(find "$prefix" -path '*/symplant/plant/plant.hpp') ]] || fail "no headers"
[[ -f $(find "$prefix" -path '*/symplant/program.h') ]] || fail "no interface of programs"
[[ -f $prefix/share/symplant/program/strucpp.cpp && -f $prefix/share/symplant/program/matiec.cpp ]] || fail "nothing for compilers"
[[ -n $(find "$prefix" -name LICENSE) ]] || fail "no licence"
[[ -f $prefix/share/man/man1/symplant.1 && -f $prefix/share/man/man1/symplant-run.1 ]] || fail "no manual pages"
(. "$prefix/share/bash-completion/completions/symplant" && complete -p symplant >/dev/null) || fail "no completion for bash"
[[ $(sed -n 1p "$prefix/share/zsh/site-functions/_symplant") == "#compdef symplant" ]] || fail "no completion for zsh"
if grep -rlF "$build_dir" "$prefix" --include='*.cmake' --include='*.hpp'; then fail "the package names the build's folder"; fi

# Shared parts of the tests of the package: a folder with a blank in its path, failures. To be sourced.
# shellcheck shell=bash

outer=$(mktemp -d)
work="$outer/work here"
mkdir "$work"
trap 'rm -rf "$outer"' EXIT

fail() { # WHAT [FILE]
  printf 'FAILED: %s\n' "$1"
  [[ -z ${2-} ]] || cat "$2"
  exit 1
}

build() { # CMAKE LOG: builds $work/build
  "$1" --build "$work/build" --parallel 2 >"$2" 2>&1 || fail "the build" "$2"
}

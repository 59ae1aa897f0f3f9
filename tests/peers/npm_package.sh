#!/usr/bin/env bash
# Fetches an npm package, without its optional parts, into a folder unless it is there already.
#
# usage: npm_package.sh FOLDER NAME@VERSION
#
# Exit code: 0 it is there, 2 usage, 77 it is not available (skipped by ctest): no npm, or no access to its registry.
set -u

(($# == 2)) || { echo "usage: $0 FOLDER NAME@VERSION" >&2; exit 2; }
folder=$1 package=$2
[[ ! -e $folder/node_modules/${package%@*} ]] || exit 0

command -v npm >/dev/null || { echo "npm is not installed, so $package cannot be fetched"; exit 77; }
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
if ! npm install --silent --no-audit --no-fund --ignore-scripts --omit=optional --prefix "$fresh" "$package" >"$fresh/log" 2>&1; then
  cat "$fresh/log"
  echo "the npm package $package cannot be fetched"
  exit 77
fi
mkdir -p "$folder" && mv "$fresh/node_modules" "$folder/"

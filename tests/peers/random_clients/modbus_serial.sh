#!/usr/bin/env bash
# Fetches npm's modbus-serial into a folder unless it is there already.
#
# usage: modbus_serial.sh FOLDER
#
# Exit code: 0 it is there, 2 usage, 77 it is not available (skipped by ctest): no npm, or no access to its registry.
set -u

(($# == 1)) || { echo "usage: $0 FOLDER" >&2; exit 2; }
folder=$1
package=modbus-serial@8.0.25 # 0.5 MB with its dependencies, without its part for serial lines
[[ ! -e $folder/node_modules/modbus-serial ]] || exit 0

command -v npm >/dev/null || { echo "npm is not installed, so $package cannot be fetched"; exit 77; }
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
if ! npm install --silent --no-audit --no-fund --ignore-scripts --omit=optional --prefix "$fresh" "$package" >"$fresh/log" 2>&1; then
  cat "$fresh/log"
  echo "the npm package $package cannot be fetched"
  exit 77
fi
mkdir -p "$folder" && mv "$fresh/node_modules" "$folder/"

#!/usr/bin/env bash
# Fetches the schema of SARIF 2.1.0 from an npm package unless it is there already.
#
# usage: sarif_schema.sh FILE
#
# Exit code: 0 FILE is there, 2 usage, 77 it is not available (skipped by ctest): no npm, or no access to its registry.
set -u

(($# == 1)) || { echo "usage: $0 FILE" >&2; exit 2; }
file=$1
package=@microsoft/sarif-multitool-linux@5.7.0 # 43 MB, of which one file is used
[[ ! -s $file ]] || exit 0

command -v npm >/dev/null || { echo "npm is not installed, so the schema of SARIF cannot be fetched: skipped"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if ! npm pack --silent --pack-destination "$folder" "$package" >"$folder/log" 2>&1; then
  cat "$folder/log"
  echo "the npm package $package cannot be fetched, so there is no schema of SARIF: skipped"
  exit 77
fi
tar -xzf "$folder"/*.tgz -C "$folder" package/sarif-2.1.0.json || exit 1
mv "$folder/package/sarif-2.1.0.json" "$file"

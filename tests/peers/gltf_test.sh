#!/usr/bin/env bash
# Checks GLB files by npm's gltf-validator, fetched into a folder: no error, warning, information or hint.
#
# usage: gltf_test.sh FOLDER NODE FILE...
#
# Exit code: 0 passed, 1 a file has a fault, 2 usage, 77 the package is not available (skipped by ctest)
set -u

(($# >= 3)) || { echo "usage: $0 FOLDER NODE FILE..." >&2; exit 2; }
folder=$1 node=$2
shift 2
here=$(dirname "${BASH_SOURCE[0]}")
"$here/npm_package.sh" "$folder" gltf-validator@2.0.0-dev.3.10 || exit $?
exec "$node" "$here/gltf_faults.mjs" "$folder" "$@"

#!/usr/bin/env bash
# Fetches playwright-core and axe-core into a folder, then runs a script of this folder with both.
#
# usage: in_browser.sh FOLDER NODE SCRIPT [ARGUMENTS]
#
# Exit code: that of the script; 77 a package or chromium is not available (skipped by ctest)
set -u

(($# >= 3)) || { echo "usage: $0 FOLDER NODE SCRIPT [ARGUMENTS]" >&2; exit 2; }
folder=$1 node=$2 script=$3
shift 3
here=$(dirname "${BASH_SOURCE[0]}")
"$here/../npm_package.sh" "$folder/playwright-core" playwright-core@1.65.1 || exit $?
"$here/../npm_package.sh" "$folder/axe-core" axe-core@4.14.1 || exit $?
exec "$node" "$script" "$folder/playwright-core" "$folder/axe-core" "$@"

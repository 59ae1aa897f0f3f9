#!/usr/bin/env bash
# Makes a release, which other tests use. usage: release.sh SOURCE FOLDER
# Needs Debian 12, on which releases are made; elsewhere it is skipped (77).
set -euo pipefail
source=$1 folder=$2

[[ $(. /etc/os-release && echo "$ID $VERSION_ID") == "debian 12" ]] || { echo "skipped: a release is made on Debian 12"; exit 77; }
rm -rf "$folder"
"$source/scripts/release" -o "$folder"
cd "$folder"
sha256sum --check SHA256SUMS

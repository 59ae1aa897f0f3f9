#!/usr/bin/env bash
# Two releases of the same sources, made in two folders, have the same bytes. usage: reproducible.sh SOURCE
# Needs Debian 12, on which releases are made; elsewhere it is skipped (77).
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
source=$1

[[ $(. /etc/os-release && echo "$ID $VERSION_ID") == "debian 12" ]] || { echo "skipped: a release is made on Debian 12"; exit 77; }

copy() { # FOLDER
  mkdir -p "$1"
  tar -C "$source" --exclude=./build --exclude=./.git -c . | tar -C "$1" -x --no-same-owner
}

release() { # FOLDER LOG: with this shell's environment
  SOURCE_DATE_EPOCH=1700000000 "$1/scripts/release" -o "$1/out" >"$2" 2>&1 || fail "scripts/release in $1" "$2"
}

copy "$work/a"
copy "$outer/another-folder/deeper/b"
release "$work/a" "$work/a.log"
(
  umask 077
  export TZ=Asia/Tokyo LANG=C.UTF-8 HOME=$outer
  release "$outer/another-folder/deeper/b" "$work/b.log"
)
cat "$work/a/out/SHA256SUMS"
(($(wc -l <"$work/a/out/SHA256SUMS") >= 4)) || fail "a release of too few files"
cd "$work/a/out"
for file in *; do
  cmp "$file" "$outer/another-folder/deeper/b/out/$file" || fail "two builds differ: $file"
done

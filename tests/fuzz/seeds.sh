#!/usr/bin/env bash
# Makes the corpus of a fuzz target: goldens and examples, files of corpus/TARGET, lines of corpus/TARGET.txt,
# lines of hex digits of corpus/TARGET.hex.
# seeds.sh TARGET FOLDER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
target=$1 folder=$2
rm -rf -- "$folder"
mkdir -p "$folder"

copy() { # NUMBERS...: each file under a separate number
  local file number=0
  for file; do
    [[ ! -s $file ]] || cp -- "$file" "$folder/$(printf 'file%03d' "$number")"
    number=$((number + 1))
  done
}

shopt -s nullglob
case $target in
  list) copy "$root"/tests/golden/{check,read}/*/*.{csv,tsv,sdf,asc,cxt,xml,xsy,xlsx,st,L5K,L5X,TcGVL} "$root"/examples/{excell,cylinder,two-plcs,gallery/*}/*.csv \
    "$here"/corpus/list/* ;;
  plant_json) copy "$root"/tests/golden/check/*/plant.json "$root"/examples/{,gallery/}*/plant.json \
    "$here"/corpus/plant_json/* ;;
  http) copy "$here"/corpus/http/* ;;
  recording) copy "$here"/corpus/recording/* ;;
esac
if [[ -e $here/corpus/$target.txt ]]; then
  number=0
  while IFS= read -r line; do
    printf '%s' "$line" >"$folder/$(printf 'line%03d' "$number")"
    number=$((number + 1))
  done <"$here/corpus/$target.txt"
fi
if [[ -e $here/corpus/$target.hex ]]; then
  number=0
  while IFS= read -r line; do
    printf '%b' "$(sed 's/../\\x&/g' <<<"$line")" >"$folder/$(printf 'hex%03d' "$number")"
    number=$((number + 1))
  done <"$here/corpus/$target.hex"
fi

#!/usr/bin/env bash
# Runs a fuzz target on its corpus, and on all inputs that once broke something: replay.sh PROGRAM TARGET FOLDER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$1 target=$2 folder=$3/$2

"$here/seeds.sh" "$target" "$folder"
files=("$folder"/*)
[[ ! -d $here/crashes/$target ]] || files+=("$here/crashes/$target"/*)
((${#files[@]} >= 10)) || {
  echo "only ${#files[@]} inputs: the corpus is missing"
  exit 1
}
"$program" "${files[@]}" 2>&1 | tail -n 40

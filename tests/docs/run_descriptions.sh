#!/usr/bin/env bash
# Runs every plant description of a page, and compares the output of its commands with the page.
#
# A ```jsonc block after a line `<!-- plant.json of FOLDER -->` is a plant description for the symbols.csv of that
# folder; one that does not begin with `{` is a part of one, and is completed. A ```jsonc block after a line
# `<!-- NAME.json next to it -->` is a file in the folder of the plant.json above it. A ```text block after a line
# `<!-- COMMAND: exit N -->` is the output of this command for the plant.json above it, and N its exit code; a last
# line `...` matches any further output.
# A description without such a block must pass `symplant check`.
#
#   run_descriptions.sh SYMPLANT SOURCE_DIR PAGE
set -euo pipefail
symplant=$1 source_dir=$2 page=$3

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
ln -s "$symplant" "$work/bin/symplant"
PATH="$work/bin:$PATH"

# NNN/plant.part, NNN/folder; NNN/MMM.command, NNN/MMM.exit, NNN/MMM.text
awk -v work="$work" '
  /^<!-- plant\.json of .* -->$/ { folder = $4; next }
  /^<!-- [a-z]*\.json next to it -->$/ { neighbor = $2; next }
  /^```jsonc$/ && neighbor != "" { target = here "/" neighbor; neighbor = ""; printf "" > target; next }
  /^<!-- symplant .*: exit [0-9] -->$/ {
    command = $0
    sub(/^<!-- /, "", command); code = command; sub(/: exit [0-9] -->$/, "", command); sub(/^.*: exit /, "", code); sub(/ -->$/, "", code)
    next
  }
  /^```jsonc$/ && folder != "" {
    here = sprintf("%s/%03d", work, ++plants); system("mkdir " here)
    print folder > (here "/folder"); target = here "/plant.part"; folder = ""; printf "" > target; next
  }
  /^```text$/ && command != "" {
    what = sprintf("%s/%03d", here, ++commands)
    print command > (what ".command"); print code > (what ".exit"); target = what ".text"; command = ""; printf "" > target; next
  }
  /^```/ { target = ""; next }
  target != "" { print > target }
' "$source_dir/$page"

count=0 commands=0
for here in "$work"/[0-9]*/; do
  [ -e "$here/folder" ] || { echo "$page holds no description: has its form changed?"; exit 1; }
  cp "$source_dir/$(cat "$here/folder")/symbols.csv" "$here"
  # Its first line that is not a comment decides.
  if grep -v '^ *//' "$here/plant.part" | sed -n 1p | grep '^{' >/dev/null; then
    cp "$here/plant.part" "$here/plant.json"
  else
    { printf '{ "symplant": 1, "symbols": ["symbols.csv"],\n'; cat "$here/plant.part"; printf '}\n'; } >"$here/plant.json"
  fi
  count=$((count + 1))
  cd "$here"
  if ! ls ./*.command >/dev/null 2>&1; then
    symplant check plant.json >output 2>&1 || { cat plant.json output; echo "$page: this description has faults"; exit 1; }
    continue
  fi
  for command in ./*.command; do
    commands=$((commands + 1))
    status=0
    bash -c "$(cat "$command")" >output 2>&1 </dev/null || status=$?
    expected=${command%.command}.text
    if [ "$(tail -1 "$expected")" = ... ]; then
      sed -i '$d' "$expected"
      head -n "$(wc -l <"$expected")" output >cut && mv cut output
    fi
    if [ "$status" != "$(cat "${command%.command}.exit")" ] || ! diff "$expected" output; then
      cat plant.json
      echo "$page: \`$(cat "$command")\` prints otherwise, or ends with $status"
      exit 1
    fi
  done
done
echo "$page: $count descriptions, $commands commands"

#!/usr/bin/env bash
# The description of docs/material.md is that of the machining cell, its pictures are what the tool draws, and the page
# has the command for each of them;
# SYMPLANT_UPDATE_GOLDENS=1 draws them again. usage: material_page.sh SYMPLANT PROJECT
set -euo pipefail
tool=$1 project=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
while read -r example location; do
  command="symplant model $example --device $location --format svg -o ${location,,}.svg"
  grep -qxF "$command" "$project/docs/material.md" || { echo "docs/material.md lacks: $command"; exit 1; }
  picture=$project/docs/pictures/material-${location,,}.svg
  "$tool" model "$project/$example" --device "$location" --format svg -o "$work/picture.svg" 2>"$work/messages"
  if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then cp "$work/picture.svg" "$picture"; fi
  cmp "$work/picture.svg" "$picture"
done <<'PICTURES'
examples/gallery/machining/plant.json LINE
examples/gallery/machining/plant.json FIXTURE
examples/sorting/plant.json BELT
PICTURES

# The block on the page, indented as in the file, followed by the comma that it has there.
page_block() { sed -n '/^<!-- material of/,/^```$/p' "$project/docs/material.md" | sed '1,2d;$d' | sed 's/^/  /; $s/$/,/'; }
page_block >"$work/page"
sed -n '/^  "material": {$/,/^  },$/p' "$project/examples/gallery/machining/plant.json" | cmp - "$work/page"

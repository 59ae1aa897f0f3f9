#!/usr/bin/env bash
# The description of docs/material.md is that of the machining cell, and its pictures are what the tool draws;
# SYMPLANT_UPDATE_GOLDENS=1 draws them again. usage: material_page.sh SYMPLANT PROJECT
set -euo pipefail
tool=$1 project=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
plant=$project/examples/gallery/machining/plant.json
for location in LINE FIXTURE; do
  picture=$project/docs/pictures/material-${location,,}.svg
  "$tool" model "$plant" --device "$location" --format svg -o "$work/picture.svg" 2>"$work/messages"
  if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then cp "$work/picture.svg" "$picture"; fi
  cmp "$work/picture.svg" "$picture"
done

# The block on the page, indented as in the file, followed by the comma that it has there.
page_block() { sed -n '/^<!-- material of/,/^```$/p' "$project/docs/material.md" | sed '1,2d;$d' | sed 's/^/  /; $s/$/,/'; }
page_block >"$work/page"
sed -n '/^  "material": {$/,/^  },$/p' "$plant" | cmp - "$work/page"

#!/usr/bin/env bash
# The description of docs/malfunctions.md is that of the gallery. usage: malfunctions_page.sh PROJECT
set -euo pipefail
project=$1
# The block on the page, indented as in the file, followed by the comma that it has there.
page_block() { sed -n '/^<!-- malfunctions of/,/^```$/p' "$project/docs/malfunctions.md" | sed '1,2d;$d' | sed 's/^/  /; $s/$/,/'; }
diff <(sed -n '/^  "malfunctions": \[$/,/^  \],$/p' "$project/examples/gallery/malfunctions/plant.json") <(page_block)

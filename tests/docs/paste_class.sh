#!/usr/bin/env bash
# The class in docs/generated-code.md is the generated one. With SYMPLANT_UPDATE_GOLDENS set, it is pasted there.
# usage: paste_class.sh SYMPLANT ROOT
set -euo pipefail
tool=$1 page=$2/docs/generated-code.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$tool" generate "$2/examples/excell/excell.csv" -o "$work/out" >"$work/log"
awk '/^\/\/\/ AGV:/ { on = 1 } on { print } on && /^};/ { exit }' "$work/out/types_gen.hpp" >"$work/class"
[[ -s $work/class ]] || { echo "the generated types have no class AGV"; exit 1; }
awk -v class="$work/class" '
  /^<!-- end of the class -->/ { skip = 0 }
  !skip { print }
  /^<!-- the class AGV of/ {
    print "```cpp"
    while ((getline line < class) > 0) print line
    print "```"
    skip = 1
  }' "$page" >"$work/page"
if cmp -s "$work/page" "$page"; then exit 0; fi
if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then
  cp "$work/page" "$page"
else
  diff "$page" "$work/page"
fi

#!/usr/bin/env bash
# Every relative link of the manual refers to an existing file.
#
#   check_links.sh SOURCE_DIR
set -euo pipefail
cd "$1"
bad=0 count=0
while IFS=: read -r page link; do
  target=${link#*](}
  target=${target%%)*}
  target=${target%%#*}
  case $target in '' | http*) continue ;; esac
  count=$((count + 1))
  if [ ! -e "$(dirname "$page")/$target" ]; then
    echo "$page: \`$target\` is not there"
    bad=1
  fi
done < <(grep -oE '\]\([^) ]+\)' ./*.md docs/*.md docs/decisions/*.md templates/*.md examples/*/README.md | sed 's/^\.\///')
echo "$count links"
if [ "$count" -eq 0 ]; then
  echo "no link was found: has the form of the pages changed?"
  bad=1
fi
exit $bad

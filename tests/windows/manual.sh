#!/usr/bin/env bash
# The commands of docs/windows.md work, as a user types them in the unpacked folder. usage: manual.sh SOURCE LINUX-TOOL WINDOWS-TOOL,
# which is in this folder.
set -euo pipefail
source=$(realpath "$1") folder=$(dirname "$(realpath "$3")")

command -v wine >/dev/null || { echo "skipped: Wine is not installed"; exit 77; }
work=$(mktemp -d)
trap 'WINEPREFIX="$work/wine" wineserver -k >/dev/null 2>&1 || true; rm -rf "$work"' EXIT
export WINEPREFIX="$work/wine" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml="
cp -r "$folder" "$work/unpacked here"
cd "$work/unpacked here"

count=0
while IFS= read -r command; do
  echo "> $command"
  wine cmd /c "$command" </dev/null >out 2>&1 || { cat out; echo "FAILED: $command"; exit 1; }
  count=$((count + 1))
done < <(sed -n '/^```bat$/,/^```$/p' "$source/docs/windows.md" | grep -v '^```')
((count > 0)) || { echo "FAILED: no commands in docs/windows.md"; exit 1; }

for made in model.html trace.jsonl plant/CMakeLists.txt; do [[ -s $made ]] || { echo "FAILED: no $made"; exit 1; }; done
if grep -c $'\r' trace.jsonl; then echo "FAILED: line ends of Windows in a trace"; exit 1; fi
grep -q $'\r' README.txt || { echo "FAILED: README.txt has no line ends of Windows"; exit 1; }
echo "$count commands work"

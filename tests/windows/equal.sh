#!/usr/bin/env bash
# The tool for Windows does the same as the one for Linux: both run each command, and every output must be equal, byte
# by byte: standard output, messages, exit code, files. usage: equal.sh SOURCE LINUX-TOOL WINDOWS-TOOL [CASE-PATTERN]
# Needs Wine (wine64) and the compiler of mingw-w64. SYMPLANT_CORPUS: a folder of real symbol lists, which are read, too.
set -euo pipefail
source=$(realpath "$1") linux=$(realpath "$2") windows=$(realpath "$3") pattern=${4-}

command -v wine >/dev/null || { echo "skipped: Wine is not installed"; exit 77; }
work=$(mktemp -d)
trap 'WINEPREFIX="$work/wine" wineserver -k >/dev/null 2>&1 || true; rm -rf "$work"' EXIT
export WINEPREFIX="$work/wine" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml=" NO_COLOR=1 TZ=UTC
mkdir "$work/data" "$work/linux" "$work/windows"
cp -r "$source/examples" "$source/tests/golden" "$work/data"
if [[ -n ${SYMPLANT_CORPUS-} ]]; then cp -r "$SYMPLANT_CORPUS" "$work/data/corpus"; fi
wine "$windows" --version >/dev/null

commands=0 failed=()

run_in() { # FOLDER TOOL...: ARGUMENTS of the case, from a fresh copy of nothing but links to the data
  local folder=$1
  shift
  mkdir -p "$folder/files"
  (
    cd "$folder/files"
    ln -s "$work/data"/* .
    set +e
    "$@" >../out 2>../err </dev/null
    echo "$?" >../code
    find . -maxdepth 1 -type l -delete
  )
}

# same ARGUMENT...: one command. Files that it makes have names below out/.
same() {
  [[ -z $pattern || "$*" == *$pattern* ]] || return 0
  commands=$((commands + 1))
  rm -rf "$work/linux/"* "$work/windows/"*
  run_in "$work/linux" "$linux" "$@"
  run_in "$work/windows" wine "$windows" "${@//.so/.dll}"
  sed -i 's/\.dll\b/.so/g' "$work/windows/out" "$work/windows/err"
  if ! diff -r "$work/linux" "$work/windows" >"$work/difference" 2>&1; then
    failed+=("symplant $*")
    printf 'DIFFERENT: symplant %s\n' "$*"
    head -c 2000 "$work/difference"
  fi
}

for list in data/golden/read/*/* data/golden/check/*/* data/corpus/*/* data/corpus/*; do
  [[ -f $work/$list ]] || continue
  list=${list#data/}
  case $list in *.md | *.txt.expected | *.sh) continue ;; esac
  same check "$list"
  same check "$list" --format json
done

for rule in $("$linux" rules | awk '/^SP/ { print $1 }'); do same explain "$rule"; done
for shell in bash zsh; do same completion "$shell"; done
same rules --format json
same --help
for name in plant scenario naming model suite; do same schema "$name"; done
for command in $("$linux" --help | sed -n 's/^  \([a-z]*\) .*/\1/p'); do same "$command" --help; done

plants=(examples/excell/excell.csv)
for plant in "$work"/data/examples/*/plant.json "$work"/data/examples/gallery/*/plant.json; do plants+=("${plant#"$work/data/"}"); done
for plant in "${plants[@]}"; do
  for format in text json sarif github gitlab junit html; do same check "$plant" --format "$format" --output out/check; done
  for format in table json dot mermaid scxml html; do same model "$plant" --format "$format" -o out/model; done
  for format in table csv json st openplc codesys; do same map "$plant" --format "$format"; done
  same map "$plant" --link modbus-tcp-server://127.0.0.1:5020
  same generate "$plant" -o out/generated
  same run "$plant" --until 20s --trace out/trace.jsonl --vcd out/run.vcd --findings out/findings.json --save out/snapshot
done

for scenario in "$work"/data/examples/*/*.json "$work"/data/examples/gallery/*/*.json; do
  grep -q '"symplant-scenario"' "$scenario" || continue
  folder=$(dirname "${scenario#"$work/data/"}")
  plant=$folder/plant.json
  [[ -e $work/data/$plant ]] || plant=$(cd "$work/data" && ls "$folder"/*.csv)
  same run "$plant" --scenario "${scenario#"$work/data/"}" --trace out/trace.jsonl --vcd out/run.vcd --findings out/findings.json --junit out/junit.xml
done

printf '%d commands, %d of them different\n' "$commands" "${#failed[@]}"
((commands > 0 && ${#failed[@]} == 0))

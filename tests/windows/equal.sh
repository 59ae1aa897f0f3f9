#!/usr/bin/env bash
# The tool for Windows does the same as the one for Linux: both run each command, and every output must be equal, byte
# by byte: standard output, messages, exit code, files. usage: equal.sh SOURCE LINUX-TOOL WINDOWS-TOOL [CASE-PATTERN]
# Needs Wine (wine64) and the compiler of mingw-w64. SYMPLANT_CORPUS: a folder of real symbol lists, which are read, too.
set -euo pipefail
# shellcheck source=tests/windows/both.bash
. "$(dirname "${BASH_SOURCE[0]}")/both.bash"

if [[ -n ${SYMPLANT_CORPUS-} ]]; then cp -r "$SYMPLANT_CORPUS" "$work/data/corpus"; fi

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
  [[ $plant != */two-plcs/* ]] || continue # its links need real time, whose figures differ
  same run "$plant" --until 20s --trace out/trace.jsonl --vcd out/run.vcd --findings out/findings.json --save out/snapshot
done

for scenario in "$work"/data/examples/*/*.json "$work"/data/examples/gallery/*/*.json; do
  grep -q '"symplant-scenario"' "$scenario" || continue
  folder=$(dirname "${scenario#"$work/data/"}")
  plant=$folder/plant.json
  [[ -e $work/data/$plant ]] || plant=$(cd "$work/data" && ls "$folder"/*.csv)
  same run "$plant" --scenario "${scenario#"$work/data/"}" --trace out/trace.jsonl --vcd out/run.vcd --findings out/findings.json --junit out/junit.xml
done

summary

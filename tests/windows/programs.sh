#!/usr/bin/env bash
# PLC programs as DLLs, suites, campaigns, recordings and the commands that write files: the tool for Windows does the same
# as the one for Linux, byte by byte. A program that crashes or does not return is reported.
# usage: programs.sh SOURCE LINUX-TOOL WINDOWS-TOOL [CASE-PATTERN]
# Needs Wine (wine64), cc and the compiler of mingw-w64.
set -euo pipefail
# shellcheck source=tests/windows/both.bash
. "$(dirname "${BASH_SOURCE[0]}")/both.bash"

mkdir -p "$work/include/symplant" "$work/data/programs" "$work/data/recorded"
cp "$source/runtime/program.h" "$work/include/symplant"

program() { # FILE NAME [OPTION]...: compiles it for both systems
  local file=$1 name=$work/data/programs/$2
  shift 2
  cc -std=c99 -O2 -shared -fPIC -I "$work/include" "$@" "$file" -o "$name.so"
  x86_64-w64-mingw32-gcc -std=c99 -O2 -shared -static -I "$work/include" "$@" "$file" -o "$name.dll"
}

for file in "$source"/examples/*/program/*.c; do program "$file" "$(basename "$file" .c)"; done
program "$source/examples/excell/program/cell.c" slow -DWORK_MS=1500
program "$source/examples/drill-station/program/drill.c" holes -DHOLES

in_lock_step() { # PLANT NAME
  same program --check "programs/$2.so" "$1"
  same run "$1" --program "programs/$2.so" --until 30s --trace out/trace.jsonl --vcd out/run.vcd --findings out/findings.json --junit out/junit.xml
}
in_lock_step examples/excell/excell.csv cell
for pair in body-shop:line drill-station:drill drive:drive harbour-crane:crane oven:oven sorting:sorting; do
  in_lock_step "examples/${pair%:*}/plant.json" "${pair#*:}"
done
same run examples/excell/excell.csv --program programs/none.so
same program --check programs/drill.so examples/excell/excell.csv

same test examples/excell/suite --program programs/cell.so --junit out/junit.xml --html out/page.html --jobs 1 -o out/results.jsonl
same test examples/excell/suite --program programs/slow.so --junit out/junit.xml --html out/page.html --plants normal,fast
same test examples/excell/suite --program programs/cell.so --jobs 1 --shard 1/2 -o out/part.jsonl

# Proposed cases are written into the suite: each tool has a copy of it.
cp -r "$work/data/examples/excell" "$work/new-linux"
cp -r "$work/data/examples/excell" "$work/new-windows"
propose=(test --new suite --base cycles --most 5 --program)
(cd "$work/new-linux" && "$linux" "${propose[@]}" "$work/data/programs/cell.so" >out 2>&1) || true
(cd "$work/new-windows" && wine "$windows" "${propose[@]}" "$work/data/programs/cell.dll" >out 2>&1) || true
commands=$((commands + 1))
diff -r "$work/new-linux" "$work/new-windows" >"$work/difference" || different "${propose[*]}" "$work/difference"

same campaign examples/drill-station/plant.json --base examples/drill-station/two-parts.json --program programs/holes.so --csv out/faults.csv \
  --html out/page.html --junit out/junit.xml --jobs 1 -o out/results.jsonl

record() { # NAME ARGUMENT...: a trace for the commands below
  (cd "$work/data" && "$linux" run "${@:2}" --trace "recorded/$1.jsonl" --vcd "recorded/$1.vcd" --save "recorded/$1.snapshot") >/dev/null 2>&1 || true
}
record good examples/excell/excell.csv --scenario examples/excell/figure6.json
record cell examples/cell/plant.json --until 20s
for name in cell slow; do
  (cd "$work/data" && "$linux" run examples/excell/excell.csv --program "programs/$name.so" --until 60s --trace "recorded/$name-program.jsonl") >/dev/null
done
for format in text json junit html; do
  same compare recorded/cell-program.jsonl recorded/slow-program.jsonl --align follow --format "$format" -o out/compared
done
same compare recorded/good.jsonl recorded/good.vcd --html out/page.html
same compare recorded/cell-program.jsonl --plant examples/excell/excell.csv
for format in text json html; do same learn examples/excell/excell.csv recorded/cell-program.jsonl -o out/learned.json --format "$format"; done
same learn examples/excell/excell.csv recorded/cell-program.jsonl recorded/slow-program.jsonl --links out/links.json
same watch examples/excell/excell.csv recorded/slow-program.jsonl --findings out/findings.json --junit out/junit.xml
same run examples/excell/excell.csv --replay recorded/cell-program.jsonl --trace out/again.jsonl
same run examples/cell/plant.json --resume recorded/cell.snapshot --until 30s --trace out/trace.jsonl

for list in examples/excell/excell.csv examples/tia/PLCTags.xlsx; do
  for to in csv st plcopen tia-xlsx gx-iec; do same convert "$list" out/list --to "$to" --renamed out/renamed.json; done
done
for dialect in codesys twincat openplc; do same convert examples/excell/excell.csv out/list.st --dialect "$dialect"; done
same infer examples/naming/side-line.csv -o out/naming.json
same init examples/excell/excell.csv -o out/plant.json
for format in text json markdown; do same diff examples/excell/excell.csv examples/cell/symbols.csv --format "$format" -o out/diff; done
same explain --symbol EXLINE_MB_MC_O_RUN2 examples/excell/excell.csv
for name in $("$linux" naming | awk '{ print $1 }'); do same naming "$name" -o out/rule.json; done
same naming --words
same man -o out/pages
same doctor examples/cell/plant.json --link modbus-tcp://127.0.0.1:1 --for 1s

# A program that goes wrong: Windows has other words for it.
wrong() { # NAME STATEMENT WORDS TOOL-ARGUMENT...: a program with the statement in scan 100
  sed "s|  switch (cell->phase) {|  if (now_ns >= 1000000000) {\n    volatile int zero = 0;\n    int *volatile null = NULL;\n    $2;\n  }\n&|" \
    "$source/examples/excell/program/cell.c" >"$work/$1.c"
  x86_64-w64-mingw32-gcc -std=c99 -O0 -shared -static -w -I "$work/include" "$work/$1.c" -o "$work/data/$1.dll"
  windows_does 3 "program \`cell\` $3" "${@:4}" --program "$1.dll"
}
wrong null "*null = 1" "ended by an access violation in scan 100 (1 s)" run examples/excell/excell.csv --until 5s
wrong zero "zero = 7 / zero" "ended by a division by zero in scan 100 (1 s)" run examples/excell/excell.csv --until 5s
wrong exit "return 7" "failed with 7 in scan 100 (1 s)" run examples/excell/excell.csv --until 5s
wrong endless "for (;;) ++zero" "does not return in scan 100 (1 s) after 10 s" test examples/excell/suite

summary

#!/usr/bin/env bash
# The accuracy study of the harbour crane: recordings of a finer model, each compared with the run of the plant. The tables of
# docs/accuracy.md are its results; SYMPLANT_UPDATE_GOLDENS=1 writes them. A plant with a mistake is less accurate.
# usage: accuracy.sh FOLDER SYMPLANT FINER PROGRAM PAGE
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
folder=$1 tool=$2 finer=$3 program=$4 page=$5
positions=(--only '*_I_HEIGHT' --only '*_I_ANGLE' --only '*_I_RADIUS')
switches=(--only '*BRAKE_I_*' --only '*POWER_I_*')

# total RECORDING PLANT OPTION...: "n least mean greatest" of the last row of the table.
total() {
  local recording=$1 plant=$2 code=0
  shift 2
  "$tool" compare "$recording" --plant "$plant" "$@" >"$work/compared" 2>"$work/err" || code=$?
  ((code < 2)) || fail "compare $recording ends with $code" >&2
  awk '$1 == "total" { print $2, $3, $5, $7; found = 1 } END { exit !found }' "$work/compared" || fail "no total of $recording" >&2
}

# changed NAME SED: a plant.json with a mistake.
changed() {
  mkdir -p "$work/$1"
  cp "$folder/symbols.csv" "$work/$1/"
  sed "$2" "$folder/plant.json" >"$work/$1/plant.json"
  ! cmp -s "$folder/plant.json" "$work/$1/plant.json" || fail "$1: nothing is changed"
}

tests() {
  local name every least mean greatest count switched itself row
  printf '| test | read every | movements | least | total | greatest | brakes and power: total | the plant itself: total |\n'
  printf '|---|---|---|---|---|---|---|---|\n'
  for name in six heavy storm shift; do
    for every in 35 50; do
      "$finer" "$work/$name.jsonl" $every >"$work/$name.$every.jsonl"
      "$finer" "$work/$name.jsonl" $every --same >"$work/same.jsonl"
      row=$(total "$work/$name.$every.jsonl" "$folder/plant.json" "${positions[@]}")
      read -r count least mean greatest <<<"$row"
      row=$(total "$work/$name.$every.jsonl" "$folder/plant.json" "${switches[@]}")
      read -r _ _ switched _ <<<"$row"
      row=$(total "$work/same.jsonl" "$folder/plant.json" "${positions[@]}")
      read -r _ _ itself _ <<<"$row"
      printf '| %s | %d ms | %d | %s %% | %s %% | %s %% | %s %% | %s %% |\n' \
        "$name" "$every" "$count" "$least" "$mean" "$greatest" "$switched" "$itself"
    done
  done
}

mistakes() {
  local mistake plant what least mean greatest count switched row
  printf '| plant | least | total | greatest | brakes and power: total |\n|---|---|---|---|---|\n'
  for mistake in "right|as it is" "hoist|the hoist is 10 %% slower" "brakes|brakes open in 900 ms, not in 300" \
    "steps|no ramps and lags: speeds jump" "still|the crane does not slew"; do
    IFS='|' read -r plant what <<<"$mistake"
    row=$(total "$work/six.35.jsonl" "$work/$plant/plant.json" "${positions[@]}")
    read -r count least mean greatest <<<"$row"
    row=$(total "$work/six.35.jsonl" "$work/$plant/plant.json" "${switches[@]}")
    read -r _ _ switched _ <<<"$row"
    ((count == 6)) || fail "$plant: $count movements"
    printf "| $what | %s %% | %s %% | %s %% | %s %% |\n" "$least" "$mean" "$greatest" "$switched"
    echo "$plant $least $mean $switched" >>"$work/accuracies"
  done
}

# picture RECORDING: the height of the hook while the first load is lifted, from the chart of both.
picture() {
  "$tool" compare "$1" --plant "$folder/plant.json" --only '*_I_HEIGHT' --format html -o "$work/page.html" >"$work/out" || true
  local side
  for side in expected actual; do
    grep -o "\"$side\":\[[^]]*\]" "$work/page.html" | sed -n 1p | tr -c '0-9.\n' ' ' | tr -s ' ' '\n' | sed '/^$/d' | paste - - >"$work/$side"
  done
  awk -f "$(dirname "${BASH_SOURCE[0]}")/accuracy.awk" "$work/expected" "$work/actual"
}

# pasted NAME FILE: the table of the page between the marks is the file.
pasted() {
  local mark="<!-- table of $1 -->"
  if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then
    awk -v mark="$mark" -v file="$2" '
      $0 == mark { print; print ""; while ((getline line < file) > 0) print line; skip = 1; next }
      skip && /^$/ && ++blank == 2 { skip = 0; blank = 0 }
      !skip { print }' "$page" >"$work/page"
    cp "$work/page" "$page"
  fi
  awk -v mark="$mark" '$0 == mark { on = 1; next } on && /^\|/ { print; next } on && NF { exit }' "$page" >"$work/pasted"
  diff "$work/pasted" "$2" >"$work/difference" || fail "the table of $1 in ${page##*/} is out of date: regenerate it with SYMPLANT_UPDATE_GOLDENS=1"
}

for name in six heavy storm shift; do
  "$tool" run "$folder/plant.json" --program "$program" --scenario "$folder/suite/$name.json" --trace "$work/$name.jsonl" \
    >"$work/$name.log" 2>&1 || fail "$name does not pass"
done
tests >"$work/tests.md"
cp -r "$folder" "$work/right"
changed hoist 's/1\.5 \* PORT_C1_HOIST_O_SPEED/1.35 * PORT_C1_HOIST_O_SPEED/'
changed brakes 's/"takes": "300ms", "when"/"takes": "900ms", "when"/'
changed steps 's/"ramp": \(".*"\), "up": [0-9]*/"is": \1/; s/"lag": \("[a-z.]*"\), "time": "[0-9]*ms"/"is": \1/'
changed still 's/"slew.angle": { "unit": "deg", "integral": "slew.speed" }/"slew.angle": { "unit": "deg", "integral": "0 * slew.speed" }/'
mistakes >"$work/mistakes.md"
# Each mistake shows: slower movements in their least accuracy, slow brakes in theirs.
awk '{ least[$1] = $2; brakes[$1] = $4 }
  END { exit !(least["hoist"] < least["right"] - 2 && brakes["brakes"] < brakes["right"] - 20 && least["still"] < 60) }' \
  "$work/accuracies" || fail "a plant with a mistake is as accurate: $(cat "$work/accuracies")"
if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then picture "$work/heavy.50.jsonl" >"${page%/*}/pictures/accuracy.svg"; fi
pasted tests "$work/tests.md"
pasted mistakes "$work/mistakes.md"

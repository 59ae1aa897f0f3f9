#!/bin/sh
# Measures plants with many values in virtual time, run by `symplant run` and compiled, as multiples of real time:
#   tests/bench/values.sh BUILD
# BUILD is the build folder of the preset release or bench. A tenth of the values is of each of ten kinds; those that
# are active change in every step of 10 ms. A run is measured to 120 s, when no other one changes any more, and to a later
# time; the difference counts, best of three.
set -eu
build=$(cd "${1:?usage: values.sh BUILD}" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# plant VALUES ACTIVE
plant() {
  rm -rf "$folder/plant"
  mkdir "$folder/plant"
  awk -v values="$1" -v active="$2" -v folder="$folder/plant" 'BEGIN {
    list = folder "/list.csv"; json = folder "/plant.json"
    print "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment,Comment-Lang" > list
    for (i = 0; i < 10; ++i) {
      print "VAR_GLOBAL,L_P_V" i "_O_ON,,%QX" i ",BOOL,FALSE,," > list
      print "VAR_GLOBAL,L_P_V" i "_I_ON,,%IX" i ",BOOL,FALSE,," > list
    }
    print "{\"symplant\": 1, \"name\": \"bench\", \"symbols\": [\"list.csv\"], \"values\": {" > json
    for (i = 0; i < values; ++i) {
      own = "v" i; from = i % 10 ? "v" i - 1 : "v" i + 9; on = i < active
      if (i % 10 == 0 || i % 10 == 9) e = "\"integral\": \"" (on ? "sin(time + " i ")" : "0") " - 0.1 * " own "\", \"min\": -1000, \"max\": 1000"
      if (i % 10 == 1) e = "\"lag\": \"20 + 3 * " from "\", \"time\": \"2s\""
      if (i % 10 == 2) e = "\"ramp\": \"2 * " from "\", \"up\": 5, \"down\": 3"
      if (i % 10 == 3 || i % 10 == 8) e = "\"is\": \"if(" from " > 0, 2 * " from " + 1, " from ") * L_P_V" i % 10 ".ON + " from "\""
      if (i % 10 == 4) e = "\"derivative\": \"" from "\""
      if (i % 10 == 5) e = "\"delay\": \"" from "\", \"time\": \"1s\""
      if (i % 10 == 6) e = "\"pid\": {\"of\": \"" from "\", \"to\": \"" (on ? "5" : from) "\", \"kp\": 2, \"ti\": \"10s\"}, \"min\": -100, \"max\": 100"
      if (i % 10 == 7) e = on ? "\"noise\": 0.1, \"every\": \"10ms\"" : "\"is\": \"2\""
      print "\"" own "\": {" e "}" (i + 1 < values ? "," : "}}") > json
    }
  }'
}

# The user seconds of a command for SPAN seconds of the plant after 120.
seconds() { # SPAN COMMAND
  span=$1
  shift
  for run in 1 2 3; do
    for until in 120 $((120 + span)); do
      /usr/bin/time -o "$folder/time" -f '%U' "$@" --until ${until}s > "$folder/out" 2> "$folder/err" || {
        cat "$folder/err" >&2
        exit 1
      }
      tail -n 1 "$folder/time"
    done | awk '{ last = now; now = $1 } END { print now - last }'
  done | sort -n | sed -n 1p
}

row() { # VALUES ACTIVE NAME SPAN SECONDS
  awk -v values="$1" -v active="$2" -v name="$3" -v span="$4" -v s="$5" \
    'BEGIN { printf "| %d | %d | %s | %d | %.1f |\n", values, active, name, span / s, s * 1e7 / (span * active) }'
}

printf '| values | active | | times real time | ns for a step of an active value |\n|---|---|---|---|---|\n'
for sizes in "100 100" "1000 1000" "10000 100" "10000 10000"; do
  set -- $sizes
  plant "$1" "$2"
  span=$((1000000 / $2))
  row "$1" "$2" "symplant run" $span "$(seconds $span "$build/symplant" run "$folder/plant/plant.json")"
  [ "$1" = 1000 ] || continue
  "$build/symplant" generate "$folder/plant/plant.json" -o "$folder/generated" > "$folder/out"
  cmake --install "$build" --prefix "$folder/installed" > "$folder/out"
  cmake -S "$folder/generated" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed" > "$folder/out"
  cmake --build "$folder/build" > "$folder/out"
  row "$1" "$2" compiled $span "$(seconds $span "$folder/build/bench")"
done

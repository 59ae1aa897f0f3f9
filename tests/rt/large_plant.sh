# A plant of two controllers with equal addresses, for the tests that keep it moving. To be sourced.
# shellcheck shell=bash

# DEVICES double solenoids per controller, PLC1 and PLC2, with travels of 800 ms: FOLDER/plant.json and two lists.
write_large_plant() { # FOLDER DEVICES
  local folder=$1 devices=$2 plc
  for plc in 1 2; do
    awk -v plc="$plc" -v devices="$devices" 'BEGIN {
      print "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial"
      for (d = 0; d < devices; ++d) {
        split("O I", direction, " "); split("Y X", mit, " "); split("Q I", iec, " ")
        for (i = 1; i <= 2; ++i) for (end = 0; end < 2; ++end)
          printf "VAR_GLOBAL,LINE%d_ST%d_DEV%d_%s_%s,%s%X,%%%sX%d,BOOL,FALSE\n", plc, 1 + d / 20, d, direction[i], \
            end ? "RET2" : "ADV1", mit[i], 2 * d + end, iec[i], 2 * d + end
      }
    }' >"$folder/plc$plc.csv"
  done
  cat >"$folder/plant.json" <<'JSON'
{
  "symplant": 1,
  "symbols": [ { "file": "plc1.csv", "controller": "PLC1" }, { "file": "plc2.csv", "controller": "PLC2" } ],
  "defaults": { "travel": "800ms" }
}
JSON
}

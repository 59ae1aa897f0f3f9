#!/usr/bin/env bash
# A campaign tests a PLC at a link: in real time, one fault after another.
# usage: campaign_link.sh SYMPLANT CONTROLLER LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
symplant=$1 program=$2 list=$3

free_port 30000
link=modbus-tcp-server://127.0.0.1:$port
cat >"$work/base.json" <<'END'
{ "symplant-scenario": 1, "steps": [ { "wait": "EXLINE_MB_MC.RUN2", "within": "20s" }, { "wait": "EXLINE_MB_AGV.P1", "within": "20s" } ] }
END
cat >"$work/faults.json" <<'END'
[ { "name": "jam", "of": "EXLINE_MB_AGV", "stuck": true }, { "name": "nothing", "force": { "EXLINE_MB_AGV_I_P1": "hold" }, "lasts": "1ms" } ]
END

code=0
"$symplant" campaign "$list" --base "$work/base.json" --link "$link" --limit 3s --faults "$work/faults.json" >"$work/alone" 2>&1 || code=$?
((code == 1)) || fail "exit code $code without a PLC"
grep -q 'does not pass, so no fault is tried' "$work/alone" || fail "a base case without a PLC is not reported"

# The PLC begins again as soon as the plant of a run has gone.
(while :; do "$program" "127.0.0.1:$port" --connect-timeout 5000 --step-timeout 60000 || true; done) >"$work/controller.log" 2>&1 &
controller=$!
"$symplant" campaign "$list" --base "$work/base.json" --link "$link" --window 2s --faults "$work/faults.json" --csv "$work/link.csv" \
  >"$work/link" 2>&1 || fail "the campaign fails with the PLC"
grep -q '^EXLINE_MB_AGV,,jam,from the start,0,stopped,' "$work/link.csv" || fail "a vehicle that does not move does not stop the cell"
# On a busy machine the PLC may begin later than in the base case by more than the window: it then reads something else.
grep -qE '^EXLINE_MB_AGV_I_P1,,nothing,from the start,0,(no effect|undetected),' "$work/link.csv" || fail "a fault that does nothing has an effect"
grep -q -- "--link $link .*--until .* --fault jam" "$work/link.csv" || fail "the command does not name the link"

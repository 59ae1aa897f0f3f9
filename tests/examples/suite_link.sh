#!/usr/bin/env bash
# A suite tests a PLC at a link: one case after another, each after the scenario `before`; without a PLC there is no result.
# usage: suite_link.sh SYMPLANT CONTROLLER LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
symplant=$1 program=$2 list=$3

free_port 20000
link=modbus-tcp-server://127.0.0.1:$port

mkdir -p "$work/suite/setup"
cat >"$work/suite/suite.json" <<END
{ "symplant-suite": 1, "plant": "$list", "align": "follow", "window": "500ms", "before": "setup/home.json" }
END
echo '{ "symplant-scenario": 1, "steps": [ { "at": "1s" }, { "wait": "EXLINE_MB_AGV.P1 and EXLINE_MB_MC.IDLE1", "within": "20s" } ] }' \
  >"$work/suite/setup/home.json"
echo '{ "symplant-scenario": 1, "steps": [ { "wait": "EXLINE_MB_MC.RUN2", "within": "20s" } ] }' >"$work/suite/arrives.json"
echo '{ "symplant-scenario": 1, "steps": [ { "wait": "EXLINE_MB_MC.RUN2", "within": "20s" }, { "wait": "EXLINE_MB_AGV.P1", "within": "20s" } ] }' \
  >"$work/suite/returns.json"

code=0
"$symplant" test "$work/suite" --link "$link" >"$work/alone" 2>&1 || code=$?
((code == 1)) || fail "exit code $code without a PLC"
grep -q 'setup/home.json` has failed, so that the case cannot begin' "$work/alone" || fail "a failed \`before\` is not reported"
grep -q '^2 cases: 0 passed, 0 failed, 2 errors' "$work/alone" || fail "a case has a result without a PLC"

# It begins again as soon as the plant of a case has gone.
(while :; do "$program" "127.0.0.1:$port" --connect-timeout 5000 --step-timeout 60000 || true; done) >"$work/controller.log" 2>&1 &
controller=$!
"$symplant" test "$work/suite" --link "$link" --update >"$work/update" 2>&1 || fail "the cases fail with the PLC"
grep -q '2 reference traces written' "$work/update" || fail "no reference traces"
"$symplant" test "$work/suite" --link "$link" --junit "$work/report.xml" >"$work/again" 2>&1 || fail "the PLC does not do the same again"
grep -q '^2 cases: 2 passed, 0 failed$' "$work/again" || fail "not two cases passed"
sed -i '/MC_O_RUN2/d' "$work/suite/arrives.reference.jsonl"
code=0
"$symplant" test "$work/suite" --link "$link" >"$work/differs" 2>&1 || code=$?
((code == 1)) || fail "exit code $code with another reference trace"
grep -q 'EXLINE_MB_MC_O_RUN2` unexpected: on' "$work/differs" || fail "the difference is not reported"

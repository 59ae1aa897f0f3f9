#!/usr/bin/env bash
# The timeline of a trace, line by line; with clashing names, values, and too few cycles. usage: timeline.sh TIMELINE
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
timeline=$1

cat >"$work/trace.jsonl" <<'TRACE'
{"symplant-trace":1,"plant":"p","model_hash":"0","seed":0}
{"t":0,"symbol":"L_A_CYL_I_RET","value":true}
{"t":500000000,"symbol":"L_A_CYL_I_RET","value":false}
{"t":500000000,"symbol":"L_A_CYL_O_ADV","value":true}
{"t":1500000000,"symbol":"L_A_CYL_I_ADV","value":true}
{"t":2000000000,"symbol":"L_A_CYL_I_ADV","value":false}
{"t":2000000000,"symbol":"L_A_CYL_O_ADV","value":false}
{"t":2000000000,"symbol":"SPARE","value":true}
{"t":3000000000,"symbol":"L_A_CYL_I_RET","value":true}
{"t":3000000000,"symbol":"L_B_CYL_I_POS","value":-17}
TRACE
cat >"$work/expected.txt" <<'TEXT'
    0.00 s  plant sets    L_A_CYL_I_RET  L_A_CYL is in RET
    0.50 s  PLC   sets    L_A_CYL_O_ADV  L_A_CYL: RET -> ADV
    0.50 s  plant clears  L_A_CYL_I_RET  L_A_CYL leaves RET
    1.50 s  plant sets    L_A_CYL_I_ADV  L_A_CYL is in ADV
    2.00 s  PLC   clears  L_A_CYL_O_ADV  L_A_CYL: command ADV ends
    2.00 s  plant clears  L_A_CYL_I_ADV  L_A_CYL leaves ADV
    2.00 s  ?     sets    SPARE
    3.00 s  plant sets    L_A_CYL_I_RET  L_A_CYL is in RET
    3.00 s  plant writes  L_B_CYL_I_POS  L_B_CYL POS = -17
0 cycles completed, 9 changes of symbols
TEXT
awk -f "$timeline" "$work/trace.jsonl" >"$work/seen.txt" || fail "no cycle is needed, and it is not content"
diff "$work/expected.txt" "$work/seen.txt" || fail "the timeline differs"

grep -v -e POS -e SPARE "$work/trace.jsonl" >"$work/one_cycle.jsonl"
awk -v need=1 -f "$timeline" "$work/one_cycle.jsonl" >"$work/seen.txt" || fail "one cycle is not counted"
grep -qx '    3.00 s  cycle 1 completed, in 2.50 s' "$work/seen.txt" || fail "the cycle's time"
grep -qx '    0.50 s  PLC   sets    L_A_CYL_O_ADV  CYL: RET -> ADV' "$work/seen.txt" || fail "a device by its short name"
if awk -v need=2 -f "$timeline" "$work/one_cycle.jsonl" >/dev/null; then fail "two cycles are seen in one"; fi

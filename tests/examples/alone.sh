#!/usr/bin/env bash
# The cell without a controller, listening, in real time: nothing happens after time 0. usage: alone.sh PLANT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

start_plant "$@" --until 4s
wait "$plant" || fail "the plant ended with exit code $?"
plant=""

(($(ended_at) >= 4000)) || fail "it ended too soon"
(($(count '"t":0,') == 2)) || fail "at time 0 two devices report their states"
later=$(grep '"t":' "$work/trace.jsonl" | grep -v '"t":0,' || true)
[[ -z $later ]] || fail "something moved by itself: $later"

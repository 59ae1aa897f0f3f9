#!/usr/bin/env bash
# The panel and its Python client: the client drives the cell. usage: panel_client.sh CLIENT PLANT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
client=$1
shift
command -v python3 >/dev/null || exit 77

link_of_panel() { link=$(sed -n 's/^panel: //p' "$work/plant.log") && [[ -n $link ]]; }

"$@" --panel 127.0.0.1:0 --trace "$work/trace.jsonl" >"$work/plant.log" 2>&1 &
plant=$!
wait_until "the plant prints the link of the panel" link_of_panel
python3 "$client" "$link" >"$work/client.log" 2>&1 || fail "the client ended with exit code $?"
stop_plant

[[ $(sed -n 1p "$work/client.log") == "the vehicle is in P2 after 1.0 s" ]] || fail "the vehicle did not arrive"
grep -q 'forced' <(sed -n 2p "$work/client.log") || fail "the reason is not the force"
[[ $(tail -n 1 "$work/client.log") == "restored: True" ]] || fail "the snapshot was not restored"
(($(count '"act":{"force":') == 1)) || fail "the trace does not have the act"
(($(count '"restored":"before the fault"') == 1)) || fail "the trace does not have the restore"

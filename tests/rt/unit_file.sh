#!/usr/bin/env bash
# systemd takes the example unit without a word. usage: unit_file.sh UNIT
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
command -v systemd-analyze >/dev/null || skip "systemd-analyze is not installed"
# The program need not be installed here, so another that is there stands in its place.
sed "s,^ExecStart=[^ ]*,ExecStart=/bin/true," "$1" >"$work/${1##*/}"
grep -q '^ExecStart=/bin/true ' "$work/${1##*/}" || fail "the unit starts nothing"
systemd-analyze verify --man=no --recursive-errors=no "$work/${1##*/}" >"$work/said" 2>&1 || fail "systemd refuses the unit"
[[ ! -s $work/said ]] || fail "systemd has something to say"

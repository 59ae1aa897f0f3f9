#!/usr/bin/env bash
# The installed manual pages have no fault that groff or mandoc finds. usage: man_pages.sh PREFIX
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
prefix=$1
command -v groff >/dev/null || { echo "groff is not installed: skipped"; exit 77; }

faults_of() { # PAGE
  groff -man -ww -Tascii "$1" 2>&1 >/dev/null
  # mandoc wants a date, which pages of the same version do not have.
  ! command -v mandoc >/dev/null || mandoc -T lint -W warning "$1" | grep -v 'missing date' || true
}

pages=("$prefix"/share/man/man1/symplant*.1)
((${#pages[@]} > 20)) || fail "${#pages[@]} manual pages"
for page in "${pages[@]}"; do
  faults=$(faults_of "$page")
  [[ -z $faults ]] || fail "$faults"
done

# The check itself finds a fault.
sed 's/^\.TP$/.TTPP/' "$prefix/share/man/man1/symplant-run.1" >"$work/bad.1"
[[ -n $(faults_of "$work/bad.1") ]] || fail "an unknown macro is not found"

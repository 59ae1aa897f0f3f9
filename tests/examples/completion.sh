#!/usr/bin/env bash
# bash completes commands and options with the script that the tool prints. usage: completion.sh SYMPLANT
set -euo pipefail
tool=$1
PATH=$(dirname "$tool"):$PATH
# shellcheck disable=SC1090
source <(symplant completion bash)

failures=0
check() { # the last word is completed to EXPECTED
  COMP_WORDS=("${@:2}")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _symplant || true # compgen fails if nothing matches
  [[ ${COMPREPLY[*]} == "$1" ]] && return
  printf 'FAILED: %s is completed to [%s], expected [%s]\n' "${*:2}" "${COMPREPLY[*]}" "$1"
  failures=$((failures + 1))
}

complete -p symplant >/dev/null
check generate symplant ge
check --seed symplant run --see
check --depfile symplant generate list.csv --dep
check "" symplant run --no-such
check "" symplant no-such
check "$0" symplant run "${0%?}"
((failures == 0))

#!/usr/bin/env bash
# Runs the commands in the workflows and hooks of docs/continuous-integration.md, and its problem matcher on real output.
# usage: continuous_integration.sh TOOL PROJECT
set -euo pipefail
tool=$(realpath "$1") project=$(realpath "$2")
page=$project/docs/continuous-integration.md
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"
ln -s "$tool" "$folder/bin/symplant"
PATH=$folder/bin:$PATH
mkdir "$folder/lists"
cd "$folder/lists"
cp -r "$project/examples" .

fail() { echo "docs/continuous-integration.md: $*" >&2; exit 1; }

# The first baseline, which the jobs read.
eval "$(grep -m1 '^symplant check --write-baseline' "$page")" >/dev/null 2>&1 || fail "the baseline is not written"

# The commands of the jobs and of the hook.
jobs=0
while IFS= read -r command; do
  jobs=$((jobs + 1))
  case $command in *--fail-on\ warning) command+=' examples/excell/excell.csv' ;; esac # pre-commit adds the files
  bash -c "$command" >out 2>err || fail "\`$command\` ends with $?: $(cat err)"
done < <(sed -nE 's/^ *(- run|script|entry): (symplant .*)/\2/p' "$page")
((jobs == 3)) || fail "$jobs jobs are found, not 3"
[[ $(head -c 1 gl-code-quality.json) == '[' ]] || fail "the GitLab job writes no report"
grep -q '^  entry: symplant check$' "$project/.pre-commit-hooks.yaml" || fail "the hook of the repository has another command"

# A job fails for a new finding, and GitHub gets an annotation of its row.
sed -i '$aVAR_GLOBAL,EXLINE_MB_AGV_X_P9,X0070,%IX0070,BOOL,FALSE,' examples/excell/excell.csv
github=$(sed -nE 's/^ *- run: (symplant .*)/\1/p' "$page")
code=0
bash -c "$github" >out 2>err || code=$?
((code == 1)) || fail "a new finding gives $code, not 1"
grep -q '^::warning file=examples/excell/excell.csv,line=[0-9]*,col=[0-9]*,title=SP203 direction-not-io::' out ||
  fail "no annotation: $(cat out)"

# The problem matcher takes every finding of the task's command apart.
pattern=$(sed -nE 's/^ *"regexp": "(.*)",$/\1/p' "$page" | sed 's/\\\\/\\/g; s/\\d/[0-9]/g')
[[ -n $pattern ]] || fail "there is no regexp"
task=$(sed -nE 's/^ *"command": "(.*)",$/\1/p' "$page")
bash -c "$task" >out 2>err || true
found=0
while IFS= read -r line; do
  [[ $line =~ $pattern ]] || fail "the problem matcher does not match: $line"
  [[ ${BASH_REMATCH[1]} == examples/excell/excell.csv && -n ${BASH_REMATCH[5]} ]] || fail "wrong parts: $line"
  found=$((found + 1))
done < <(grep -E '\[SP[0-9]+ ' out)
((found > 0)) || fail "the task of VS Code finds nothing"

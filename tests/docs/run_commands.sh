#!/usr/bin/env bash
# Runs every command of a page: the lines of its ```sh blocks, each of which must end with exit code 0.
# A block after a line `<!-- run by .ci/run -->` is skipped, since .ci/run runs it. Port 15027 of a page is a free one.
#
#   run_commands.sh SYMPLANT SOURCE_DIR PAGE
set -euo pipefail
symplant=$1 source_dir=$2 page=$3

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
ln -s "$symplant" "$work/bin/symplant"
cp -r "$source_dir/examples" "$work/examples"
PATH="$work/bin:$PATH"
controller=examples/excell/controller/excell_controller
if [ -x "${symplant%/*}/$controller" ]; then
  mkdir -p "$work/build/release/${controller%/*}"
  ln -s "${symplant%/*}/$controller" "$work/build/release/$controller"
fi
export CPATH=${symplant%/*}/runtime/include # of symplant/program.h, as if it were installed

awk '
  /<!-- run by .ci\/run -->/ { skip = 1; next }
  /^```sh$/ && !skip { inside = 1; next }
  /^```/ { inside = 0; if ($0 != "```sh") skip = 0; next }
  inside && NF { print }
' "$source_dir/$page" >"$work/commands"
if [ ! -s "$work/commands" ]; then
  echo "$page holds no command: has its form changed?"
  exit 1
fi

port=$((20000 + RANDOM % 10000))
while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
sed -i "s/127\.0\.0\.1:15027/127.0.0.1:$port/g" "$work/commands"

cd "$work"
count=0
while IFS= read -r command; do
  echo "+ $command"
  if ! bash -c "$command" >output 2>&1 </dev/null; then
    cat output
    echo "$page: this command fails: $command"
    exit 1
  fi
  count=$((count + 1))
done <commands
echo "$page: $count commands"

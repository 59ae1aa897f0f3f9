#!/usr/bin/env bash
# The README's two commands on a fresh Debian 13, in a folder made by debootstrap, and the second one with clang, too; then
# node-opcua with the OPC UA server, and as a PLC.
# usage: debian_13.sh SOURCE
# Needs root, debootstrap and Debian's package server; without them it is skipped (77).
set -euo pipefail
source=$1

((EUID == 0)) || { echo "skipped: only root can make a system in a folder"; exit 77; }
command -v debootstrap >/dev/null || { echo "skipped: debootstrap is not installed"; exit 77; }
# A separate mount namespace: whatever ends this script, nothing stays mounted.
[[ ${UNSHARED-} == yes ]] || UNSHARED=yes exec unshare --mount "$0" "$@"

root=$(mktemp -d)
trap 'umount --recursive "$root/proc" "$root/sys" "$root/dev" && rm -rf --one-file-system "$root"' EXIT # only without mounts
debootstrap --variant=minbase --include=ca-certificates trixie "$root" >"$root.log" || { cat "$root.log"; exit 1; }
rm "$root.log"
for folder in proc sys dev; do mount --rbind "/$folder" "$root/$folder"; done
cp /etc/resolv.conf /etc/hosts "$root/etc" # debootstrap makes no hosts, and links use the name localhost
mkdir "$root/symplant"
tar -C "$source" --exclude=./build --exclude=./.git -c . | tar -C "$root/symplant" -x --no-same-owner

run() { # COMMAND: as root of the new system
  echo "== $1 on Debian $(cat "$root/etc/debian_version")"
  chroot "$root" env -i ${http_proxy:+http_proxy="$http_proxy"} HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 bash -c "cd /symplant && $1"
}
run scripts/demo
run scripts/test
run "scripts/test --clang"
# OPC UA is only in builds on such a system.
run "apt-get install -qq -y --no-install-recommends npm python3 >/dev/null"
run "tests/peers/opc_ua/server_test.sh build/release/symplant examples node build/node-opcua || ((\$? == 77))"
run "tests/peers/opc_ua/client_test.py build/release/symplant . build/node-opcua || ((\$? == 77))"

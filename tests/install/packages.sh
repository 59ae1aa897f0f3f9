#!/usr/bin/env bash
# The packages and the tarball of a release on a fresh Debian, in a folder made by debootstrap: installed, used and removed.
# usage: packages.sh SOURCE RELEASE SUITE (bookworm, trixie)
# Needs root, debootstrap and Debian's package server; without them it is skipped (77).
set -euo pipefail
source=$1 release=$2 suite=$3

((EUID == 0)) || { echo "skipped: only root can make a system in a folder"; exit 77; }
command -v debootstrap >/dev/null || { echo "skipped: debootstrap is not installed"; exit 77; }
[[ -d $release ]] || { echo "skipped: there is no release"; exit 77; }
# A separate mount namespace: whatever ends this script, nothing stays mounted.
[[ ${UNSHARED-} == yes ]] || UNSHARED=yes exec unshare --mount "$0" "$@"

root=$(mktemp -d)
trap 'umount --recursive "$root/proc" "$root/sys" "$root/dev" && rm -rf --one-file-system "$root"' EXIT # only without mounts
debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" >"$root.log" || { cat "$root.log"; exit 1; }
rm "$root.log"
for folder in proc sys dev; do mount --rbind "/$folder" "$root/$folder"; done
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/given"
cp -r "$release" "$root/given/release"
cp -r "$source/tests/install/consumer" "$source/examples" "$source/tests/install/in_package_root.sh" "$source/Containerfile" "$root/given"

echo "== Debian $(cat "$root/etc/debian_version")"
chroot "$root" env -i ${http_proxy:+http_proxy="$http_proxy"} HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
  bash /given/in_package_root.sh

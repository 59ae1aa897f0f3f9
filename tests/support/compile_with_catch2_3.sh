#!/usr/bin/env bash
# Compiles the tests of a build against Catch2 3, without code, where that build has Catch2 2: Debian 12 has version 2, later systems 3.
# The headers are those of Debian 13's package. usage: compile_with_catch2_3.sh BUILD, configured for Ninja and built
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
. scripts/lib.sh
build=$(realpath "$1")
headers=$build/catch2-3

if [[ -e /usr/include/catch2/catch_all.hpp ]]; then
  say "the installed Catch2 is version 3 or later, and the build compiled the tests with it"
  exit
fi

# fetch_headers: unpacks the package of Debian 13, without installing it.
fetch_headers() {
  local fetched
  fetched=$(mktemp -d)
  mkdir -p "$fetched"/{lists/partial,archives/partial}
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian trixie main" >"$fetched/sources.list"
  local apt=(apt-get -q -o Dir::Etc::SourceList="$fetched/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o Dir::State::Lists="$fetched/lists" -o Dir::Cache::Archives="$fetched/archives" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=
    -o APT::Sandbox::User=root)
  "${apt[@]}" update
  (cd "$fetched" && "${apt[@]}" download libcatch2-dev)
  rm -rf "$headers"
  dpkg-deb --extract "$fetched"/libcatch2-dev_3*.deb "$headers"
  rm -rf "$fetched"
  [[ -e $headers/usr/include/catch2/catch_all.hpp ]]
}

[[ -e $headers/usr/include/catch2/catch_all.hpp ]] || fetch_headers || environment_error "Debian 13's package \`libcatch2-dev\` cannot be downloaded"

# The commands of the sources that use Catch2, as their last compilation found; `-isystem` comes before the system's folders.
ninja -C "$build" -t deps | awk '/^[^ ].*:/ { object = $1; sub(/:$/, "", object) } /catch2\/catch.hpp$/ { print object }' | sort -u >"$headers/objects"
ninja -C "$build" -t compdb | python3 -c '
import json, sys
objects = set(open(sys.argv[1]).read().split())
for entry in json.load(sys.stdin):
    if entry.get("output") in objects:
        print(entry["command"].replace(" -c ", f" -fsyntax-only -isystem {sys.argv[2]} -c ", 1), end="\0")
' "$headers/objects" "$headers/usr/include" >"$headers/commands"
count=$(tr -cd '\0' <"$headers/commands" | wc -c)
((count > 20)) || environment_error "only $count sources of $build use Catch2: is it built, by Ninja?"
cd "$build"
xargs -0 -P "$(parallel_jobs)" -I{} bash -c {} <"$headers/commands"
say "$count translation units of tests compile with Catch2 3"

# Debian's source packages, without a change of the system's configuration. Source it after scripts/lib.sh, in the root of the project.
# shellcheck shell=bash

# Lists and downloads of apt; kept, so that a second call downloads nothing.
readonly SOURCE_STATE="$PWD/build/source-packages"

source_apt() { # ARGUMENT...: apt-get with private lists and only the source packages of the system's own archives
  apt-get -q -o Dir::State::lists="$SOURCE_STATE/lists" -o Dir::Cache="$SOURCE_STATE/cache" \
    -o Dir::Etc::sourcelist="$SOURCE_STATE/sources.list" -o Dir::Etc::sourceparts="$SOURCE_STATE/sources.list.d" \
    -o APT::Sandbox::User="$(id -un)" -o Debug::NoLocking=true "$@"
}

# Derives the archives of source packages from the system's archives, and loads their lists once for each script.
load_source_lists() {
  [[ -z ${source_lists_are_loaded-} ]] || return 0
  local file
  rm -rf "$SOURCE_STATE/sources.list.d"
  mkdir -p "$SOURCE_STATE/sources.list.d" "$SOURCE_STATE/lists/partial" "$SOURCE_STATE/cache/archives/partial"
  : >"$SOURCE_STATE/sources.list"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [[ ! -e $file ]] || sed -n 's/^deb[[:blank:]]/deb-src /p' "$file" >>"$SOURCE_STATE/sources.list"
  done
  for file in /etc/apt/sources.list.d/*.sources; do
    [[ ! -e $file ]] || sed 's/^Types:.*/Types: deb-src/' "$file" >"$SOURCE_STATE/sources.list.d/${file##*/}"
  done
  source_apt update || environment_error "the lists of Debian's source packages cannot be loaded"
  source_lists_are_loaded=yes
}

# get_source PACKAGE FOLDER: downloads the newest source package that the system's archives have, checked by their signature, and
# unpacks it, with Debian's patches, to a folder, which is emptied before. Its version: `source_version FOLDER`.
get_source() { # PACKAGE FOLDER
  local downloads="$SOURCE_STATE/$1"
  load_source_lists
  mkdir -p "$downloads"
  (cd "$downloads" && source_apt source --download-only --only-source "$1") ||
    environment_error "the source package $1 cannot be downloaded"
  local newest
  newest=$(source_apt source --print-uris --only-source "$1" | sed -n "s/^'.*' \([^ ]*\.dsc\) .*/\1/p")
  rm -rf "$2"
  mkdir -p "$(dirname "$2")"
  dpkg-source --no-check -x "$downloads/$newest" "$2" || environment_error "the source package $1 cannot be unpacked"
}

source_version() { # FOLDER: the version of a package that get_source has unpacked
  dpkg-parsechangelog -l "$1/debian/changelog" -S Version
}

# Functions that the scripts share: messages, packages, builds by preset. Source it in the root of the project.
# shellcheck shell=bash

readonly EXIT_USAGE=2 EXIT_ENVIRONMENT=3

say() { printf '== %s\n' "$*"; }

usage_error() { # WHAT
  printf '%s: %s; see --help\n' "${0##*/}" "$1" >&2
  exit "$EXIT_USAGE"
}

environment_error() { # WHAT
  printf '%s: %s\n' "${0##*/}" "$1" >&2
  exit "$EXIT_ENVIRONMENT"
}

# The packages of Debian 12 and Ubuntu 24.04 that the build, the tests and the demo need.
# shellcheck disable=SC2034 # for the scripts that source this
readonly BUILD_PACKAGES=(g++ cmake ninja-build make pkg-config libboost-dev libfmt-dev nlohmann-json3-dev libcli11-dev
  catch2 libkainjow-mustache-dev libmodbus-dev libuchardet-dev libpugixml-dev libzip-dev libre2-dev libutf8proc-dev zlib1g-dev
  libjs-three)
# Packages that a system may not have (Debian 13 and Ubuntu 25.10 have them), and without which the build leaves something out: OPC UA.
readonly OPTIONAL_PACKAGES=(libopen62541-1.4-dev)

# "-14" for clang 14, with which the project is tested; nothing, for the default clang, if there is no such package.
clang_suffix() {
  if command -v clang++-14 >/dev/null || apt-cache show clang-14 >/dev/null 2>&1; then echo "-14"; fi
}

# "-16" for clang 16, the first whose libFuzzer has what scripts/fuzz needs, or the next later one that is available.
fuzzer_clang_suffix() {
  local version
  for version in 16 17 18 19 20 21; do
    if command -v "clang++-$version" >/dev/null; then
      echo "-$version"
      return
    fi
  done
  for version in 16 17 18 19 20 21; do
    if apt-cache show "clang-$version" >/dev/null 2>&1; then
      echo "-$version"
      return
    fi
  done
  echo "-16" # Debian 12 and Ubuntu 24.04 have it, even if the package lists are not loaded yet
}

require_known_system() {
  local id="" version=""
  if [[ -r /etc/os-release ]]; then
    id=$(. /etc/os-release && echo "${ID-}")
    version=$(. /etc/os-release && echo "${VERSION_ID-}")
  fi
  case $id in
    debian) [[ -z $version ]] || dpkg --compare-versions "$version" ge 12 && return ;;
    ubuntu) dpkg --compare-versions "$version" ge 24.04 && return ;;
  esac
  environment_error "made for Debian 12 and Ubuntu 24.04 or later, and this is ${id:-another system} $version: install \
g++ 12 or clang 14, CMake 3.25, Boost, fmt, nlohmann-json, CLI11, Catch2, mustache, uchardet, libmodbus, zlib, three.js 111 by hand, \
then: cmake --workflow --preset release"
}

# Whether a package is installed, or its program is available from another source.
is_installed() { # PACKAGE
  case $1 in
    g++ | cmake | make | pkg-config | mbpoll | npm | clang-format-14 | clang-tidy-14) command -v "$1" >/dev/null && return ;;
    ninja-build) command -v ninja >/dev/null && return ;;
  esac
  [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  else
    sudo "$@"
  fi
}

# Whether the package is optional, and the package lists of the system do not have it.
is_unavailable() { # PACKAGE
  [[ " ${OPTIONAL_PACKAGES[*]} " == *" $1 "* ]] && ! apt-cache show "$1" >/dev/null 2>&1
}

# Those of the packages that are to be installed, one a line.
missing_of() { # PACKAGE...
  local package
  for package; do is_installed "$package" || is_unavailable "$package" || echo "$package"; done
}

# Installs those of the packages by apt that are missing. Does nothing, and asks nothing, if none is missing.
install_missing() { # PACKAGE...
  local missing
  mapfile -t missing < <(missing_of "$@")
  ((${#missing[@]} > 0)) || return 0

  local by_hand="install them as root: apt-get install ${missing[*]}"
  if ((EUID != 0)); then
    command -v sudo >/dev/null || environment_error "packages are missing, and there is no sudo: $by_hand"
    [[ -t 0 ]] || sudo -n true 2>/dev/null ||
      environment_error "packages are missing, and sudo wants a password but there is no terminal: $by_hand"
  fi
  say "installing ${missing[*]}"
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  as_root "${apt[@]}" update || environment_error "apt-get update failed; $by_hand"
  mapfile -t missing < <(missing_of "$@") # the lists are loaded now
  as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
    environment_error "apt-get install failed; $by_hand"
}

parallel_jobs() { echo "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"; }

configure() { # PRESET [ARGUMENT]...
  local preset=$1
  shift
  # A folder configured before keeps its generator.
  [[ -e build/$preset/CMakeCache.txt ]] || ! command -v ninja >/dev/null || set -- -G Ninja "$@"
  say "configuring build/$preset"
  cmake --preset "$preset" "$@"
}

build() { # PRESET [ARGUMENT]...
  local preset=$1
  shift
  say "building build/$preset"
  cmake --build --preset "$preset" --parallel "$(parallel_jobs)" "$@"
}

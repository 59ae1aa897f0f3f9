# Runs commands with the tool for Linux and with the one for Windows. Source it with the arguments SOURCE LINUX-TOOL
# WINDOWS-TOOL [CASE-PATTERN]; it copies the examples and goldens to $work/data and starts Wine.
# shellcheck shell=bash
source=$(realpath "$1") linux=$(realpath "$2") windows=$(realpath "$3") pattern=${4-}

command -v wine >/dev/null || { echo "skipped: Wine is not installed"; exit 77; }
work=$(mktemp -d)
trap 'WINEPREFIX="$work/wine" wineserver -k >/dev/null 2>&1 || true; rm -rf "$work"' EXIT
export WINEPREFIX="$work/wine" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml=" NO_COLOR=1 TZ=UTC
mkdir "$work/data" "$work/linux" "$work/windows"
cp -r "$source/examples" "$source/tests/golden" "$work/data"
wine "$windows" --version >/dev/null

commands=0 failed=()

run_in() { # FOLDER TOOL...: ARGUMENTS of the case, from a fresh copy of nothing but links to the data
  local folder=$1
  shift
  mkdir -p "$folder/files"
  (
    cd "$folder/files" || exit
    ln -s "$work/data"/* .
    mkdir out
    set +e
    timeout 60 "$@" >../out 2>../err </dev/null
    echo "$?" >../code
    find . -maxdepth 1 -type l -delete
  )
}

# same ARGUMENT...: one command, which ends without an error of the environment on Linux, so that it shows something. Files that it makes have names below out/. A program NAME.so is NAME.dll on Windows.
same() {
  [[ -z $pattern || "$*" == *$pattern* ]] || return 0
  commands=$((commands + 1))
  rm -rf "$work/linux/"* "$work/windows/"*
  run_in "$work/linux" "$linux" "$@"
  run_in "$work/windows" wine "$windows" "${@//.so/.dll}"
  find "$work/windows" -type f -exec sed -i 's/\.dll\b/.so/g' {} +
  # How long a run took, the hash of a program, and the folder behind the links to the data, are no results.
  find "$work/linux" "$work/windows" -type f -exec sed -Ei \
    's/ time="[0-9.e-]+"//g; s/"seconds":"?[0-9.e-]+"?//g; s/(\.so, )[0-9a-f]{16}/\1/g; s/"digest":"[0-9a-f]{16}"//g; s|\.\./linux/files/||' {} +
  if ! diff -r "$work/linux" "$work/windows" >"$work/difference" 2>&1; then
    different "$*" "$work/difference"
  elif [[ $(<"$work/linux/code") == 3 && $1 != doctor ]]; then
    different "$* does nothing on Linux" "$work/linux/err"
  fi
}

# windows_does CODE WORDS ARGUMENT...: the tool for Windows alone; its exit code, and words that its output has.
windows_does() {
  [[ -z $pattern || "${*:3}" == *$pattern* ]] || return 0
  commands=$((commands + 1))
  local code=0
  (cd "$work/data" && timeout 60 wine "$windows" "${@:3}" >"$work/out" 2>&1) </dev/null || code=$?
  if ((code != $1)) || [[ $(<"$work/out") != *"$2"* ]]; then
    echo "exit code $code, expected $1 and: $2" >>"$work/out"
    different "${*:3}" "$work/out"
  fi
}

different() { # CASE FILE: the difference
  failed+=("symplant $1")
  printf 'DIFFERENT: symplant %s\n' "$1"
  head -c 2000 "$2"
  echo
}

summary() {
  printf '%d commands, %d of them different\n' "$commands" "${#failed[@]}"
  ((commands > 0 && ${#failed[@]} == 0))
}

# Shared parts of the tests of the examples: a plant in the background, waiting for a condition. To be sourced.
# shellcheck shell=bash

work=$(mktemp -d)
plant="" controller=""

clean_up() {
  local pid
  for pid in $controller $plant; do kill -KILL "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT

fail() { # WHAT
  printf 'FAILED: %s\n' "$1"
  local file
  for file in "$work"/*; do
    [[ ! -f $file ]] || { printf -- '--- %s\n' "${file##*/}" && tail -n 60 "$file"; }
  done
  exit 1
}

# The command ends with the exit code and prints the text, which is also in $work/out and $work/err.
says() { # CODE TEXT COMMAND...
  local wanted=$1 text=$2 code=0
  shift 2
  "$@" >"$work/out" 2>"$work/err" || code=$?
  ((code == wanted)) || fail "exit code $code, not $wanted: $*"
  grep -qF -- "$text" "$work/out" "$work/err" || fail "no \`$text\` from: $*"
}

# Sets port to one on which nothing listens, from FIRST on.
free_port() { # FIRST
  port=$(($1 + RANDOM % 10000))
  while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
}

# Tries a command until it succeeds, for a minute at most: the test does not depend on the speed of the machine.
wait_until() { # WHAT COMMAND...
  local what=$1 try
  shift
  for ((try = 0; try < 1200; try++)); do
    "$@" && return
    sleep 0.05
  done
  fail "waited in vain: $what"
}

# The port of a link, as the plant prints it; CONTROLLER is "" for the only link, else as in "PLC1=".
port_of() { # CONTROLLER
  sed -nE "s,^link $1modbus-tcp-server://127\.0\.0\.1:([0-9]+)(;.*)?\$,\1,p" "$work/plant.log"
}

listening() { port=$(port_of "") && [[ -n $port ]]; }

# Starts a plant as a server on a free port; sets plant and port, leaves plant.log and trace.jsonl in $work.
start_plant() { # COMMAND...
  : >"$work/plant.log" # the run before had another port
  "$@" --link modbus-tcp-server://127.0.0.1:0 --trace "$work/trace.jsonl" >"$work/plant.log" 2>&1 &
  plant=$!
  wait_until "the plant says where it listens" listening
}

stop_plant() {
  local code=0
  kill -TERM "$plant"
  wait "$plant" || code=$?
  plant=""
  ((code == 0)) || fail "the plant ended with exit code $code"
}

# The plant time at the end of the run, in milliseconds.
ended_at() { sed -n 's/^ended at \([0-9.e+-]*\) s.*/\1/p' "$work/plant.log" | awk '{ printf "%d\n", $1 * 1000 }'; }

# The plant time of the last change in the trace, in milliseconds.
last_change() { sed -n 's/^{"t":\([0-9]*\),.*/\1/p' "$work/trace.jsonl" | tail -n 1 | awk '{ printf "%d\n", $1 / 1e6 }'; }

count() { # the number of trace lines with the pattern
  grep -c -- "$1" "$work/trace.jsonl" || true
}

# Waits for the link of the panel, then prints the body of GET /api/v1/PATH.
ask_panel() { # PATH
  local host
  wait_until "the plant prints the link of the panel" grep -q '^panel: http' "$work/plant.log"
  host=$(sed -n 's,^panel: http://\([^/]*\)/.*,\1,p' "$work/plant.log")
  exec 3<>"/dev/tcp/${host%:*}/${host##*:}"
  printf 'GET /api/v1/%s HTTP/1.1\r\nHost: %s\r\nConnection: close\r\n\r\n' "$1" "$host" >&3
  sed '1,/^\r$/d' <&3
  exec 3>&-
}

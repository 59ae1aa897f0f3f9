#!/usr/bin/env bash
# Installs, uses and removes the packages of /given/release, then its tarball, as root of a fresh system. packages.sh runs it there.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive
cd /given/release

fail() { # WHAT
  echo "FAILED: $1"
  exit 1
}
apt() { apt-get -q -y -o Dpkg::Use-Pty=0 "$@" >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; fail "apt-get $*"; }; }

uses_the_tool() { # SYMPLANT
  "$1" --version || fail "$1 does not start"
  "$1" check /given/examples/excell/excell.csv || fail "check"
  "$1" check /given/examples/tia/PLCTags.xlsx >/dev/null || (($? == 1)) || fail "a workbook is not read"
  "$1" run /given/examples/excell/excell.csv --scenario /given/examples/excell/figure6.json >/dev/null || fail "a scenario"
  # A comment in Japanese, in the code page of Windows.
  printf 'Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\nVAR_GLOBAL,L_P_D_I_A,X1,%%IX1,BOOL,FALSE,\x8e\xe8\n' >/tmp/cp932.csv
  "$1" check /tmp/cp932.csv --encoding cp932 --verbose >/tmp/cp932.log 2>&1 || { cat /tmp/cp932.log; fail "a list in code page 932"; }
}

# A C++ program with the system's own C++ library, in the tool, which has another one linked in.
uses_a_program() { # SYMPLANT INCLUDE
  cat >/tmp/program.cpp <<'CPP'
#include <stdexcept>
#include <string>
#include <symplant/program.h>
namespace {
const symplant_variable variables[] = {{.symbol = "EXLINE_MB_AGV_I_P1", .bits = 1}, {.symbol = "EXLINE_MB_AGV_O_P2", .writes = 1, .bits = 1}};
void* create(void* const* cells) { return const_cast<void**>(cells); }
int scan(void* instance, int64_t) {
  const auto cells = static_cast<uint8_t**>(instance);
  try {
    if (*cells[0] != 0) throw std::runtime_error(std::string(100, 'x'));
  } catch (const std::exception&) {
    *cells[1] = 1;
  }
  return 0;
}
void destroy(void*) {}
}  // namespace
extern "C" const symplant_program* symplant_program_v1() {
  static const symplant_program program = {1, sizeof program, "thrower", 0, variables, 2, create, scan, destroy};
  return &program;
}
CPP
  g++ -std=c++20 -shared -fPIC -I "$2" /tmp/program.cpp -o /tmp/program.so || fail "a program in C++ does not compile"
  "$1" run /given/examples/excell/excell.csv --program /tmp/program.so --until 5s --trace /tmp/trace.jsonl >/dev/null || fail "a program in C++"
  grep -q EXLINE_MB_AGV_I_P2 /tmp/trace.jsonl || fail "the program in C++ did not move the vehicle"
}

builds_a_project() { # PREFIX
  rm -rf /tmp/consumer
  cmake -S /given/consumer -B /tmp/consumer -DCMAKE_PREFIX_PATH="$1" >/tmp/cmake.log 2>&1 || { cat /tmp/cmake.log; fail "find_package(symplant)"; }
  cmake --build /tmp/consumer --parallel 2 >/tmp/cmake.log 2>&1 || { cat /tmp/cmake.log; fail "a project does not build"; }
  /tmp/consumer/press --until 1s --clock virtual >/dev/null || fail "its plant does not run"
  /tmp/consumer/press --until 1s --program /tmp/consumer/ram_program.so >/dev/null || fail "its program does not run"
  /tmp/consumer/consumer || fail "its library"
}

# The steps of the Containerfile, without a builder: COPY is from the release, RUN is run, ENTRYPOINT is started.
uses_the_containerfile() {
  local copied step entry
  copied=$(sed -nE 's/^COPY ([^ ]+) .*/\1/p' /given/Containerfile)
  # shellcheck disable=SC2086 # a pattern of names
  cp $copied "$(sed -nE 's/^COPY [^ ]+ (.*)/\1/p' /given/Containerfile)" || fail "COPY of the Containerfile"
  step=$(sed -nE ':a; /\\$/{N; ba}; s/^RUN (.*)/\1/p' /given/Containerfile | sed 's/\\$//')
  bash -euc "$step" >/tmp/container.log 2>&1 || { cat /tmp/container.log; fail "RUN of the Containerfile"; }
  entry=$(sed -nE 's/^ENTRYPOINT \["(.*)"\]/\1/p' /given/Containerfile)
  "$entry" check /given/examples/excell/excell.csv >/dev/null || fail "ENTRYPOINT of the Containerfile"
  apt purge symplant
}

sha256sum --check SHA256SUMS || fail "the checksums"
if grep -q '^12' /etc/debian_version; then uses_the_containerfile; fi # its base is Debian 12

echo "== the package of the tool"
apt update
apt install --no-install-recommends ./symplant_*.deb
uses_the_tool symplant
[[ -f /usr/share/man/man1/symplant.1.gz && -f /usr/share/doc/symplant/copyright ]] || fail "no manual page, or no copyright file"
apt install --no-install-recommends man-db zsh
man symplant | grep 'symplant-run(1)' >/dev/null || fail "man symplant"
man symplant-run | grep -- '--until T' >/dev/null || fail "man symplant-run"
bash -c '. /usr/share/bash-completion/completions/symplant && complete -p symplant' >/dev/null || fail "completion by bash"
zsh -fc 'fpath+=/usr/share/zsh/site-functions; autoload -U compinit && compinit -uD && [[ $_comps[symplant] == _symplant ]]' ||
  fail "completion by zsh"

echo "== the package for projects"
apt install ./libsymplant-dev_*.deb # with what it recommends
builds_a_project /usr
uses_a_program symplant /usr/include

echo "== removed"
apt purge symplant libsymplant-dev
rm -rf /tmp/consumer
left=$(find / -xdev -name '*symplant*' -not -path '/given/*' -not -path '/proc/*')
[[ -z $left ]] || fail "left after the purge: $left"

echo "== the tarball"
tar -xzf symplant-*-linux-x86_64.tar.gz -C /opt
prefix=$(echo /opt/symplant-*)
uses_the_tool "$prefix/bin/symplant"
man -M "$prefix/share/man" symplant | grep 'symplant-run(1)' >/dev/null || fail "man of the tarball"
builds_a_project "$prefix"
uses_a_program "$prefix/bin/symplant" "$prefix/include"
echo "good"

#!/usr/bin/env bash
# FMUs: the tool for Windows writes the same description and tables as the one for Linux, and its library runs in an
# importer on Windows.
# usage: fmu.sh SOURCE LINUX-TOOL WINDOWS-TOOL
# Needs Wine (wine64), unzip and the compiler of mingw-w64.
set -euo pipefail
# shellcheck source=tests/windows/both.bash
. "$(dirname "${BASH_SOURCE[0]}")/both.bash"

cd "$work/data"
"$linux" generate examples/cell/plant.json --fmu linux.fmu
wine "$windows" generate examples/cell/plant.json --fmu windows.fmu
unzip -q linux.fmu -d linux
unzip -q windows.fmu -d "with a blank"
for file in modelDescription.xml resources/plant.bin; do cmp "linux/$file" "with a blank/$file"; done

description="with a blank/modelDescription.xml"
guid=$(sed -n 's/.* guid="\([^"]*\)".*/\1/p' "$description")
reference() { sed -n "s/.* name=\"$1\" valueReference=\"\([0-9]*\)\".*/\1/p" "$description"; }
x86_64-w64-mingw32-gcc -std=c99 -Wall -Wextra -Werror -o fmu_step.exe "$source/tests/windows/fmu_step.c"
wine fmu_step.exe "with a blank/binaries/win64/cell.dll" "file:///Z:$PWD/with%20a%20blank/resources" "$guid" \
  "$(reference EXLINE_MB_AGV_O_P2)" "$(reference EXLINE_MB_AGV_I_P2)" >steps.txt
[[ $(tr -d '\r' <steps.txt) == "2.0 s: 1" ]] || { cat steps.txt; exit 1; }
echo "equal FMUs, and one that runs on Windows"

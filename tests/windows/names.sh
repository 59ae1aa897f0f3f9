#!/usr/bin/env bash
# Names of files and bytes of lists: the tool for Windows does the same as the one for Linux, and knows drives, devices
# and paths with backslashes. usage: names.sh SOURCE LINUX-TOOL WINDOWS-TOOL [CASE-PATTERN]
# Needs Wine (wine64) and iconv.
set -euo pipefail
# shellcheck source=tests/windows/both.bash
. "$(dirname "${BASH_SOURCE[0]}")/both.bash"

far="grüße 日本 😀/mit Leerzeichen"
mkdir -p "$work/data/$far/lists" "$work/data/bytes"
cd "$work/data"
cp examples/cell/{plant.json,symbols.csv} "$far"
cp examples/cell/symbols.csv "$far/lists/ü.csv"
sed 's/symbols\.csv/lists\\\\ü.csv/' examples/cell/plant.json >"$far/backslash.json"
sed 's/symbols\.csv/lists\\\\*.csv/' examples/cell/plant.json >"$far/pattern.json"

same check "$far/plant.json" --format sarif --output "out/ö ä/bericht.sarif"
same generate "$far/plant.json" -o "out/ö 日本"
same run "$far/plant.json" --until 20s --trace "out/spür 😀.jsonl" --vcd "out/ü.vcd"
same check "$far/missing.json"
same check "$far"
same check "$far/"
same check ./examples/../examples/cell/plant.json
same check /missing/plant.json
deep=$(printf 'a%.0s' {1..120})
deep=out/$deep/$deep/$deep
same generate examples/cell/plant.json -o "$deep"
same model examples/cell/plant.json --format json -o "$deep/model.json"

# Ends of lines.
for file in cell/plant.json cell/symbols.csv excell/excell.csv excell/figure6.json; do sed 's/$/\r/' "examples/$file" >"bytes/${file##*/}"; done
same check bytes/plant.json
same run bytes/plant.json --until 20s --trace out/trace.jsonl
same run bytes/excell.csv --scenario bytes/figure6.json --trace out/trace.jsonl

# Every character of each code page as a comment, and UTF-16. Wine has no GB 18030. In cp1255 and cp1258 a letter and the
# point or tone after it become one character on Linux only: none follows a letter here.
every_character() { # ENCODING BYTES: at most, of a character
  LC_ALL=C awk 'function c(n) { return sprintf("%c", n) }
    BEGIN { for (n = 128; n < 65536; ++n) if (n < 55296 || (n >= 63744 && n < 64256) || n >= 64512)
      print n < 2048 ? c(192 + int(n / 64)) c(128 + n % 64) : c(224 + int(n / 4096)) c(128 + int(n / 64) % 64) c(128 + n % 64) }' |
    iconv -c -f UTF-8 -t "$1" | LC_ALL=C awk -v most="$2" 'length($0) > 0 && length($0) <= most' | iconv -f "$1" -t UTF-8 |
    awk 'BEGIN { print "Name;Address;Comment" } { printf "S%05d;M%d; %s |\n", NR, NR, $0 }' | iconv -f UTF-8 -t "$1"
}
for encoding in cp932 cp949 cp950 cp874 cp1250 cp1251 cp1252 cp1253 cp1254 cp1255 cp1256 cp1257 cp1258 cp437 cp850 cp852 cp866; do
  bytes=1
  [[ $encoding != cp9* ]] || bytes=2
  every_character "${encoding^^}" "$bytes" >"bytes/$encoding.csv"
  same convert "bytes/$encoding.csv" out/list.st --encoding "$encoding"
  printf 'Name;Address;Comment\nA;M1;a\200\201\222\236\240\375\376\377\n' >"bytes/invalid.csv"
  same check bytes/invalid.csv --encoding "$encoding"
done
for encoding in UTF-16 UTF-16LE UTF-16BE; do
  iconv -f UTF-8 -t "$encoding" examples/gx-works-station/COMMENT.csv >"bytes/$encoding.csv" 2>/dev/null || iconv -f UTF-8 -t "$encoding" examples/excell/excell.csv >"bytes/$encoding.csv"
  same check "bytes/$encoding.csv"
done

# What only Windows has.
drive=Z:${work//\//\\}\\data
within="$drive\\${far//\//\\}"
windows_does 0 "18 rows" check "$within\\plant.json"
windows_does 0 "18 rows" check "Z:$work/data/$far/backslash.json"
windows_does 0 "18 rows" check "$far/pattern.json"
windows_does 0 '"uri": "gr%C3%BC%C3%9Fe%20' check "$within\\plant.json" --format sarif
windows_does 2 '"uri": "file:///Z:/' check "$drive\\..\\outside.csv" --format sarif
windows_does 3 "cannot write" model examples/cell/plant.json -o "$(printf 'a%.0s' {1..300})"
for device in NUL nul examples/NUL; do windows_does 0 "" model examples/cell/plant.json -o "$device"; done
windows_does 3 "cannot write" model examples/cell/plant.json -o COM9
[[ -z $(find "$work/data" -iname nul) ]] || different "devices are no files" /dev/null

summary

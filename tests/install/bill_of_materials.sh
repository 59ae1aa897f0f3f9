#!/usr/bin/env bash
# The bill of materials of a release follows the schema of CycloneDX 1.5, and names what the tool is made of.
# usage: bill_of_materials.sh RELEASE. Fetches the schema by npm; without npm or its registry it is skipped (77).
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
release=$(realpath "$1")

command -v npm >/dev/null || { echo "npm is not installed, so the schema cannot be fetched: skipped"; exit 77; }
cd "$outer"
npm install --silent --no-audit --no-fund --ignore-scripts @cyclonedx/cyclonedx-library@10.3.0 ajv@8 ajv-formats@3 \
  ajv-formats-draft2019@1 >npm.log 2>&1 || { cat npm.log; echo "the schema cannot be fetched by npm: skipped"; exit 77; }
cat >validate.mjs <<'SCRIPT'
import { readFileSync } from "node:fs";
import { Validation, Spec } from "@cyclonedx/cyclonedx-library";
const error = await new Validation.JsonStrictValidator(Spec.Version.v1dot5).validate(readFileSync(process.argv[2], "utf-8"));
if (error !== null) {
  console.log(JSON.stringify(error, null, 1).slice(0, 3000));
  process.exit(1);
}
SCRIPT
bill=$(echo "$release"/*.cdx.json)
node validate.mjs "$bill" >out 2>&1 || fail "$bill does not follow the schema" out

# The check itself finds a fault.
sed 's/"BSL-1.0"/"Boost"/' "$bill" >bad.json
if node validate.mjs bad.json >out 2>&1; then fail "a license that SPDX does not have passes"; fi

for name in boost1.74 cli11 fmtlib gcc-12 glibc libzip nlohmann-json3 pugixml re2 uchardet utf8proc zlib; do
  grep -q "\"name\": \"$name\"" "$bill" || fail "$name is not in $bill"
done
for member in 'libzip.a(zip_open.c.o)' 'libre2.a(re2.o)' 'libz.a(inflate.o)'; do
  grep -qF "\"value\": \"$member\"" "$bill" || fail "$member is not in $bill"
done
if grep -E 'bz2|lzma|zstd|crypto' "$bill"; then fail "a compression or encryption that the tool does not use was linked"; fi

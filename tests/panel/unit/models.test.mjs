// The models of the examples are what examples/make_models.mjs makes.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

const kExamples = join(dirname(fileURLToPath(import.meta.url)), "../../../examples");

test("examples/make_models.mjs makes the models of the examples, byte by byte", () => {
  const folder = mkdtempSync(join(tmpdir(), "models-"));
  try {
    execFileSync(process.execPath, [join(kExamples, "make_models.mjs"), folder]);
    for (const path of ["cell/cell.glb", "harbour-crane/crane.glb"]) assert.ok(readFileSync(join(folder, path)).equals(readFileSync(join(kExamples, path))), path);
  } finally {
    rmSync(folder, {recursive: true});
  }
});

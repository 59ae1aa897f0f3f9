// Prints what gltf-validator finds in GLB files.
//
// usage: node gltf_faults.mjs FOLDER FILE...   FOLDER has node_modules/gltf-validator
// Exit code: 0 nothing, 1 something
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join, resolve} from "node:path";

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(join(resolve(folder), "x.js"))("gltf-validator");
let found = 0;
for (const file of files) {
  const {issues: {messages}} = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  for (const {severity, code, message, pointer} of messages) console.log(file + ": severity " + severity + ", " + code + ": " + message + " " + (pointer ?? ""));
  found += messages.length;
}
console.log(files.length + " files, " + found + " findings");
process.exit(found === 0 ? 0 : 1);

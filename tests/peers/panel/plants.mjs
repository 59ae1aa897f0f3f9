// The plant that a browser test looks at: a real one of `symplant run`, or the mock server of tests/panel.
import {spawn} from "node:child_process";
import {readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

export const kProject = join(dirname(fileURLToPath(import.meta.url)), "../../..");
export const kExercise = join(kProject, "examples/body-shop/no-air.json");

/// Starts `symplant ARGUMENTS` and waits for the link of its panel. `stop()` ends it as Ctrl+C does, `signal(NAME)` sends a signal.
export const startProgram = async (symplant, args) => {
  const child = spawn(symplant, args, {cwd: kProject});
  let text = "";
  const ended = new Promise((done) => child.on("exit", done));
  const link = await new Promise((done, fail) => {
    const read = (piece) => {
      text += piece;
      const found = /http:\/\/\S+#token=[0-9a-f]+/.exec(text);
      if (found) done(found[0]);
    };
    child.stdout.on("data", read);
    child.stderr.on("data", read);
    ended.then((code) => fail(new Error("symplant ended with " + code + ":\n" + text)));
  });
  return {link, real: true, signal: (name) => child.kill(name), stop: async () => {
    child.kill("SIGINT");
    return ended;
  }};
};

/// The body-shop line with the exercise, its trace in `folder`.
export const startBodyShop = async (symplant, folder) => {
  if (symplant) {
    return startProgram(symplant, ["run", "examples/body-shop/plant.json", "--panel", "127.0.0.1:0", "--panel-files", folder, "--exercise", kExercise,
      "--trace", join(folder, "live.jsonl")]);
  }
  const {startServer} = await import("../../panel/mock/server.mjs");
  const server = await startServer({name: "body-shop", exerciseFile: kExercise});
  return {link: server.link, real: false, stop: server.stop};
};

const symbolLines = (lines) => lines.filter((line) => line.includes('"symbol":')).map((line) => JSON.parse(line));

/// The changes of symbols since the plant was last set back.
export const lastRun = (trace) => {
  const lines = readFileSync(trace, "utf8").trim().split("\n");
  const begin = lines.findLastIndex((line) => /,"(reset|restored)":/.test(line));
  return symbolLines(lines.slice(begin + 1));
};

/// Plays a scenario without a panel, in which a requirement may be violated; the changes of symbols.
export const replay = async (symplant, scenario, folder) => {
  const trace = join(folder, "replayed.jsonl");
  const child = spawn(symplant, ["run", "examples/body-shop/plant.json", "--scenario", scenario, "--trace", trace], {cwd: kProject});
  let text = "";
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (piece) => { text += piece; });
  const code = await new Promise((done) => child.on("exit", done));
  if (code !== 0 && code !== 1) throw new Error("the replay ended with " + code + ":\n" + text);
  return symbolLines(readFileSync(trace, "utf8").trim().split("\n"));
};

// A plant that runs during a test: started as an OPC UA server, ended at the end of the test.
import { spawn } from "node:child_process";

let failures = 0;

export function check(what, expected, seen) {
  const same = JSON.stringify(expected) === JSON.stringify(seen);
  if (!same) ++failures;
  console.log(same ? `ok: ${what}` : `FAILED: ${what}: expected ${JSON.stringify(expected)}, seen ${JSON.stringify(seen)}`);
}

export function exitCode() {
  return failures === 0 ? 0 : 1;
}

export const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/// Asks until the answer is as wanted, or 30 s are over: the speed of the machine is not known.
export async function until(what, wanted, ask) {
  const end = Date.now() + 30_000;
  let seen = await ask();
  while (JSON.stringify(seen) !== JSON.stringify(wanted) && Date.now() < end) {
    await pause(20);
    seen = await ask();
  }
  check(what, wanted, seen);
}

/// `symplant run PLANT --link URL ...` until stop().
export class RunningPlant {
  constructor(symplant, plant, url, ...options) {
    this.text = "";
    this.process = spawn(symplant, ["run", plant, "--link", url, ...options]);
    for (const stream of [this.process.stdout, this.process.stderr]) {
      stream.on("data", (data) => (this.text += data));
    }
    this.ended = new Promise((resolve) => this.process.on("exit", resolve));
  }

  /// The port of its server; fails if it does not start within 60 s.
  async port() {
    const end = Date.now() + 60_000;
    while (Date.now() < end && this.process.exitCode === null) {
      const line = /^link opc-ua-server:\/\/127\.0\.0\.1:(\d+)/m.exec(this.text);
      if (line) return Number(line[1]);
      await pause(20);
    }
    this.process.kill("SIGKILL");
    throw new Error(`the plant does not say where it listens; it said:\n${this.text}`);
  }

  async stop(signal = "SIGTERM") {
    this.process.kill(signal);
    return this.ended;
  }
}

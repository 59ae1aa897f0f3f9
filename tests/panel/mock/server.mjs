// A server for tests of the panel's page alone: it has the interface of docs/panel-interface.md, but no real plant.
//
// usage: node server.mjs PLANT [--port N] [--activity N] [--view-only] [--exercise FILE]
// PLANT: cell, body-shop, operated, material, large (10,000 devices), symbols (3,000 and 200 parts), scene (200 devices and 100 parts), names, recording
import {createServer} from "node:http";
import {randomBytes} from "node:crypto";
import {readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import * as descriptions from "./descriptions.mjs";
import {act, why} from "./mock_acts.mjs";
import {MockPlant} from "./mock_plant.mjs";

const project = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const page = join(project, "runtime/panel/page");
const kCsp = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'";
const three = "/usr/share/javascript/three";
const kThree = {"build/three.module.js": join(three, "three.module.js"), "three/GLTFLoader.js": join(three, "examples/jsm/loaders/GLTFLoader.js"),
  "three/OrbitControls.js": join(three, "examples/jsm/controls/OrbitControls.js")};
const kTypes = {html: "text/html; charset=utf-8", js: "text/javascript; charset=utf-8", css: "text/css; charset=utf-8"};

const makePlant = (name, activity, exercises) => {
  const of = (description, options = {}) => new MockPlant(description, {exercises, activity: activity ?? 0, ...options});
  if (name === "cell") return of(descriptions.cell());
  if (name === "body-shop") return of(descriptions.bodyShop(project), {partsPerTrack: 5});
  if (name === "material") return of(descriptions.material(), {partsPerTrack: 8});
  if (name === "large") return of(descriptions.large(10000), {activity: activity ?? 10667, move: 300e6});
  if (name === "symbols") return of(descriptions.large(1000, 3000, 25), {activity: activity ?? 200, partsPerTrack: 8});
  if (name === "scene") return of(descriptions.shaped(descriptions.large(200, 880, 20)), {activity: activity ?? 200, partsPerTrack: 5});
  if (name === "operated") return of(descriptions.operated(), {partsPerTrack: 2});
  if (name === "names") return of(descriptions.names(), {partsPerTrack: 2});
  if (name === "recording") return of({...descriptions.bodyShop(project), mode: "recording", acts: false, files: false, begin: 0, end: 60e9}, {activity: 30, partsPerTrack: 5});
  throw new Error("there is no mock plant " + name);
};

const sendFile = (response, path) => {
  const name = path === "/" ? "index.html" : path.slice(1);
  if (!/^([a-z0-9_]+\/)?[a-z0-9_]+\.(html|js|css)$/.test(name) && !(name in kThree)) return send(response, 404, {error: "not found"});
  try {
    const bytes = readFileSync(kThree[name] ?? join(page, name));
    response.writeHead(200, {"Content-Type": kTypes[name.split(".").pop()], "Content-Security-Policy": kCsp, "X-Content-Type-Options": "nosniff", "Cache-Control": "no-store"});
    response.end(bytes);
  } catch {
    send(response, 404, {error: "not found"});
  }
};

const send = (response, status, value) => {
  response.writeHead(status, {"Content-Type": "application/json", "Cache-Control": "no-store"});
  response.end(JSON.stringify(value));
};

const body = async (request) => {
  let text = "";
  for await (const piece of request) text += piece;
  return JSON.parse(text);
};

/// The pictures of a recording: the mock plant is run once, and kept at each tenth of a second.
const record = (plant) => {
  const pictures = [];
  for (let t = 0; t <= plant.description.end; t += 1e8) {
    pictures.push(plant.picture());
    pictures[pictures.length - 1] = structuredClone(pictures[pictures.length - 1]);
    plant.advance(1e8);
  }
  return pictures;
};

const chart = (plant, query) => {
  const list = (key) => (query.get(key) ?? "").split(",").filter((text) => text !== "").map(Number);
  const after = query.has("after") ? Number(query.get("after")) : -1;
  const from = Number(query.get("from") ?? 0);
  const rows = (kind, indexes, now) => indexes.map((index) => {
    const found = plant.log.filter(([n, key]) => n >= after && key === kind + index).map(([, , entry]) => entry);
    if (after >= 0) return found;
    const later = found.filter(([t]) => t > from);
    const before = found.filter(([t]) => t <= from).pop();
    return [before ? [from, ...before.slice(1)] : [from, ...now(index)], ...later];
  });
  return {from, to: plant.t, next: plant.next,
    symbols: rows("s", list("symbols"), (index) => [plant.description.symbols[index].type === "BOOL" ? plant.description.symbols[index].initial === "TRUE" : 0]),
    devices: rows("d", list("devices"), () => [0, 0])};
};

/// A quarter of the time each device moves, and half of the time each location has parts.
const utilization = (plant, query) => {
  const {t, description: {devices, locations}} = plant;
  const cycle = [2, 4e9, 5e9, 6e9, 4e9];
  if (query.has("device")) {
    const [from, to] = devices[Number(query.get("device"))].states;
    return {times: {moving: t / 4, waiting: t - t / 4}, malfunction: 0, states: {[from]: t - t / 4, [to]: 0},
      moves: [{from, to, time: t / 4, count: 3, least: 1e9, mean: 1e9, greatest: 1e9, last: 1e9}], cycle: {state: from, count: 2, least: 4e9, mean: 5e9, greatest: 6e9, last: 4e9}};
  }
  return {from: 0, to: t, devices: devices.map(() => [[t / 4, 0, t - t / 4, 0, 0, 0, 0, 0], 0, 3, cycle]),
    locations: locations.map((_, i) => [[t / 2, t / 4, t / 4], i === 0, 4, 3, 3, cycle]), exits: [3, cycle]};
};

const serverTime = () => Math.round(performance.now());

/// `deny(path)`: the status of a request that is denied, or 0. `delay()`: ms until acts that arrived are looked at.
export const startServer = async ({name, port = 0, activity, viewOnly = false, exerciseFile = null, deny = null, delay = null}) => {
  const exercises = exerciseFile ? [{name: "no-air", file: JSON.parse(readFileSync(exerciseFile, "utf8").replace(/^ *\/\/.*$/gm, ""))}] : [];
  const plant = makePlant(name, activity, exercises);
  const {description} = plant;
  if (viewOnly) description.acts = false;
  description.run = randomBytes(8).toString("hex");
  for (const {name: key, file} of exercises) description.exercises.push({name: key, ...file.exercise, steps: file.steps.length});
  const token = randomBytes(16).toString("hex");
  const pictures = description.mode === "recording" ? record(plant) : null;
  const streams = new Set();
  const picture = () => ({...plant.picture(), now: serverTime()});
  const api = {
    plant: () => description,
    picture,
    layout: () => ({revision: 1, plan: {}}),
    files: () => ({files: []}),
    why: (query) => why(plant, query.get("name")),
    chart: (query) => chart(plant, query),
    utilization: (query) => utilization(plant, query),
    "utilization.csv": () => ({}),
    at: (query) => pictures[Math.min(pictures.length - 1, Math.floor(Number(query.get("t")) / 1e8))],
    "session/scenario": () => ({"symplant-scenario": 1, steps: plant.acts.map(({t, act: of}) => ({at: t / 1e9 + "s", ...of}))}),
    "session/session": () => ({acts: plant.acts, findings: plant.findings}),
    "session/junit": () => ({}),
  };
  const post = async (request, response, path) => {
    if (request.headers.authorization !== "Bearer " + token) return send(response, 401, {error: "the token is missing or wrong; open the link that symplant printed"});
    if (!description.acts) return send(response, 403, {error: "the panel only shows"});
    if (request.headers["x-symplant-run"] !== description.run) return send(response, 409, {error: "the program was restarted; load the page again"});
    const {acts, until = Infinity} = await body(request);
    await new Promise((done) => setTimeout(done, delay?.() ?? 0));
    if (!Array.isArray(acts) || acts.length === 0) return send(response, 400, {error: "`acts` is an array of acts"});
    if (path === "check") return send(response, 200, {});
    if (until < serverTime()) return send(response, 422, {error: "it came too late, and was not done; try again"});
    try {
      for (const of of acts) act(plant, of);
    } catch (error) {
      return send(response, 422, {error: error.message});
    }
    setTimeout(() => send(response, 200, {t: plant.t}), 5);
  };
  const server = createServer((request, response) => {
    const url = new URL(request.url, "http://localhost");
    if (!url.pathname.startsWith("/api/v1/")) return sendFile(response, url.pathname);
    const path = url.pathname.slice(8);
    if (deny?.(path)) return send(response, deny(path), {error: "denied by the test"});
    if (request.method === "POST") return post(request, response, path).catch(() => send(response, 400, {error: "not JSON"}));
    if (path === "stream") {
      response.writeHead(200, {"Content-Type": "text/event-stream", "Cache-Control": "no-store"});
      response.write("event: picture\ndata: " + JSON.stringify(picture()) + "\n\n");
      streams.add(response);
      return request.on("close", () => streams.delete(response));
    }
    return path in api ? send(response, 200, api[path](url.searchParams)) : send(response, 404, {error: "not found"});
  });
  let last = performance.now();
  let second = 0;
  let ticks = 0;
  const timer = setInterval(() => {
    const now = performance.now();
    if (!pictures) plant.advance(Math.min(2e8, (now - last) * 1e6));
    last = now;
    const isSecond = now - second > 1000;
    if (isSecond) second = now;
    if (++ticks % 1500 === 0 || ticks === 50) {
      act(plant, {snapshot: "back " + Math.round(plant.t / 1e9)});
      plant.snapshots[plant.snapshots.length - 1].kind = "backtrack";
    }
    const changes = plant.changes(isSecond) ?? (isSecond ? {rev: plant.rev, t: plant.t} : null);
    if (!changes || streams.size === 0) return;
    const text = "event: changes\ndata: " + JSON.stringify({...changes, now: serverTime()}) + "\n\n";
    for (const stream of streams) if (stream.writableLength < 1e7) stream.write(text);
  }, 40);
  await new Promise((done) => server.listen(port, "127.0.0.1", done));
  const address = "http://127.0.0.1:" + server.address().port;
  const stop = () => new Promise((done) => {
    clearInterval(timer);
    for (const stream of streams) stream.destroy();
    server.closeAllConnections();
    server.close(done);
  });
  return {plant, token, address, link: address + "/#token=" + token, stop, streams};
};

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [name, ...rest] = process.argv.slice(2);
  const option = (key) => rest.includes(key) ? rest[rest.indexOf(key) + 1] : undefined;
  const server = await startServer({name, port: Number(option("--port") ?? 0), activity: option("--activity") ? Number(option("--activity")) : undefined,
    viewOnly: rest.includes("--view-only"), exerciseFile: option("--exercise") ?? null});
  console.log("panel: " + server.link);
}

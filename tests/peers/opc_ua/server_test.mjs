// node-opcua, a foreign client, with the server of a plant: browses, reads, writes, subscribes, calls methods, logs in
// with a user name, and bears a restart of the plant.
//
// usage: node server_test.mjs SYMPLANT EXAMPLES PACKAGES
//
// PACKAGES is the folder with node-opcua. Exit code: 0 passed, 1 a check failed.
import { createRequire } from "node:module";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { check, exitCode, pause, RunningPlant, until } from "./running_plant.mjs";

const [symplant, examples, packages] = process.argv.slice(2);
const opcua = createRequire(resolve(packages, "node_modules") + "/")("node-opcua");
const { AttributeIds, DataType, StatusCodes, UserTokenType } = opcua;
const folder = mkdtempSync(join(tmpdir(), "opc-ua-"));

const id = (name) => `ns=2;s=${name}`;
const options = {
  endpointMustExist: false,
  connectionStrategy: { maxRetry: 2, initialDelay: 100, maxDelay: 500 },
  clientCertificateManager: new opcua.OPCUACertificateManager({ rootFolder: join(folder, "pki"), automaticallyAcceptUnknownCertificate: true }),
};

async function connected(port, more, user) {
  const client = opcua.OPCUAClient.create({ ...options, ...more });
  await client.connect(`opc.tcp://127.0.0.1:${port}`);
  try {
    return { client, session: await client.createSession(user) };
  } catch (error) {
    await client.disconnect();
    throw error;
  }
}

async function closed({ client, session }) {
  await session.close();
  await client.disconnect();
}

async function read(session, name) {
  const value = await session.read({ nodeId: id(name), attributeId: AttributeIds.Value });
  return { value: value.value.value, status: value.statusCode.name };
}

const value = async (session, name) => (await read(session, name)).value;

async function write(session, name, dataType, number) {
  const status = await session.write({ nodeId: id(name), attributeId: AttributeIds.Value, value: { value: { dataType, value: number } } });
  return status.name;
}

/// The browse names of what a node has, in ascending order.
async function names(session, node) {
  const result = await session.browse({ nodeId: node, referenceTypeId: "HierarchicalReferences", includeSubtypes: true, browseDirection: 0, resultMask: 63 });
  return result.references.map((reference) => reference.browseName.name).sort();
}

async function call(session, method, ...inputs) {
  return session.call({ objectId: id("/plant"), methodId: id(`/plant/${method}`), inputArguments: inputs });
}

const text = (string) => ({ dataType: DataType.String, value: string });

async function browseTheCell(session) {
  check("the plant's object", ["cell"], (await names(session, "ns=0;i=85")).filter((name) => name === "cell"));
  check("what the plant has", ["Cycles", "EXLINE", "EndMalfunction", "Freeze", "Frozen", "ModelHash", "PlantTime", "Run", "StartMalfunction", "Step"], await names(session, id("/plant")));
  check("the processes of the line", ["MB", "S1", "S2"], await names(session, id("/line/EXLINE")));
  check("the devices of a process", ["AGV", "DOOR", "MC"], (await names(session, id("/process/EXLINE_MB"))).filter((name) => !name.startsWith("EXLINE")));
  check("what a device has", ["EXLINE_MB_AGV_I_P1", "EXLINE_MB_AGV_I_P2", "EXLINE_MB_AGV_O_CHARGE", "EXLINE_MB_AGV_O_P1", "EXLINE_MB_AGV_O_P2", "EXLINE_MB_AGV_O_PUSH", "moving", "progress", "state", "target"],
    await names(session, id("/device/EXLINE_MB_AGV")));
  const description = await session.read({ nodeId: id("EXLINE_MB_AGV_O_P1"), attributeId: AttributeIds.Description });
  check("the description of a symbol", "operation (PLC -> plant), Y0000", description.value.value.text);
  const type = await session.read({ nodeId: id("EXLINE_MB_AGV_O_P1"), attributeId: AttributeIds.DataType });
  check("the type of a BOOL symbol", "ns=0;i=1", type.value.value.toString());
  const levels = await session.read([id("EXLINE_MB_AGV_O_P1"), id("EXLINE_MB_AGV_I_P1")].map((nodeId) => ({ nodeId, attributeId: AttributeIds.UserAccessLevel })));
  check("operations may be written, events not", [3, 1], levels.map((level) => level.value.value));
  const most = await session.read({ nodeId: "ns=0;i=11705", attributeId: AttributeIds.Value });
  check("MaxNodesPerRead is at least the number of symbols", true, most.value.value >= 100);
}

async function operateTheCell(session) {
  check("a write of an operation", "Good", await write(session, "EXLINE_MB_AGV_O_P2", DataType.Boolean, true));
  await until("the vehicle leaves P1", { value: false, status: "Good" }, () => read(session, "EXLINE_MB_AGV_I_P1"));
  await until("its state while it moves", true, () => value(session, "/device/EXLINE_MB_AGV/moving"));
  await until("the vehicle arrives at P2", { value: true, status: "Good" }, () => read(session, "EXLINE_MB_AGV_I_P2"));
  check("its state", "P2", await value(session, "/device/EXLINE_MB_AGV/state"));
  check("a write of an event", "BadNotWritable", await write(session, "EXLINE_MB_AGV_I_P1", DataType.Boolean, true));
  check("a write of another type", "BadTypeMismatch", await write(session, "EXLINE_MB_AGV_O_P2", DataType.Double, 1.5));
  check("a node that is not there", "BadNodeIdUnknown", (await read(session, "EXLINE_MB_AGV_I_P9")).status);
}

/// What a subscription reports of a node, as "value status".
async function reports(session, name, settings = {}) {
  const subscription = opcua.ClientSubscription.create(session, { requestedPublishingInterval: 10, requestedLifetimeCount: 10000, requestedMaxKeepAliveCount: 100, maxNotificationsPerPublish: 0, publishingEnabled: true, priority: 1 });
  const item = opcua.ClientMonitoredItem.create(subscription, { nodeId: id(name), attributeId: AttributeIds.Value }, { samplingInterval: 10, discardOldest: true, queueSize: 100, ...settings }, opcua.TimestampsToReturn.Both);
  const seen = [];
  item.on("changed", (data) => seen.push(`${data.value.value} ${data.statusCode.name}`));
  await new Promise((resolve) => item.on("initialized", resolve));
  return { seen, item, subscription };
}

async function subscribeToTheCell(session) {
  const events = await reports(session, "EXLINE_MB_AGV_I_P2");
  check("a symbol needs no sampling interval", 0, events.item.monitoringParameters.samplingInterval);
  await until("the first report", ["true Good"], () => events.seen);
  await write(session, "EXLINE_MB_AGV_O_P2", DataType.Boolean, false);
  await write(session, "EXLINE_MB_AGV_O_P1", DataType.Boolean, true);
  await until("the change is reported", ["true Good", "false Good"], () => events.seen);
  const clock = await reports(session, "EXLINE_MB_AGV_I_P1");
  await until("the vehicle is back", "true Good", () => clock.seen.at(-1));
  await events.subscription.terminate();
  await clock.subscription.terminate();
}

async function callMethods(session) {
  const sensor = await reports(session, "EXLINE_MB_AGV_I_P1");
  await until("the sensor before", ["true Good"], () => sensor.seen);
  const started = await call(session, "StartMalfunction", text("EXLINE_MB_AGV_I_P1 stuck off"));
  check("a malfunction starts", "Good", started.statusCode.name);
  await until("the event is bad while it is stuck", ["true Good", "false BadSensorFailure"], () => sensor.seen);
  check("so says a read", { value: null, status: "BadSensorFailure" }, { value: null, status: (await read(session, "EXLINE_MB_AGV_I_P1")).status });
  check("a malfunction ends", "Good", (await call(session, "EndMalfunction", text("exline_mb_agv_i_p1 stuck off"))).statusCode.name);
  await until("the event is good again", ["true Good", "false BadSensorFailure", "true Good"], () => sensor.seen);
  await sensor.subscription.terminate();
  check("a malfunction that the plant does not have", "BadInvalidArgument", (await call(session, "StartMalfunction", text("no such"))).statusCode.name);

  check("the plant freezes", "Good", (await call(session, "Freeze")).statusCode.name);
  await until("it says so", true, () => value(session, "/plant/Frozen"));
  const frozenAt = await value(session, "/plant/PlantTime");
  await pause(100);
  check("plant time does not advance", frozenAt, await value(session, "/plant/PlantTime"));
  check("a step of no cycle", "BadInvalidArgument", (await call(session, "Step", { dataType: DataType.UInt32, value: 0 })).statusCode.name);
  check("steps", "Good", (await call(session, "Step", { dataType: DataType.UInt32, value: 5 })).statusCode.name);
  await until("five cycles of 10 ms", 50, async () => Math.round(1000 * ((await value(session, "/plant/PlantTime")) - frozenAt)));
  const ran = await call(session, "Run");
  check("the plant runs, and nothing else freezes it", ["Good", false], [ran.statusCode.name, ran.outputArguments[0].value]);
  await until("it says so", false, () => value(session, "/plant/Frozen"));
}

async function cell() {
  const trace = join(folder, "trace.jsonl");
  const plant = new RunningPlant(symplant, join(examples, "cell/plant.json"), "opc-ua-server://127.0.0.1:0", "--trace", trace);
  const port = await plant.port();
  const connection = await connected(port);
  await browseTheCell(connection.session);
  await operateTheCell(connection.session);
  await subscribeToTheCell(connection.session);
  await callMethods(connection.session);
  await closed(connection);
  check("the run ends, with the requirement on a machine that no program starts", 1, await plant.stop());
  const acts = readFileSync(trace, "utf-8").split("\n").filter((line) => line.includes('"act"') && line.includes("stuck off")).map((line) => JSON.parse(line));
  check("the trace has the malfunction as acts by hand", [[{ start: ["EXLINE_MB_AGV_I_P1 stuck off"] }, "hand"], [{ stop: ["EXLINE_MB_AGV_I_P1 stuck off"] }, "hand"]], acts.map((line) => [line.act, line.by]));
}

async function tank() {
  const plant = new RunningPlant(symplant, join(examples, "gallery/tank/plant.json"), "opc-ua-server://127.0.0.1:0");
  const connection = await connected(await plant.port());
  const { session } = connection;
  check("the values", ["leak", "level", "outflow"], await names(session, id("/values")));
  const level = await read(session, "/value/level");
  check("a value has a number", ["number", "Good"], [typeof level.value, level.status]);
  check("the properties of a value with limits", ["EURange", "EngineeringUnits"], await names(session, id("/value/level")));
  const unit = await session.read({ nodeId: id("/value/level/EngineeringUnits"), attributeId: AttributeIds.Value });
  check("its unit is the litre of UN/CEFACT", ["l", 0x4C5452], [unit.value.value.displayName.text, unit.value.value.unitId]);
  const range = await session.read({ nodeId: id("/value/level/EURange"), attributeId: AttributeIds.Value });
  check("its range", [0, 120], [range.value.value.low, range.value.value.high]);
  await closed(connection);
  check("the run ends well", 0, await plant.stop());
}

async function refused(port, more, user) {
  try {
    await closed(await connected(port, more, user));
    return "connected";
  } catch (error) {
    return /Bad[A-Za-z]+/.exec(error.message)?.[0] ?? "refused";
  }
}

async function security() {
  const password = join(folder, "password");
  writeFileSync(password, "secret\n");
  const plant = new RunningPlant(symplant, join(examples, "cell/plant.json"), `opc-ua-server://127.0.0.1:0?security=encrypt&user=scada&password-file=${password}`);
  const port = await plant.port();
  const secure = { securityMode: opcua.MessageSecurityMode.SignAndEncrypt, securityPolicy: opcua.SecurityPolicy.Basic256Sha256 };
  const user = { type: UserTokenType.UserName, userName: "scada", password: "secret" };
  const connection = await connected(port, secure, user);
  check("a user reads over an encrypted channel", "Good", (await read(connection.session, "EXLINE_MB_AGV_I_P1")).status);
  await closed(connection);
  check("a wrong password", "BadUserAccessDenied", await refused(port, secure, { ...user, password: "wrong" }));
  check("without a user", true, (await refused(port, secure)) !== "connected");
  check("without security", true, (await refused(port, {}, user)) !== "connected");
  check("the run ends well", 0, await plant.stop());
  check("the plant names its certificate and what was refused", [true, true], [/thumbprint [0-9A-F]{40}/.test(plant.text), plant.text.includes("with the user name `scada` and a wrong password")]);
}

async function restart() {
  let plant = new RunningPlant(symplant, join(examples, "cell/plant.json"), "opc-ua-server://127.0.0.1:0");
  const port = await plant.port();
  const connection = await connected(port, { connectionStrategy: { maxRetry: -1, initialDelay: 100, maxDelay: 300 } });
  const events = await reports(connection.session, "EXLINE_MB_AGV_I_P1");
  await until("the first report", ["true Good"], () => events.seen);
  await plant.stop("SIGKILL");
  plant = new RunningPlant(symplant, join(examples, "cell/plant.json"), `opc-ua-server://127.0.0.1:${port}`);
  await plant.port();
  events.seen.length = 0;
  await until("after a restart the client's subscription goes on by itself", "true Good", () => events.seen.at(-1));
  await closed(connection);
  check("the run ends well", 0, await plant.stop());
  check("a client that comes back is not one too many", false, plant.text.includes("as many sessions as allowed") || plant.text.includes("lack of room"));
}

try {
  await cell();
  await tank();
  await security();
  await restart();
} catch (error) {
  console.log("FAILED:", error.stack);
  process.exit(1);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit(exitCode());

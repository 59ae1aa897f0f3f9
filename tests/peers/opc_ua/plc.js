// A small PLC in npm's node-opcua: a server with variables, and a program that runs the cell of examples/cell.
//
// usage: node plc.js PACKAGES SETTINGS
//
// SETTINGS is a JSON object: `port`; `variables`, each with `name`, `type` and `writes` (the client may write it); `cell`
// (true: the program of the cell runs); `limit` (nodes in a request); `security` (true: only Basic256Sha256 with the user
// `plant` and the password `secret`); `folder` for certificates. Node ids are those of an S7-1500: ns=3;s="NAME".
// Prints a JSON object a line: {"port": 4840}, {"round": 1}. Ends at the end of standard input.
"use strict";
const path = require("path");

const opcua = require(path.join(process.argv[2], "node_modules", "node-opcua"));
const settings = JSON.parse(process.argv[3]);

function say(object) {
  process.stdout.write(JSON.stringify(object) + "\n");
}

function options() {
  const all = {
    port: settings.port,
    host: "127.0.0.1",
    alternateHostname: "127.0.0.1",
    serverInfo: { applicationUri: "urn:small:plc", productUri: "urn:small", applicationName: { text: "small PLC" } },
    buildInfo: { productName: "cell controller", manufacturerName: "tests", softwareVersion: "1.2" },
    serverCertificateManager: new opcua.OPCUACertificateManager({
      rootFolder: path.join(settings.folder, "pki"), automaticallyAcceptUnknownCertificate: !settings.strict }),
  };
  if (settings.limit) {
    all.serverCapabilities = { operationLimits: { maxNodesPerRead: settings.limit, maxNodesPerWrite: settings.limit,
                                                  maxNodesPerRegisterNodes: settings.limit } };
  }
  if (settings.security) {
    all.securityPolicies = [opcua.SecurityPolicy.Basic256Sha256];
    all.securityModes = [opcua.MessageSecurityMode.SignAndEncrypt];
    all.allowAnonymous = false;
    all.userManager = { isValidUser: (user, password) => user === "plant" && password === "secret" };
  }
  return all;
}

/// The variables by name: their values are plain JavaScript.
function variables(server) {
  const addressSpace = server.engine.addressSpace;
  addressSpace.registerNamespace("urn:small:other"); // so that the variables are in namespace 3, as those of an S7-1500
  const namespace = addressSpace.registerNamespace("http://www.siemens.com/simatic-s7-opcua");
  const folder = namespace.addFolder(addressSpace.rootFolder.objects, { browseName: "Tags" });
  const values = {};
  for (const { name, type, writes, initial } of settings.variables) {
    const dataType = opcua.DataType[type];
    values[name] = initial ?? (type === "Boolean" ? false : type.endsWith("Int64") ? [0, 0] : 0);
    namespace.addVariable({
      componentOf: folder,
      browseName: name,
      nodeId: `s="${name}"`,
      dataType: type,
      accessLevel: writes ? "CurrentRead | CurrentWrite" : "CurrentRead",
      userAccessLevel: writes ? "CurrentRead | CurrentWrite" : "CurrentRead",
      minimumSamplingInterval: 10,
      value: {
        get: () => new opcua.Variant({ dataType, arrayType: opcua.VariantArrayType.Scalar, value: values[name] }),
        set: (variant) => {
          values[name] = variant.value;
          return opcua.StatusCodes.Good;
        },
      },
    });
  }
  return values;
}

/// The vehicle drives to the machine, which works, and back, again and again. A scan every 20 ms.
function runCell(io) {
  const states = {
    toMachine: () => {
      io.EXLINE_MB_AGV_O_P2 = true;
      return io.EXLINE_MB_AGV_I_P2 ? "start" : "toMachine";
    },
    start: () => {
      io.EXLINE_MB_AGV_O_P2 = false;
      io.EXLINE_MB_MC_O_RUN2 = true;
      return io.EXLINE_MB_MC_I_RUN2 ? "work" : "start";
    },
    work: () => {
      io.EXLINE_MB_MC_O_RUN2 = false;
      return io.EXLINE_MB_MC_I_IDLE1 ? "toStore" : "work";
    },
    toStore: () => {
      io.EXLINE_MB_AGV_O_P1 = true;
      if (!io.EXLINE_MB_AGV_I_P1) return "toStore";
      io.EXLINE_MB_AGV_O_P1 = false;
      rounds += 1;
      say({ round: rounds });
      return "toMachine";
    },
  };
  let rounds = 0;
  let state = "toMachine";
  setInterval(() => {
    const next = states[state]();
    if (next !== state) say({ state: next });
    state = next;
  }, 20);
}

async function main() {
  const server = new opcua.OPCUAServer(options());
  await server.initialize();
  const values = variables(server);
  await server.start();
  say({ port: server.endpoints[0].port });
  if (settings.cell) runCell(values);
  process.stdin.on("end", () => server.shutdown().then(() => process.exit(0)));
  process.stdin.on("data", (text) => {
    for (const line of text.toString().split("\n").filter((one) => one !== "")) Object.assign(values, JSON.parse(line));
  });
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});

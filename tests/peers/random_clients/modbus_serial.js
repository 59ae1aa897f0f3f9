// npm's modbus-serial as a servant: takes a call a line, as JSON, from standard input, and answers with a line.
//
// usage: node modbus_serial.js PACKAGES PORT
//
// A call is [method, argument...] of modbus-serial's client; the answer {"value": ...} or {"exception": code} or {"error": text}.
"use strict";
const path = require("path");
const readline = require("readline");

const ModbusRTU = require(path.join(process.argv[2], "node_modules", "modbus-serial"));

async function answer(client, line) {
  const [method, ...args] = JSON.parse(line);
  try {
    return { value: await client[method](...args) };
  } catch (error) {
    return error.modbusCode === undefined ? { error: String(error.message) } : { exception: error.modbusCode };
  }
}

async function main() {
  const client = new ModbusRTU();
  client.setTimeout(20000);
  await client.connectTCP("127.0.0.1", { port: Number(process.argv[3]) });
  client.setID(255);
  for await (const line of readline.createInterface({ input: process.stdin })) {
    process.stdout.write(JSON.stringify(await answer(client, line)) + "\n");
  }
  client.close(() => process.exit(0));
}

main();

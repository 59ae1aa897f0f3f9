// npm's mcprotocol reads items by 3E frames in binary; prints their values as a JSON object.
//
// usage: node mcprotocol.js PACKAGES PORT OCTAL ITEM...
//
// OCTAL: whether numbers of X and Y are octal, otherwise decimal. An ITEM is `M0,160`: the first device, and how many.
"use strict";
const path = require("path");

console.log = console.error; // the package logs to standard output
const MCProtocol = require(path.join(process.argv[2], "node_modules", "mcprotocol"));
const [port, octal, ...items] = process.argv.slice(3);

const client = new MCProtocol();
const options = { host: "127.0.0.1", port: Number(port), frame: "3E", ascii: false, octalInputOutput: octal === "true" };
client.initiateConnection(options, (error) => {
  if (error !== undefined) {
    console.error(error);
    process.exit(1);
  }
  client.addItems(items);
  client.readAllItems((bad, values) => {
    process.stdout.write(JSON.stringify(values) + "\n", () => process.exit(bad ? 1 : 0));
  });
});

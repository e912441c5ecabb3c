// node wasm.js FOLDER: the planner of a page without a browser. A request a line, an answer a line; first the glue runs
// as in a worker.
"use strict";
const fs = require("fs"), folder = process.argv[2];
Object.defineProperty(globalThis, "self", {value: globalThis, configurable: true});
Object.defineProperty(globalThis, "location", {value: {href: ""}, configurable: true});
(0, eval)(fs.readFileSync(folder + "/taut.js", "utf8"));
self.tautReady(new Uint8Array(fs.readFileSync(folder + "/taut.wasm"))).then((answer) => {
  require("readline").createInterface({input: process.stdin}).on("line", (line) => {
    process.stdout.write(answer(line) + "\n");
  });
}, (error) => {
  console.error(error);
  process.exit(1);
});

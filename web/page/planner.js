"use strict";
// Who answers: the planner as WebAssembly in a worker, the program behind `taut view --serve`, or, without either, what
// the program answered when it wrote the page. All three speak as web/session.h says.

// Evaluated in the worker, behind emscripten's glue: self.tautReady(bytes) is to give the function that answers.
const kWorker = `
let answer = null;
onmessage = async ({data}) => {
  try {
    if (data.wasm) answer = await self.tautReady(data.wasm);
    else postMessage({id: data.id, text: answer(data.text)});
    if (data.wasm) postMessage({id: data.id, text: "{}"});
  } catch (error) { postMessage({id: data.id, text: JSON.stringify({error: String(error)})}); }
};`;

function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}

function unpacked(bytes) {
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

class WasmPlanner {
  constructor(base64, glue) {
    this.name = "wasm";
    this.waiting = new Map();
    this.next = 1;
    this.worker = new Worker(URL.createObjectURL(new Blob([glue, kWorker], {type: "text/javascript"})));
    this.worker.onmessage = ({data}) => {
      this.waiting.get(data.id)(data.text);
      this.waiting.delete(data.id);
    };
    this.worker.onerror = (event) => {
      for (const tell of this.waiting.values()) tell(JSON.stringify({error: event.message || "the worker failed"}));
    };
    this.ready = unpacked(bytesOf(base64)).then((wasm) => this.post({wasm}, [wasm]));
  }
  post(message, moved = []) {
    return new Promise((tell) => {
      this.waiting.set(this.next, (text) => tell(JSON.parse(text)));
      this.worker.postMessage({...message, id: this.next++}, moved);
    });
  }
  async ask(request) { return request.do === "load" && this.world || this.post({text: JSON.stringify(request)}); }
}

class ServerPlanner {
  constructor(address) {
    this.name = "server";
    this.address = address;
    this.ready = Promise.resolve({});
  }
  async ask(request) {
    try {
      const answer = await fetch(this.address, {method: "POST", body: JSON.stringify(request)});
      return answer.ok ? await answer.json() : {error: `the program says ${answer.status}`};
    } catch { return {error: "the program that answers has ended"}; }
  }
}

class StillPlanner {
  constructor(still) {
    this.name = "still";
    this.still = still;
    this.ready = Promise.resolve({});
  }
  async ask(request) {
    const kept = request.do === "layer" ? this.still.layers?.[request.name] : this.still[request.do === "load" ? "world" : request.do];
    return kept ?? {error: "this page holds a picture, not the planner"};
  }
}

// The planner in the page, once it has passed its own test and read the world; else why not.
async function wasmPlanner(page, base64, glue) {
  try {
    if (!window.Worker || !window.WebAssembly) throw "this browser runs no WebAssembly";
    const wasm = new WasmPlanner(base64, glue), begun = await wasm.ready;
    if (begun.error) throw begun.error;
    const test = await wasm.ask({do: "self-test"});
    if (!test.passed) throw test.error ?? "the self-test failed: " + test.checks.filter((c) => !c.passed).map((c) => c.what).join(", ");
    const world = await wasm.ask(page.load);
    if (world.error) throw world.error;
    wasm.world = world;
    return {wasm};
  } catch (why) { return {why: String(why)}; }
}

async function planner(page) {
  const base64 = document.getElementById("taut-wasm").textContent.trim();
  if (page.server && location.protocol.startsWith("http")) return new ServerPlanner(page.server);
  if (!base64) return new StillPlanner(page.still);
  const {wasm, why} = await wasmPlanner(page, base64, document.getElementById("taut-glue").textContent);
  return wasm ?? Object.assign(new StillPlanner(page.still), {why});
}

// Of a drag only the newest question matters: one is under way, one waits, what lay between is dropped.
class Newest {
  constructor(work) { this.work = work; this.busy = false; this.waiting = null; }
  ask(request) {
    if (this.busy) { this.waiting = request; return; }
    this.busy = true;
    this.work(request).finally(() => {
      this.busy = false;
      const next = this.waiting;
      this.waiting = null;
      if (next) this.ask(next);
    });
  }
}

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
    const wasm = bytesOf(base64);
    this.ready = this.post({wasm}, [wasm.buffer]);
  }
  post(message, moved = []) {
    return new Promise((tell) => {
      this.waiting.set(this.next, (text) => tell(JSON.parse(text)));
      this.worker.postMessage({...message, id: this.next++}, moved);
    });
  }
  ask(request) { return this.post({text: JSON.stringify(request)}); }
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

// The first that passes its own test.
async function planner(page) {
  const base64 = document.getElementById("taut-wasm").textContent.trim();
  const glue = document.getElementById("taut-glue").textContent;
  if (page.server && location.protocol.startsWith("http")) return new ServerPlanner(page.server);
  if (base64 && window.Worker) {
    const wasm = new WasmPlanner(base64, glue);
    const begun = await wasm.ready;
    const test = begun.error ? begun : await wasm.ask({do: "self-test"});
    if (test.passed) return wasm;
    return Object.assign(new StillPlanner(page.still), {
      why: test.error ?? "the self-test failed: " + test.checks.filter((c) => !c.passed).map((c) => c.what).join(", ")});
  }
  return new StillPlanner(page.still);
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

// Answers the page in the browser itself: the engine is compiled for it, and computes in a worker beside the page.

import { byId } from "./dom.js";
import { answerBy } from "./engine.js";

/** What takes longer is ended, in milliseconds. */
const LONGEST = 30000;

/** The program of the worker. */
const WORKER = `
let engine = null;
const question = (operation, body) => {
  const bytes = new TextEncoder().encode(operation + "\\n" + body);
  const at = engine.question(bytes.length);
  new Uint8Array(engine.memory.buffer, at, bytes.length).set(bytes);
  const length = engine.answer();
  return new TextDecoder().decode(new Uint8Array(engine.memory.buffer, engine.answer_at(), length));
};
onmessage = async ({ data }) => {
  if (data.module) {
    // What libraries might ask of a browser (random numbers for archives), and the page has no use for.
    const imports = {};
    for (const { module, name } of WebAssembly.Module.imports(data.module)) {
      imports[module] = { ...imports[module], [name]: () => { throw new Error(name + " is not there"); } };
    }
    engine = (await WebAssembly.instantiate(data.module, imports)).exports;
    return postMessage({ ready: true });
  }
  try {
    postMessage({ answer: question(data.operation, data.body) });
  } catch (error) {
    postMessage({ failed: String(error) });
  }
};
`;

const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));

/** The engine, unpacked once. */
const compiled = (async () => {
  const packed = Uint8Array.from(atob(globalThis.SHTAERMAN_ENGINE), (one) => one.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
})();

class Worked {
  static async start() {
    const worked = new Worked();
    worked.worker = new Worker(address);
    worked.worker.postMessage({ module: await compiled });
    await worked.reply();
    return worked;
  }

  reply() {
    return new Promise((resolve, reject) => {
      this.worker.onmessage = ({ data }) => resolve(data);
      this.worker.onerror = (event) => reject(new Error(event.message));
    });
  }
}

/** Two of them, so that a map that takes long does not keep a curve waiting. */
const idle = [];
const waiting = [];
let count = 0;

async function taken() {
  if (idle.length) return idle.pop();
  if (count < 2) {
    count += 1;
    return Worked.start();
  }
  return new Promise((resolve) => waiting.push(resolve));
}

function give(worked) {
  const next = waiting.shift();
  if (next) next(worked);
  else idle.push(worked);
}

async function inBrowser(operation, question, signal) {
  const worked = await taken();
  if (signal?.aborted) {
    give(worked);
    throw new DOMException("ended", "AbortError");
  }
  let end = null;
  const ended = new Promise((_, reject) => {
    end = reject;
  });
  const abort = () => end(new DOMException("ended", "AbortError"));
  signal?.addEventListener("abort", abort);
  const timer = setTimeout(() => end(new Error("late")), LONGEST);
  worked.worker.postMessage({ operation, body: JSON.stringify(question ?? {}) });
  try {
    const told = await Promise.race([worked.reply(), ended]);
    if (told.failed) throw new Error(told.failed);
    give(worked);
    return JSON.parse(told.answer);
  } catch (error) {
    // What hangs is ended, what has failed may be in no good state: another takes its place.
    worked.worker.terminate();
    Worked.start().then(give);
    if (error.name === "AbortError") throw error;
    const message = error.message === "late" ? `this took longer than ${LONGEST / 1000} s and was ended` : `the engine failed: ${error.message}`;
    return { fault: { message, what: message } };
  } finally {
    clearTimeout(timer);
    signal?.removeEventListener("abort", abort);
  }
}

answerBy(inBrowser);
byId("where").textContent = "All computing is done in this browser.";

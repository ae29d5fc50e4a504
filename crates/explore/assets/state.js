// The problem on the page: the tree of its file, the files that it names, and how it came to be.

import { settled } from "./dom.js";
import { toml } from "./toml.js";

/** Changes are one step of undoing when they follow each other within this time, in milliseconds. */
const STEP = 500;
const MOST_STEPS = 200;
/** A longer link is not written into the address; the button still copies it. */
const LONGEST_ADDRESS = 60000;

class State extends EventTarget {
  name = "punch.toml";
  tree = {};
  /** Contents by names, each byte a character of the same number. */
  files = {};
  /** Heights of a base drawn by hand, in metres at even places from edge to edge. */
  drawn = null;
  tab = "contact";
  /** SI values by dotted keys, as the program read them last. */
  si = {};
  #past = [];
  #future = [];
  #now = "";

  /** The value at a dotted key. */
  get(path) {
    return path.split(".").reduce((table, key) => (table && typeof table === "object" ? table[key] : undefined), this.tree);
  }

  /** Sets the value at a dotted key, or takes it away where it is undefined. */
  set(path, value) {
    const keys = path.split(".");
    const last = keys.pop();
    let table = this.tree;
    for (const key of keys) {
      if (typeof table[key] !== "object" || table[key] === null) table[key] = {};
      table = table[key];
    }
    if (value === undefined) delete table[last];
    else table[last] = value;
  }

  /** Puts one key in the place of others, where the first of them stood. */
  swap(table, gone, key, value) {
    const old = this.get(table) ?? {};
    const entries = Object.entries(old);
    const at = entries.findIndex(([name]) => gone.includes(name) || name === key);
    const kept = entries.filter(([name]) => !gone.includes(name) && name !== key);
    kept.splice(at < 0 ? kept.length : Math.min(at, kept.length), 0, [key, value]);
    this.set(table, Object.fromEntries(kept.filter(([, one]) => one !== undefined)));
  }

  /** The file. */
  toml() {
    return toml(this.tree);
  }

  /** What the program is asked about. */
  question() {
    return { name: this.name, toml: this.toml(), files: this.files };
  }

  /** Whether the file has no dimensions. */
  get isDimensionless() {
    return "dimensionless" in this.tree;
  }

  /** The table of geometry and profile. */
  get punch() {
    return this.isDimensionless ? "dimensionless" : "punch";
  }

  /** The half-width or the radius as the program read it last. */
  get halfWidth() {
    if (this.isDimensionless) return 1;
    const key = ["half_width", "outer_half_width", "radius"].find((one) => this.si[`punch.${one}`] !== undefined);
    if (key) return this.si[`punch.${key}`];
    return 0.5 * (this.si["punch.period"] ?? NaN);
  }

  /** Tells all who show the problem; `what` says what they need not build anew. */
  changed(what = {}) {
    this.dispatchEvent(new CustomEvent("change", { detail: what }));
    this.#remember();
  }

  /** Another problem. */
  replace({ name, tree, files, drawn }) {
    Object.assign(this, { name: name ?? this.name, tree, files: files ?? {}, drawn: drawn ?? null });
    this.changed({ isNew: true });
  }

  get canUndo() {
    return this.#past.length > 0 || this.#snapshot() !== this.#now;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  undo() {
    this.#take();
    if (this.#past.length === 0) return;
    this.#future.push(this.#now);
    this.#restore(this.#past.pop());
  }

  redo() {
    this.#take();
    if (this.#future.length === 0) return;
    this.#past.push(this.#now);
    this.#restore(this.#future.pop());
  }

  #snapshot() {
    const { name, tree, files, drawn } = this;
    return JSON.stringify({ name, tree, files, drawn });
  }

  #restore(text) {
    this.#now = text;
    Object.assign(this, JSON.parse(text));
    this.changed({ isNew: true });
  }

  /** Makes a step of what has changed. */
  #take() {
    const now = this.#snapshot();
    if (now === this.#now) return;
    if (this.#now) this.#past.push(this.#now);
    this.#past.splice(0, this.#past.length - MOST_STEPS);
    this.#future = [];
    this.#now = now;
  }

  #remember = settled(async () => {
    this.#take();
    this.dispatchEvent(new Event("step"));
    const link = await this.link();
    if (link.length < LONGEST_ADDRESS) history.replaceState(null, "", `#${link}`);
  }, STEP);

  /** The state as a part of an address. */
  async link() {
    const { name, tree, files, drawn, tab } = this;
    const bytes = new TextEncoder().encode(JSON.stringify({ name, tree, files, drawn, tab }));
    const packed = await through(bytes, new CompressionStream("deflate-raw"));
    let binary = "";
    for (let i = 0; i < packed.length; i += 8192) binary += String.fromCharCode(...packed.subarray(i, i + 8192));
    return `1${btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
  }

  /** Takes what a link holds; false where it holds nothing. */
  async open(link) {
    if (!link.startsWith("1")) return false;
    try {
      const binary = atob(link.slice(1).replaceAll("-", "+").replaceAll("_", "/"));
      const packed = Uint8Array.from(binary, (one) => one.charCodeAt(0));
      const bytes = await through(packed, new DecompressionStream("deflate-raw"));
      const held = JSON.parse(new TextDecoder().decode(bytes));
      if (typeof held.tree !== "object" || held.tree === null) return false;
      this.tab = held.tab ?? "contact";
      this.replace(held);
      return true;
    } catch {
      return false;
    }
  }
}

async function through(bytes, stream) {
  const writer = stream.writable.getWriter();
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  return new Uint8Array(await new Response(stream.readable).arrayBuffer());
}

export const state = new State();

// Controls of the form: a quantity with its slider, a choice, a list.

import { html, unique } from "./dom.js";
import { state } from "./state.js";
import { digits, inUnitOf, quantity, written } from "./units.js";

const STEPS = 1000;
/** A slider that came to its end goes on from there: its range follows. */
const NEAR_END = 0.015;
const DIGITS = 3;

/** How a slider goes: over two decades around the value, between two ends, or to both sides of zero. */
class Range {
  constructor({ scale = "log", min, max, reach }) {
    Object.assign(this, { scale, min, max, reach });
  }

  /** The ends for a value; those there were, while it is well inside. */
  around(value) {
    if (this.scale === "linear") {
      [this.low, this.high] = [this.min, this.max];
      return;
    }
    if (this.scale === "signed") {
      const reach = Math.abs(this.reach?.() ?? 0) || this.high || 1;
      const size = Math.max(reach, Math.abs(value) || 0);
      [this.low, this.high] = [-size, size];
      return;
    }
    if (!(value > 0)) {
      this.low ??= this.min ?? 1e-3;
      this.high ??= this.max ?? 1e3;
      return;
    }
    const share = this.low > 0 ? this.share(value) : -1;
    if (share > NEAR_END && share < 1 - NEAR_END) return;
    [this.low, this.high] = [value / 10, value * 10];
    if (this.min !== undefined) this.low = Math.max(this.low, this.min);
    if (this.max !== undefined) this.high = Math.min(this.high, this.max);
  }

  share(value) {
    if (this.scale === "log") return Math.log(value / this.low) / Math.log(this.high / this.low);
    return (value - this.low) / (this.high - this.low);
  }

  value(share) {
    if (this.scale === "log") return Number((this.low * (this.high / this.low) ** share).toPrecision(DIGITS));
    const step = (this.high - this.low) / 200;
    const power = 10 ** Math.floor(Math.log10(step));
    const value = Math.round((this.low + share * (this.high - this.low)) / power) * power;
    return Number(value.toPrecision(6));
  }
}

/** A quantity of the file: text with a unit, and a slider where there is a range. */
export class Quantity {
  constructor({ path, label, symbol, kind = "none", range, hint }) {
    Object.assign(this, { path, kind, name: label });
    const id = unique("q");
    this.range = range ? new Range(range) : null;
    this.text = html("input", { type: "text", id, spellcheck: "false", autocapitalize: "off", "aria-describedby": `${id}-fault`, "data-key": path });
    this.slider = this.range && html("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": `${label}, slider`, "data-key": `${path} slider` });
    this.fault = html("p", { class: "fault", id: `${id}-fault` });
    this.fault.hidden = true;
    this.element = html(
      "div",
      { class: "field", "data-path": path },
      html("label", { for: id }, label, symbol && html("span", { class: "symbol" }, symbol)),
      this.text,
      this.slider,
      hint && html("p", { class: "hint wide" }, hint),
      this.fault,
    );
    this.text.addEventListener("input", () => {
      state.set(path, written(this.text.value));
      state.changed({ by: this.text });
    });
    this.slider?.addEventListener("input", () => this.#slide());
    this.slider?.addEventListener("change", () => {
      this.range.around(state.si[path]);
      this.#place(state.si[path]);
      state.changed({ by: this.slider });
    });
    this.sync();
  }

  #slide() {
    const value = this.range.value(Number(this.slider.value) / STEPS);
    const text = inUnitOf(state.get(this.path) ?? "", state.si[this.path], value, this.kind, DIGITS);
    state.set(this.path, written(text));
    state.si[this.path] = value;
    this.text.value = text;
    this.slider.setAttribute("aria-valuetext", text);
    state.changed({ by: this.slider, isMoving: true });
  }

  #place(value) {
    if (!this.slider) return;
    const share = this.range.share(value);
    this.slider.value = Number.isFinite(share) ? Math.round(STEPS * Math.min(1, Math.max(0, share))) : STEPS / 2;
    this.slider.setAttribute("aria-valuetext", this.text.value);
  }

  /** Shows what the file has; what is being typed or moved stays. */
  sync() {
    const value = state.get(this.path);
    const isTyped = document.activeElement === this.text;
    if (!isTyped) this.text.value = value === undefined ? "" : typeof value === "number" ? digits(value, 12) : String(value);
    const isMoved = document.activeElement === this.slider;
    const si = state.si[this.path];
    if (this.slider && si !== undefined) {
      if (!isMoved || !(this.range.high > this.range.low)) this.range.around(si);
      if (!isMoved) this.#place(si);
    }
  }

  /** Says what is wrong, or that nothing is. */
  blame(text) {
    this.fault.textContent = text ?? "";
    this.fault.hidden = !text;
    if (text) this.text.setAttribute("aria-invalid", "true");
    else this.text.removeAttribute("aria-invalid");
  }
}

/** One of some: a row of buttons, `[[value, label], ...]`. */
export function choice({ label, options, value, key, chosen }) {
  const name = unique("choice");
  const id = `${name}-label`;
  return html(
    "div",
    { class: "field whole" },
    html("span", { class: label.startsWith("*") ? "unseen" : "label", id }, label.replace("*", "")),
    html(
      "div",
      { class: "choice", role: "radiogroup", "aria-labelledby": id },
      options.map(([one, text]) => html("label", {}, html("input", { type: "radio", name, value: one, checked: one === value, "data-key": `${key} ${one}`, onchange: () => chosen(one) }), html("span", {}, text))),
    ),
  );
}

/** One of many: a list, `[[value, label], ...]`. */
export function list({ label, options, value, key, chosen }) {
  const id = unique("list");
  const select = html("select", { id, "data-key": key, onchange: () => chosen(select.value) }, options.map(([one, text]) => html("option", { value: one, selected: one === value }, text)));
  return html("div", { class: "field pick" }, html("label", { for: id }, label), select);
}

/** Yes or no. */
export function check({ label, value, key, chosen }) {
  const box = html("input", { type: "checkbox", checked: value, "data-key": key, onchange: () => chosen(box.checked) });
  return html("label", { class: "check" }, box, label);
}

/** A slider for a number that is in no file; `moved` hears of each step. */
export class Slider {
  constructor({ label, value, range, kind = "none", moved, isWhole = false }) {
    Object.assign(this, { value, kind });
    this.range = new Range(range);
    if (range.scale === "log" && range.fixed) [this.range.low, this.range.high] = [range.min, range.max];
    else this.range.around(value);
    const id = unique("s");
    this.output = html("output", { for: id }, "");
    this.input = html("input", { type: "range", id, min: 0, max: STEPS, step: 1 });
    this.element = html("div", { class: "slide" }, html("label", { for: id }, label, " = ", this.output), this.input);
    const show = () => {
      const text = quantity(this.value, kind);
      this.output.textContent = text;
      this.input.setAttribute("aria-valuetext", text);
    };
    this.input.value = Math.round(STEPS * this.range.share(value));
    this.input.addEventListener("input", () => {
      const found = this.range.value(Number(this.input.value) / STEPS);
      this.value = isWhole ? Math.round(found) : found;
      show();
      moved(this.value);
    });
    show();
  }
}

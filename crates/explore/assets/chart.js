// Curves in a pair of axes, as SVG: drawn anew in a few milliseconds, read with the pointer or the arrow keys.

import { become, html, svg, unique } from "./dom.js";
import { digits, logTicks, ticks } from "./units.js";

const LEFT = 62;
const RIGHT = 14;
const TOP = 10;
const BOTTOM = 40;
/** Places of the pointer that the keys step through. */
const KEYS = 200;

/**
 * A chart: `draw` takes `{ x: [from, to], y: [from, to], xLabel, yLabel, layers, description, readings }`, with numbers as they are shown.
 * Layers are `line`, `band`, `area`, `dots`, `vertical`, `horizontal` and `touch`, from back to front. `readings(x)` gives what is to be read at a place: `{ text, dots: [[x, y, class]] }`.
 */
export class Chart {
  constructor(host, { height = 260, reading = null, label = "Chart" } = {}) {
    this.host = host;
    this.height = height;
    this.reading = reading;
    this.clip = unique("clip");
    this.plot = svg("g", {});
    this.overlay = svg("g", {});
    this.svg = svg("svg", { role: "img", "aria-label": label }, this.plot, this.overlay);
    this.keys = html("input", { type: "range", class: "keys", min: 0, max: KEYS, step: 1, value: KEYS / 2, "aria-label": `${label}: place to read` });
    host.append(this.svg, this.keys);
    this.svg.addEventListener("pointermove", (event) => this.#point(this.#placeOf(event)));
    this.svg.addEventListener("pointerdown", (event) => this.#point(this.#placeOf(event)));
    this.svg.addEventListener("pointerleave", () => this.#point(null));
    for (const name of ["input", "focus"]) this.keys.addEventListener(name, () => this.#point(this.#placeOfKeys()));
    this.keys.addEventListener("blur", () => this.#point(null));
    new ResizeObserver(([{ contentRect }]) => {
      this.room = Math.round(contentRect.width);
      if (this.room > 0 && this.room !== this.width && this.content) this.draw(this.content);
    }).observe(host);
  }

  get frame() {
    return { left: LEFT, right: this.width - RIGHT, top: TOP, bottom: this.height - BOTTOM };
  }

  /** From a value to a place in the picture. */
  scale(range, [from, to], isLog) {
    const [a, b] = isLog ? range.map(Math.log10) : range;
    const factor = (to - from) / (b - a || 1);
    return (value) => from + ((isLog ? Math.log10(value) : value) - a) * factor;
  }

  draw(content) {
    this.content = content;
    // To ask the element would lay out the page anew.
    this.width = Math.max(240, this.room || Math.round(this.host.clientWidth) || 600);
    const { left, right, top, bottom } = this.frame;
    this.px = this.scale(content.x, [left, right], content.xLog);
    this.py = this.scale(content.y, content.isDown ? [top, bottom] : [bottom, top], content.yLog);
    const parts = [
      svg("clipPath", { id: this.clip }, svg("rect", { x: left, y: top, width: right - left, height: bottom - top })),
      ...this.#grid(content),
      svg("g", { "clip-path": `url(#${this.clip})` }, content.layers.map((layer) => this.#layer(layer))),
      svg("path", { class: "axis", d: `M${left} ${top}V${bottom}H${right}` }),
      ...(content.over?.(this) ?? []),
    ];
    this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    if (content.description) this.svg.setAttribute("aria-label", content.description);
    become(this.plot, parts);
    this.keys.hidden = !content.readings;
    if (this.at !== undefined && this.at !== null) this.#point(this.at);
  }

  #grid({ x, y, xLabel, yLabel, xLog, yLog, xTicks }) {
    const { left, right, top, bottom } = this.frame;
    const parts = [];
    const across = xTicks ?? (xLog ? logTicks(...x) : ticks(...x, Math.max(3, (right - left) / 70)));
    const up = yLog ? logTicks(...y) : ticks(...y, Math.max(3, (bottom - top) / 42));
    for (const value of across) {
      const at = this.px(value);
      parts.push(svg("path", { class: "grid", d: `M${at} ${top}V${bottom}` }));
      parts.push(svg("text", { x: at, y: bottom + 16, "text-anchor": "middle" }, shown(value)));
    }
    for (const value of up) {
      const at = this.py(value);
      parts.push(svg("path", { class: value === 0 ? "zero" : "grid", d: `M${left} ${at}H${right}` }));
      parts.push(svg("text", { x: left - 8, y: at + 4, "text-anchor": "end" }, shown(value)));
    }
    parts.push(svg("text", { x: (left + right) / 2, y: bottom + 34, "text-anchor": "middle" }, xLabel ?? ""));
    const middle = (top + bottom) / 2;
    parts.push(svg("text", { x: 13, y: middle, "text-anchor": "middle", transform: `rotate(-90 13 ${middle})` }, yLabel ?? ""));
    return parts;
  }

  #layer(layer) {
    const { left, right, top, bottom } = this.frame;
    switch (layer.kind) {
      case "line":
        return svg("path", { class: `line ${layer.class}`, d: this.path(layer.points) });
      case "band":
        return svg("path", { class: `area ${layer.class}`, d: `${this.path(layer.points.map(([x, low]) => [x, low]))}${this.path(layer.points.map(([x, , high]) => [x, high]).reverse(), "L")}Z` });
      case "area": {
        const points = layer.points.filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
        if (!points.length) return null;
        const base = layer.base === "top" ? top : layer.base === "bottom" ? bottom : this.py(layer.base);
        return svg("path", { class: `area ${layer.class}`, "fill-opacity": layer.opacity, d: `${this.path(points)}V${base}H${this.px(points[0][0])}Z` });
      }
      case "dots":
        return layer.points.filter(([, y]) => Number.isFinite(y)).map(([x, y]) => svg("circle", { class: `dot ${layer.class}`, cx: this.px(x), cy: this.py(y), r: layer.radius ?? 3.5 }));
      case "vertical":
        return svg("path", { class: layer.class ?? "mark", d: `M${this.px(layer.at)} ${top}V${bottom}` });
      case "horizontal":
        return svg("path", { class: layer.class ?? "mark", d: `M${left} ${this.py(layer.at)}H${right}` });
      case "touch":
        return svg("path", { class: "touch", d: `M${this.px(layer.from)} ${this.py(layer.at)}H${this.px(layer.to)}` });
      default:
        return null;
    }
  }

  /** A path through points; what is no number breaks it. */
  path(points, start = "M") {
    let drawn = "";
    let pen = start;
    for (const [x, y] of points) {
      const [at, height] = [this.px(x), this.py(y)];
      if (!Number.isFinite(at) || !Number.isFinite(height)) {
        pen = "M";
        continue;
      }
      drawn += `${pen}${at.toFixed(2)} ${Math.min(1e5, Math.max(-1e5, height)).toFixed(2)}`;
      pen = "L";
    }
    return drawn;
  }

  #placeOf(event) {
    const box = this.svg.getBoundingClientRect();
    const { left, right } = this.frame;
    const at = ((event.clientX - box.left) / box.width) * this.width;
    return this.#valueAt(Math.min(1, Math.max(0, (at - left) / (right - left))));
  }

  #placeOfKeys() {
    return this.#valueAt(Number(this.keys.value) / KEYS);
  }

  #valueAt(share) {
    if (!this.content) return null;
    const [from, to] = this.content.x;
    return this.content.xLog ? from * (to / from) ** share : from + share * (to - from);
  }

  #point(x) {
    this.at = x;
    const found = x === null ? null : this.content?.readings?.(x);
    if (this.reading) this.reading.textContent = found?.text ?? "";
    if (!found) {
      this.overlay.replaceChildren();
      return;
    }
    this.keys.setAttribute("aria-valuetext", found.text);
    const { top, bottom } = this.frame;
    const at = this.px(found.x ?? x);
    this.overlay.replaceChildren(
      svg("path", { class: "cursor", d: `M${at} ${top}V${bottom}` }),
      ...(found.dots ?? []).filter(([, y]) => Number.isFinite(y)).map(([dx, y, kind]) => svg("circle", { class: `dot ${kind}`, cx: this.px(dx), cy: this.py(y), r: 4.5 })),
    );
  }
}

export function shown(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) {
    const power = Math.floor(Math.log10(size) + 1e-12);
    const rest = digits(value / 10 ** power, 3);
    return `${rest === "1" ? "" : rest === "-1" ? "−" : `${rest.replace("-", "−")}·`}10${superscript(power)}`;
  }
  return digits(value, 6).replace("-", "−");
}

const superscript = (power) => [...String(power)].map((one) => (one === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[one])).join("");

/** The value between points in increasing order. */
export function between(xs, ys, x) {
  let [low, high] = [0, xs.length - 1];
  if (!(x >= xs[low] && x <= xs[high])) return NaN;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  const span = xs[high] - xs[low];
  if (!(span > 0)) return ys[low] ?? NaN;
  if (ys[low] === null || ys[high] === null) return NaN;
  return ys[low] + ((x - xs[low]) / span) * (ys[high] - ys[low]);
}

/** The names of curves, below a chart. */
export function legend(host, entries) {
  become(host, entries.map(([kind, name, style]) => html("span", {}, html("i", { class: `${kind} ${style ?? ""}`, "aria-hidden": "true" }), html("span", {}, name))));
}

/** Ends that hold all values, with some room. */
export function ends(values, { zero = false, room = 0.06 } = {}) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (Number.isFinite(value)) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  if (zero) [low, high] = [Math.min(0, low), Math.max(0, high)];
  if (!(low <= high)) return [0, 1];
  if (low === high) return low === 0 ? [-1, 1] : [low - Math.abs(low) * 0.1, high + Math.abs(high) * 0.1];
  const span = high - low;
  return [zero && low === 0 ? 0 : low - room * span, zero && high === 0 ? 0 : high + room * span];
}

// Stresses below the surface, as bands of colour.

import { become, byId, html, show, svg } from "./dom.js";
import { legend, shown as number } from "./chart.js";
import { Latest } from "./engine.js";
import { state } from "./state.js";
import { axisUnit, digits, ticks } from "./units.js";

/** Points of the map while something moves. */
const COARSE = [[61, 31], [41, 21], [25, 13]];
/** What comes in this time (ms) is drawn in one frame with the answer: nearly what a redraw may take. */
const IN_TIME = 45;
/** A map has fewer points where it comes later than this (ms), since to draw takes as long again, and more where it comes in half of it. */
const SOON = 14;
const FINE = [161, 81];
const BANDS = 14;
const LEFT = 62;
const RIGHT = 88;
const TOP = 10;
const BOTTOM = 40;

/** Colours that grow steadily lighter, and are told apart by everyone (viridis, at even steps). */
const VIRIDIS = [[68, 1, 84], [72, 33, 115], [67, 62, 133], [56, 88, 140], [45, 112, 142], [37, 133, 142], [30, 155, 138], [42, 176, 127], [82, 197, 105], [134, 213, 73], [194, 223, 35], [253, 231, 37]];
/** From blue over pale to red, for values of both signs (after ColorBrewer's RdBu). */
const BOTH = [[5, 48, 97], [33, 102, 172], [67, 147, 195], [146, 197, 222], [209, 229, 240], [247, 247, 247], [253, 219, 199], [244, 165, 130], [214, 96, 77], [178, 24, 43], [103, 0, 31]];

const host = byId("map");
const card = byId("map-card");
const component = byId("component");
const canvas = html("canvas", { "aria-hidden": "true" });
const picture = svg("svg", { role: "img", "aria-label": "Stress below the surface" });
host.append(canvas, picture);
const latest = new Latest("map", answered, (isMoving) => !isMoving);
let coarseness = 0;
/** Whether a map takes so little that it comes with the answer: both are drawn in one frame. */
let isQuick = false;
let shown = null;

component.addEventListener("change", () => askMap(false));
const ratio = byId("map-ratio");
ratio.addEventListener("input", () => askMap(false));
/** The width that there is, as it was told last: to ask the element would lay out the page anew. */
let room = 0;
new ResizeObserver(([{ contentRect }]) => {
  const before = room;
  room = Math.round(contentRect.width);
  // A map that is less deep changes the height of its place.
  if (shown && room > 0 && room !== before) draw(shown);
}).observe(host);

/** Asks for the map: a coarse one while something moves. */
export function askMap(isMoving, isWanted = true) {
  if (place(isWanted)) latest.ask({ ...state.question(), ...view(isMoving) }, isMoving);
}

/** What to ask for together with an answer while something moves, if that is quick and no other map is on its way. */
export function viewWhileMoving() {
  return isQuick && shown && !card.hidden && !latest.isBusy ? view(true) : undefined;
}

/** Shows the map that came with an answer in this time (ms), while something moves. */
export function showMap(map, took) {
  place(true);
  takeMap(map, true, true, took);
}

/** Whether there is a map to wait for, which has its place then. */
function place(isWanted) {
  show(card, isWanted);
  if (isWanted) card.setAttribute("aria-busy", "true");
  else card.removeAttribute("aria-busy");
  return isWanted;
}

function view(isMoving) {
  show(byId("map-ratio-field"), state.isDimensionless);
  const asked = { component: component.value, points: isMoving ? COARSE[coarseness] : FINE, peaks: !isMoving };
  const stated = Number(ratio.value);
  return state.isDimensionless && Number.isFinite(stated) ? { ...asked, poisson_ratio: stated } : asked;
}

/** Another problem: what is shown is not its map. */
export function forgetMap() {
  shown = null;
  coarseness = 0;
  isQuick = false;
  canvas.hidden = true;
  picture.replaceChildren();
  byId("map-legend").replaceChildren();
}

function answered(answer, isMoving, isLast) {
  takeMap(answer, isMoving, isLast, latest.took);
}

function takeMap(answer, isMoving, isLast, took) {
  if (isLast && !isMoving) card.removeAttribute("aria-busy");
  if (answer.fault) {
    legend(byId("map-legend"), [["k-none", answer.fault.what ?? answer.fault.message, "none"]]);
    shown = null;
    canvas.hidden = true;
    picture.replaceChildren();
    return;
  }
  shown = answer;
  draw(answer);
  if (isMoving) {
    isQuick = took < IN_TIME;
    if (took > SOON) coarseness = Math.min(coarseness + 1, COARSE.length - 1);
    else if (took < SOON / 2) coarseness = Math.max(coarseness - 1, 0);
  }
  document.dispatchEvent(new CustomEvent("mapped", { detail: { isMoving, isLast } }));
}

function draw(map) {
  const width = Math.max(280, room || Math.round(host.clientWidth));
  const [x0, x1] = [map.x[0], map.x.at(-1)];
  const depth = map.depth.at(-1);
  const inner = width - LEFT - RIGHT;
  const tall = Math.min(460, Math.max(120, (inner * depth) / (x1 - x0)));
  const height = tall + TOP + BOTTOM;
  const length = map.units?.length ?? (map.is_physical ? axisUnit(Math.max(Math.abs(x0), Math.abs(x1)), "length") : { factor: 1, label: "" });
  const [low, high] = map.limits ?? [0, 1];
  const unit = map.units?.pressure ?? (map.is_physical ? axisUnit(Math.max(Math.abs(low), Math.abs(high)), "pressure") : { factor: 1, label: "" });
  const levels = bands(low * unit.factor, high * unit.factor);
  const colours = painter(levels, low < 0 && high > 0 ? BOTH : low < 0 ? [...VIRIDIS].reverse() : VIRIDIS);
  paint(map, { inner, tall, factor: unit.factor, levels, colours });
  Object.assign(canvas.style, { left: `${LEFT}px`, top: `${TOP}px`, width: `${inner}px`, height: `${tall}px` });
  canvas.hidden = false;
  const px = (x) => LEFT + ((x - x0) / (x1 - x0)) * inner;
  const py = (y) => TOP + (y / depth) * tall;
  const parts = [svg("rect", { class: "frame", x: LEFT, y: TOP, width: inner, height: tall })];
  for (const at of ticks(x0 * length.factor, x1 * length.factor, Math.max(3, inner / 80))) {
    parts.push(svg("text", { x: px(at / length.factor), y: TOP + tall + 16, "text-anchor": "middle" }, number(at)));
  }
  for (const at of ticks(0, depth * length.factor, Math.max(2, tall / 45))) {
    parts.push(svg("text", { x: LEFT - 8, y: py(at / length.factor) + 4, "text-anchor": "end" }, number(at)));
  }
  parts.push(svg("text", { x: LEFT + inner / 2, y: height - 6, "text-anchor": "middle" }, map.is_physical ? `x [${length.label}]` : "ξ = x/a"));
  parts.push(svg("text", { x: 13, y: TOP + tall / 2, "text-anchor": "middle", transform: `rotate(-90 13 ${TOP + tall / 2})` }, map.is_physical ? `depth [${length.label}]` : "depth/a"));
  for (const [from, to] of map.zones) parts.push(svg("path", { class: "touch", d: `M${px(Math.max(from, x0))} ${TOP - 2}H${px(Math.min(to, x1))}` }));
  // What lies beyond the ends of the bar has the colour of the last band: an arrow says so.
  const reach = [Math.min(...map.values), Math.max(...map.values)].map((one) => one * unit.factor);
  const beyond = [reach[0] < levels[0] - 1e-9 * (levels.at(-1) - levels[0]), reach[1] > levels.at(-1) + 1e-9 * (levels.at(-1) - levels[0])];
  parts.push(...bar(levels, colours, beyond, { x: LEFT + inner + 12, tall, label: map.is_physical ? `[${unit.label}]` : "/E" }));
  const peak = component.value === "von-mises" ? map.von_mises : component.value === "max-shear" ? map.max_shear : null;
  const places = peak?.infinite_at.length ? peak.infinite_at.map((x) => [x, 0]) : peak ? [[peak.x, peak.depth]] : [];
  for (const [x, y] of places.filter(([x, y]) => x >= x0 && x <= x1 && y <= depth)) {
    const cross = `M${px(x) - 6} ${py(y)}h12m-6 -6v12`;
    parts.push(svg("path", { class: "halo", d: cross }), svg("path", { class: "peak", d: cross }));
  }
  picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
  if (map.von_mises) picture.setAttribute("aria-label", `${map.name} below the surface; von Mises largest ${map.von_mises.value} ${map.von_mises.place}; shear stress largest ${map.max_shear.value} ${map.max_shear.place}`);
  become(picture, parts);
  if (map.von_mises) legend(byId("map-legend"), words(map));
}

function words(map) {
  const said = [
    ["k-none", `von Mises, largest ${map.von_mises.value} ${map.von_mises.place}`, "none"],
    ["k-none", `shear stress, largest ${map.max_shear.value} ${map.max_shear.place}`, "none"],
  ];
  const found = map.first_yield;
  if (found?.none) said.push(["k-none", found.none, "none"]);
  for (const load of found?.loads ?? []) {
    const criterion = load.criterion === "von_mises" ? "von Mises" : "Tresca";
    said.push(["k-none", `first yield by ${criterion} at ${digits(load.factor, 4)} times this load`, "none"]);
  }
  said.push(["k-none", "plane strain, tension positive", "none"]);
  return said;
}

/** Round levels around all values. */
function bands(low, high) {
  const inner = ticks(low, high, BANDS);
  const step = inner.length > 1 ? inner[1] - inner[0] : high - low || 1;
  const first = Math.floor(low / step + 1e-9);
  const last = Math.max(first + 1, Math.ceil(high / step - 1e-9));
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** The colours of the bands between levels. */
function painter(levels, palette) {
  const bands = Math.max(1, levels.length - 1);
  return Array.from({ length: bands }, (_, band) => {
    const at = (bands === 1 ? 0.5 : band / (bands - 1)) * (palette.length - 1);
    const index = Math.min(palette.length - 2, Math.floor(at));
    return palette[index].map((one, i) => Math.round(one + (at - index) * (palette[index + 1][i] - one)));
  });
}

/** Paints each pixel in the colour of the band of its value, which is interpolated between the points of the map. */
function paint(map, { inner, tall, factor, levels, colours }) {
  const sharp = Math.min(2, window.devicePixelRatio || 1);
  const [wide, high] = [Math.round(inner * sharp), Math.round(tall * sharp)];
  if (canvas.width !== wide) canvas.width = wide;
  if (canvas.height !== high) canvas.height = high;
  const context = canvas.getContext("2d");
  const image = context.createImageData(wide, high);
  const pixels = new Uint32Array(image.data.buffer);
  const [nx, ny] = [map.x.length, map.depth.length];
  const bands = colours.length;
  const packed = Uint32Array.from(colours, ([r, g, b]) => (255 << 24) | (b << 16) | (g << 8) | r);
  // In bands from the first level.
  const [first, step] = [levels[0], (levels.at(-1) - levels[0]) / bands || 1];
  const values = Float64Array.from(map.values, (value) => (value * factor - first) / step);
  const before = new Int32Array(wide);
  const shares = new Float64Array(wide);
  for (let i = 0; i < wide; i++) {
    const at = (i / Math.max(1, wide - 1)) * (nx - 1);
    before[i] = Math.min(nx - 2, Math.floor(at));
    shares[i] = at - before[i];
  }
  const between = new Float64Array(nx);
  for (let j = 0; j < high; j++) {
    const at = (j / Math.max(1, high - 1)) * (ny - 1);
    const row = Math.min(ny - 2, Math.floor(at));
    for (let k = 0; k < nx; k++) {
      const [upper, lower] = [values[row * nx + k], values[(row + 1) * nx + k]];
      between[k] = upper + (at - row) * (lower - upper);
    }
    for (let i = 0; i < wide; i++) {
      const k = before[i];
      const band = Math.floor(between[k] + shares[i] * (between[k + 1] - between[k]));
      pixels[j * wide + i] = packed[band < 0 ? 0 : band >= bands ? bands - 1 : band];
    }
  }
  context.putImageData(image, 0, 0);
}

function bar(levels, colours, beyond, { x, tall, label }) {
  const bands = colours.length;
  const above = beyond[1] ? 9 : 0;
  const top = TOP + 16 + above;
  const each = (tall - 16 - above - (beyond[0] ? 9 : 0)) / bands;
  const parts = [svg("text", { x, y: TOP + 8 }, label)];
  colours.forEach(([r, g, b], band) => {
    parts.push(svg("rect", { x, y: top + (bands - 1 - band) * each, width: 14, height: each + 0.5, fill: `rgb(${r} ${g} ${b})` }));
  });
  const arrow = ([r, g, b], from, to) => svg("path", { d: `M${x} ${from}h14L${x + 7} ${to}Z`, fill: `rgb(${r} ${g} ${b})` });
  const bottom = top + bands * each;
  if (beyond[1]) parts.push(arrow(colours.at(-1), top, top - 9));
  if (beyond[0]) parts.push(arrow(colours[0], bottom, bottom + 9));
  const every = Math.max(1, Math.ceil(levels.length / Math.max(2, tall / 24)));
  levels.forEach((level, i) => {
    if (i % every === 0) parts.push(svg("text", { x: x + 19, y: top + (bands - i) * each + 4 }, number(level)));
  });
  return parts;
}

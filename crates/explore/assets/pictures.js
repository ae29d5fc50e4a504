// Pressure, and the surfaces with the gap between them.

import { between, Chart, ends, legend } from "./chart.js";
import { byId, show, svg } from "./dom.js";
import { state } from "./state.js";
import { axisUnit, digits, quantity } from "./units.js";

/** A contact narrower than this share of the base is shown larger. */
const NARROW = 0.4;
/** How far beside the base the surface is shown, in half-widths. */
const BESIDE = 1.3;
/** How thick the layer of asperities is drawn where it is free: so many times its largest compression, and a share of the depths at least, so that it can be seen. */
const FREE = 1.25;
const LEAST = 0.05;
/** A base that rises from the contact by more than this many times the depths there is cut: it would flatten them. */
const STEEP = 1.2;
/** Pressures beyond this many times the mean are corners, and cut. */
const CORNER = 6;

let whole = false;
let last = null;
const zoom = byId("zoom");
const pressure = new Chart(byId("pressure"), { height: 270, reading: byId("pressure-reading"), label: "Pressure over the base" });
const surfaces = new Chart(byId("surfaces"), { height: 230, reading: byId("surfaces-reading"), label: "Surfaces of punch and body" });

zoom.addEventListener("click", () => {
  whole = !whole;
  zoom.setAttribute("aria-pressed", String(whole));
  if (last) draw(last);
});

/** Whether the contact is small on the base, and the part of the base that shows it. */
function nearContact(picture) {
  const first = picture.zones[0];
  const end = picture.zones.at(-1);
  if (!first) return null;
  const a = picture.half_width;
  const width = end[1] - first[0];
  if (width > NARROW * 2 * a) return null;
  const room = Math.max(0.6 * width, 1e-6 * a);
  const most = reach(picture);
  return [Math.max(-most, first[0] - room), Math.min(most, end[1] + room)];
}

/** How far from the middle there is something to show: of a wave one period, which ends nowhere. */
function reach(picture) {
  const a = picture.half_width;
  return isWave(picture) ? a : BESIDE * a;
}

/** Draws both. */
export function showPictures(answer) {
  last = answer;
  draw(answer);
}

function draw(answer) {
  const { picture } = answer;
  const near = nearContact(picture);
  show(zoom, near !== null);
  const range = near && !whole ? near : [-reach(picture), reach(picture)];
  const bare = !picture.is_physical;
  const length = bare ? { factor: 1, label: "" } : picture.units?.length ?? axisUnit(Math.max(...range.map(Math.abs)), "length");
  const x = range.map((one) => one * length.factor);
  const xLabel = bare ? "ξ = x/a" : `x [${length.label}]`;
  drawPressure(answer, { x, xLabel, length, bare });
  drawSurfaces(answer, { x, xLabel, length, bare, range });
}

function drawPressure(answer, { x, xLabel, length, bare }) {
  const { picture } = answer;
  const values = picture.pressure.map((one) => one ?? Infinity);
  const mean = Math.abs((answer.answer.physical ?? answer.answer.dimensionless)?.mean_pressure ?? NaN);
  const finite = values.filter(Number.isFinite);
  let [low, high] = ends(finite, { zero: true, room: 0.08 });
  // Near a corner the curve leaves the picture.
  const isCut = picture.is_smooth && mean > 0 && high > CORNER * mean && values.some((one) => !Number.isFinite(one));
  if (isCut) high = CORNER * mean;
  const unit = bare ? { factor: 1, label: "" } : picture.units?.pressure ?? axisUnit(Math.max(Math.abs(low), Math.abs(high)), "pressure");
  const points = picture.x.map((at, i) => [at * length.factor, values[i] * unit.factor]);
  const error = picture.error ?? 0;
  const isSeen = error > 1e-3 * Math.max(Math.abs(low), Math.abs(high));
  const tension = points.map(([at, p]) => [at, Math.min(0, p)]);
  const pulls = points.some(([, p]) => p < 0);
  const kind = (answer.answer.error?.kind ?? "") === "bound" ? "guaranteed bounds" : "estimated error";
  const shown = told(picture, "pressure", "pressure", 6);
  const place = told(picture, "length", "length", 5);
  const peak = (answer.answer.physical ?? answer.answer.dimensionless)?.peak_pressure;
  pressure.draw({
    x,
    y: [low * unit.factor, high * unit.factor],
    xLabel,
    yLabel: bare ? "p/E" : `p [${unit.label}]`,
    layers: [
      { kind: "area", class: "k-pressure", opacity: 0.13, base: 0, points },
      pulls && { kind: "area", class: "k-bad", opacity: 0.3, base: 0, points: tension },
      isSeen && { kind: "band", class: "k-band", points: points.map(([at, p]) => [at, p - error * unit.factor, p + error * unit.factor]) },
      ...edges(picture).map((at) => ({ kind: "vertical", at: at * length.factor })),
      { kind: "line", class: "k-pressure", points },
      ...picture.zones.map(([from, to]) => ({ kind: "touch", from: from * length.factor, to: to * length.factor, at: 0 })),
    ].filter(Boolean),
    over: isCut ? (chart) => [svg("text", { class: "clipped", x: chart.frame.right - 4, y: chart.frame.top + 12, "text-anchor": "end" }, "infinite at the corner: cut")] : null,
    description: `Pressure over the base, largest ${peak === null || peak === undefined ? "infinite" : shown(peak)}, touching ${picture.zones.map(([from, to]) => `from ${place(from)} to ${place(to)}`).join(" and ")}.`,
    readings: (at) => {
      const p = between(picture.x, picture.pressure, at / length.factor);
      const name = picture.coordinate === "xi" ? "ξ" : picture.coordinate;
      if (!Number.isFinite(p)) return { text: `${name} = ${place(at / length.factor)}` };
      return { text: `${name} = ${place(at / length.factor)}:  p = ${shown(p)}`, dots: [[at, p * unit.factor, "k-pressure"]] };
    },
  });
  legend(byId("pressure-legend"), [
    ["k-pressure", "contact pressure"],
    ["k-layer", "where it touches"],
    ...(isSeen ? [["k-band", kind, "fill"]] : []),
    ...(pulls ? [["k-bad", "tension: it would lift off", "fill"]] : []),
  ]);
}

/** How a value is read out: in the units that the file chose, else with a prefix of its own. */
function told(picture, which, kind, count) {
  const unit = picture.units?.[which];
  if (!picture.is_physical) return (value) => digits(value, count);
  return unit ? (value) => `${digits(value * unit.factor, count)} ${unit.label}` : (value) => quantity(value, kind, count);
}

/** Whether the base has no edges: it fills its period. */
function isWave(picture) {
  return picture.geometry === "periodic" && picture.pieces.length === 1 && Math.abs((state.si["punch.period"] ?? NaN) / 2 - picture.half_width) < 1e-9 * picture.half_width;
}

/** The edges of the base, where it has some. */
function edges(picture) {
  return isWave(picture) ? [] : [...new Set(picture.pieces.flat())];
}

/** The points of a line that lie over an interval, or within rounding of its ends. */
function over(points, [from, to]) {
  const rounding = 1e-12 * Math.max(Math.abs(from), Math.abs(to));
  return points.filter(([at]) => at >= from - rounding && at <= to + rounding);
}

/** Base, layer and body in a range: the body's surface lies below the layer of asperities, which has its free thickness beside the contact. */
function pressed(picture, range) {
  const { surface } = picture;
  const base = picture.x.map((at, i) => [at, picture.base[i] ?? NaN]);
  const skin = surface.x.map((at, i) => [at, surface.displacement[i] ?? NaN]);
  const touching = picture.zones.map((zone) => over(over(base, zone), range)).flat();
  const compression = Math.max(0, ...touching.map(([at, depth]) => depth - between(surface.x, surface.displacement, at)).filter(Number.isFinite));
  const depths = [...over(skin, range), ...touching].map(([, depth]) => depth);
  const [shallow, deep] = ends([0, ...depths], { room: 0 });
  const thickness = picture.is_smooth ? 0 : Math.max(FREE * compression, LEAST * (deep - shallow));
  const isTouching = (at) => picture.zones.some(([from, to]) => at >= from && at <= to);
  const layer = skin.map(([at, depth]) => {
    const top = isTouching(at) ? between(picture.x, picture.base, at) : depth;
    return [at, Math.min(Number.isFinite(top) ? top : depth, depth + thickness), depth + thickness];
  });
  const body = layer.map(([at, , depth]) => [at, depth]);
  const rises = over(base, range).map(([, depth]) => depth);
  const [low, high] = ends([...depths, ...over(body, range).map(([, depth]) => depth)], { room: 0.12 });
  const [highest] = ends([low, ...rises], { room: 0 });
  return { bases: picture.pieces.map((piece) => over(base, piece)), layer, body, thickness, depths: [Math.max(highest - 0.12 * (high - highest), low - STEEP * (high - low)), high] };
}

function drawSurfaces(answer, { x, xLabel, length, bare, range }) {
  const { picture } = answer;
  const { surface } = picture;
  const { bases, layer, body, thickness, depths: [low, high] } = pressed(picture, range);
  const unit = bare ? { factor: 1, label: "" } : picture.units?.depth ?? axisUnit(Math.max(Math.abs(low), Math.abs(high)), "length");
  const scaled = (points) => points.map(([at, ...depths]) => [at * length.factor, ...depths.map((depth) => depth * unit.factor)]);
  const punches = bases.map(scaled);
  const skin = scaled(body);
  const shown = told(picture, "depth", "length", 5);
  const place = told(picture, "length", "length", 5);
  surfaces.draw({
    x,
    y: [low * unit.factor, high * unit.factor],
    isDown: true,
    xLabel,
    yLabel: bare ? "depth/(χE)" : `depth [${unit.label}]`,
    layers: [
      { kind: "area", class: "k-body", opacity: 0.16, base: "bottom", points: skin },
      ...punches.map((points) => ({ kind: "area", class: "k-punch", opacity: 0.14, base: "top", points })),
      ...(picture.is_smooth ? [] : [{ kind: "band", class: "k-layer soft", points: scaled(layer) }]),
      { kind: "line", class: "k-body", points: skin },
      ...punches.map((points) => ({ kind: "line", class: "k-punch dashed", points })),
    ],
    description: "Depth of the punch’s base and of the body’s surface below the undeformed surface.",
    readings: (at) => {
      const real = at / length.factor;
      const name = picture.coordinate === "xi" ? "ξ" : picture.coordinate;
      const depth = between(surface.x, surface.displacement, real);
      const base = picture.pieces.some(([from, to]) => real >= from && real <= to) ? between(picture.x, picture.base, real) : NaN;
      const isTouching = picture.zones.some(([from, to]) => real >= from && real <= to);
      if (!Number.isFinite(depth)) return { text: `${name} = ${place(real)}` };
      const how = isTouching && Number.isFinite(base)
        ? `base ${shown(base)} deep${picture.is_smooth ? "" : `, asperities flatter by ${shown(Math.max(0, base - depth))}`}`
        : `surface ${shown(depth)} deep${Number.isFinite(base) ? `, gap ${shown(Math.max(0, depth - base))}` : ""}`;
      return { text: `${name} = ${place(real)}:  ${how}`, dots: [[at, (isTouching ? base : depth) * unit.factor, "k-body"], [at, base * unit.factor, "k-punch"]] };
    },
  });
  const { left, right, top, bottom } = surfaces.frame;
  const factor = ((bottom - top) / (high - low)) / ((right - left) / (range[1] - range[0]));
  legend(byId("surfaces-legend"), [
    ["k-punch", "base of the punch", "dash"],
    ["k-body", "surface of the body"],
    ...(picture.is_smooth ? [] : [["k-layer", bare ? "asperities, drawn thick where free" : `asperities, drawn ${told(picture, "depth", "length", 2)(thickness)} thick where free`, "fill"]]),
    ...(bare ? [] : [["k-none", `depths drawn ${digits(factor, 2)} times as large as lengths`, "none"]]),
  ]);
}

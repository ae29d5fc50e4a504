// The form of the problem: built from the file, and written into it.

import { byId, html } from "./dom.js";
import { check, choice, list, Quantity } from "./controls.js";
import { profileControl } from "./profile.js";
import { state } from "./state.js";
import { quantity } from "./units.js";

const LENGTHS = {
  plane: [["half_width", "Half-width", "a"]],
  pair: [["outer_half_width", "Outer half-width", "a"], ["inner_half_gap", "Half the gap", "b"]],
  periodic: [["period", "Period", "L"], ["half_width", "Half-width", "a"]],
  circular: [["radius", "Radius", "a"]],
};
const ROTATION = ["moment", "eccentricity", "tilt"];
const form = byId("inputs");
let controls = [];
let shape = "";

/** A quantity that remembers where its faults are shown. */
function quantityOf(definition) {
  const control = new Quantity(definition);
  controls.push(control);
  return control.element;
}

const log = { scale: "log" };
const ratio = { scale: "linear", min: 0, max: 0.5 };

function fieldset(name, ...children) {
  return html("fieldset", {}, html("legend", {}, name), ...children);
}

const isCircular = () => state.get(`${state.punch}.geometry`) === "circular";
const kinds = () => (isCircular() ? { force: "force", moment: "moment" } : { force: "line_force", moment: "force" });

function changed() {
  state.changed({ isBuilt: true });
}

function load() {
  const table = state.isDimensionless ? "dimensionless" : "load";
  const bare = state.isDimensionless;
  const { force, moment } = kinds();
  const vertical = state.get(`${table}.settlement`) !== undefined ? "settlement" : "force";
  const rotational = ROTATION.find((key) => state.get(`${table}.${key}`) !== undefined) ?? "moment";
  const answer = state.answer?.answer?.physical ?? state.answer?.answer?.dimensionless;
  const was = (key, kind) => (answer && Number.isFinite(answer[key]) ? (bare ? Number(answer[key].toPrecision(6)) : quantity(answer[key], kind, 6)) : bare ? 1 : quantity(1e-6, kind));
  const kindOf = { force, settlement: "length", moment, eccentricity: "length", tilt: "angle" };
  const pick = (group, key) => {
    // What was the answer is prescribed now, so that nothing jumps.
    const value = key === "eccentricity" ? (bare ? 0 : "0 mm") : was(key, kindOf[key]);
    state.swap(table, group.filter((one) => one !== key), key, state.get(`${table}.${key}`) ?? value);
    changed();
  };
  const contact = state.get("solver.contact") ?? "unilateral";
  const reach = {
    moment: () => (state.si[`${table}.force`] ?? answer?.force ?? NaN) * state.halfWidth,
    eccentricity: () => state.halfWidth,
    tilt: () => Math.abs(2 * (answer?.settlement ?? 1e-3)) / state.halfWidth,
  };
  const kind = (key) => (bare ? "none" : kindOf[key]);
  return fieldset(
    "Load",
    choice({ label: "*What presses", key: "vertical", value: vertical, options: [["force", "Force"], ["settlement", "Settlement"]], chosen: (key) => pick(["force", "settlement"], key) }),
    quantityOf({ path: `${table}.${vertical}`, label: vertical === "force" ? (isCircular() || bare ? "Force" : "Force per length") : "Settlement", symbol: vertical === "force" ? "P" : "δ", kind: kind(vertical), range: log }),
    choice({ label: "*What turns", key: "rotational", value: rotational, options: [["moment", "Moment"], ["eccentricity", "Eccentricity"], ["tilt", "Tilt"]], chosen: (key) => pick(ROTATION, key) }),
    quantityOf({ path: `${table}.${rotational}`, label: { moment: "Moment", eccentricity: "Eccentricity", tilt: "Tilt" }[rotational], symbol: { moment: "M", eccentricity: "e", tilt: "α" }[rotational], kind: kind(rotational), range: { scale: "signed", reach: reach[rotational] } }),
    choice({
      label: "Contact: unilateral or bilateral",
      key: "contact",
      value: contact,
      options: [["unilateral", "May lift off"], ["bilateral", "Held together"]],
      chosen: (value) => {
        state.set("solver.contact", value);
        changed();
      },
    }),
  );
}

function punch() {
  const table = state.punch;
  const bare = state.isDimensionless;
  const geometry = state.get(`${table}.geometry`) ?? "plane";
  const all = Object.values(LENGTHS).flat().map(([key]) => key);
  const chosen = (next) => {
    const a = state.halfWidth || 5e-3;
    const length = (value) => (bare ? value : quantity(value, "length"));
    const lengths = {
      plane: bare ? {} : { half_width: length(a) },
      pair: bare ? { inner_half_gap: 0.5 } : { outer_half_width: length(a), inner_half_gap: length(0.5 * a) },
      periodic: bare ? { period: 4 } : { period: length(4 * a), half_width: length(a) },
      circular: bare ? {} : { radius: length(a) },
    }[next];
    const old = Object.entries(state.get(table) ?? {}).filter(([key]) => key !== "geometry" && !all.includes(key));
    state.set(table, { ...(next === "plane" ? {} : { geometry: next }), ...lengths, ...Object.fromEntries(old) });
    if (!bare && geometry !== next && [geometry, next].includes("circular")) loadFor(next);
    changed();
  };
  const lengths = (LENGTHS[geometry] ?? []).filter(([key]) => !(bare && ["half_width", "radius", "outer_half_width"].includes(key)) && state.get(`${table}.${key}`) !== undefined);
  const body = state.get("body");
  return fieldset(
    "Punch",
    list({ label: "Geometry", key: "geometry", value: geometry, options: [["plane", "one long punch"], ["pair", "two feet of one body"], ["periodic", "a row, or a wave"], ["circular", "round"]], chosen }),
    lengths.map(([key, label, symbol]) => quantityOf({ path: `${table}.${key}`, label, symbol, kind: bare ? "none" : "length", range: log })),
    profileControl(controls),
    !bare && check({
      label: "The punch is elastic, too",
      key: "body",
      value: body !== undefined,
      chosen: (isElastic) => {
        state.set("body", isElastic ? { young_modulus: "200 GPa", poisson_ratio: 0.3 } : undefined);
        changed();
      },
    }),
    body && [
      quantityOf({ path: "body.young_modulus", label: "Modulus of the punch", symbol: "E", kind: "pressure", range: log }),
      quantityOf({ path: "body.poisson_ratio", label: "Poisson’s ratio of it", symbol: "ν", range: ratio }),
    ],
  );
}

/** A round punch bears a force, a long one a force per length. */
function loadFor(geometry) {
  const a = state.halfWidth || 5e-3;
  const stated = (key) => (state.get(key) === undefined ? undefined : state.si[key]);
  const force = stated("load.force");
  const moment = stated("load.moment");
  const [factor, f, m] = geometry === "circular" ? [2 * a, "force", "moment"] : [1 / (2 * a), "line_force", "force"];
  if (force !== undefined) state.set("load.force", quantity(force * factor, f));
  if (moment) state.set("load.moment", quantity(moment * factor, m));
}

const MODULI = ["young_modulus", "grading_modulus", "grading_exponent", "thickness", "base", "coating"];

function ground() {
  if (state.isDimensionless) return bareGround();
  const foundation = state.get("foundation") ?? {};
  const kind = foundation.coating ? "coating" : foundation.grading_modulus !== undefined ? "graded" : foundation.thickness !== undefined ? "layer" : "half";
  const modulus = foundation.young_modulus ?? "200 GPa";
  const thickness = quantity(state.halfWidth || 5e-3, "length");
  const chosen = (next) => {
    const keys = {
      half: { young_modulus: modulus },
      layer: { young_modulus: modulus, thickness, base: "bonded" },
      coating: { young_modulus: modulus, coating: { thickness: quantity(0.1 * (state.halfWidth || 5e-3), "length"), young_modulus: "400 GPa", poisson_ratio: 0.22 } },
      graded: { grading_exponent: 0.3, grading_modulus: modulus },
    }[next];
    const rest = Object.entries(foundation).filter(([key]) => !MODULI.includes(key));
    state.set("foundation", { ...Object.fromEntries(Object.entries(keys).filter(([key]) => key !== "coating")), ...Object.fromEntries(rest), ...(keys.coating && { coating: keys.coating }) });
    changed();
  };
  return fieldset(
    "Ground",
    list({ label: "What lies below", key: "ground", value: kind, options: [["half", "deep, uniform body"], ["layer", "layer on a rigid base"], ["coating", "coated body"], ["graded", "stiffer with depth"]], chosen }),
    kind === "graded"
      ? [
          quantityOf({ path: "foundation.grading_modulus", label: "Modulus at 1 m", symbol: "E₀", kind: "pressure", range: log }),
          quantityOf({ path: "foundation.grading_exponent", label: "Exponent of depth", symbol: "μ", range: { scale: "linear", min: 0, max: 0.95 } }),
        ]
      : quantityOf({ path: "foundation.young_modulus", label: "Young’s modulus", symbol: "E", kind: "pressure", range: log }),
    quantityOf({ path: "foundation.poisson_ratio", label: "Poisson’s ratio", symbol: "ν", range: ratio }),
    kind === "layer" && [
      quantityOf({ path: "foundation.thickness", label: "Thickness", symbol: "h", kind: "length", range: log }),
      choice({
        label: "On its base it",
        key: "base",
        value: foundation.base,
        options: [["bonded", "sticks"], ["frictionless", "slides"]],
        chosen: (value) => {
          state.set("foundation.base", value);
          changed();
        },
      }),
    ],
    kind === "coating" && [
      quantityOf({ path: "foundation.coating.thickness", label: "Thickness of the coating", symbol: "h", kind: "length", range: log }),
      quantityOf({ path: "foundation.coating.young_modulus", label: "Modulus of it", symbol: "E", kind: "pressure", range: log }),
      quantityOf({ path: "foundation.coating.poisson_ratio", label: "Poisson’s ratio of it", symbol: "ν", range: ratio }),
    ],
    check({
      label: "Yield stress is known",
      key: "yield",
      value: foundation.yield_stress !== undefined,
      chosen: (isKnown) => {
        state.set("foundation.yield_stress", isKnown ? "350 MPa" : undefined);
        changed();
      },
    }),
    foundation.yield_stress !== undefined && quantityOf({ path: "foundation.yield_stress", label: "Yield stress", kind: "pressure", range: log }),
  );
}

function bareGround() {
  const keys = state.get("dimensionless") ?? {};
  const main = keys.lambda0 !== undefined ? ["lambda0", "λ₀ = a/(E χ)", "λ₀"] : ["theta0", "θ₀ = 2a/(π E* χ)", "θ₀"];
  return fieldset(
    "Ground and roughness",
    quantityOf({ path: `dimensionless.${main[0]}`, label: main[1], range: log }),
    keys.poisson_ratio !== undefined && quantityOf({ path: "dimensionless.poisson_ratio", label: "Poisson’s ratio", symbol: "ν", range: ratio }),
    keys.thickness !== undefined && quantityOf({ path: "dimensionless.thickness", label: "Thickness, in half-widths", symbol: "h/a", range: log }),
    check({
      label: "Asperities stiffen under load",
      key: "exponent",
      value: keys.exponent !== undefined,
      chosen: (isPower) => {
        state.set("dimensionless.exponent", isPower ? 0.5 : undefined);
        changed();
      },
    }),
    keys.exponent !== undefined && quantityOf({ path: "dimensionless.exponent", label: "Exponent", symbol: "κ", range: { scale: "linear", min: 0.05, max: 1 } }),
    html("p", { class: "hint" }, "A file without dimensions: lengths in half-widths, pressures in E."),
  );
}

function roughness() {
  if (state.isDimensionless) return null;
  const foundation = state.get("foundation") ?? {};
  const stated = foundation.roughness;
  const kind = foundation.subgrade_modulus !== undefined ? "subgrade" : typeof stated === "object" ? "power" : state.si["foundation.roughness"] === 0 || stated === 0 || stated === "0" ? "smooth" : "linear";
  const chosen = (next) => {
    const values = { smooth: 0, linear: "0.012 µm/MPa", power: { coefficient: 1e-9, exponent: 0.4 }, subgrade: "8e13 Pa/m" };
    const key = next === "subgrade" ? "subgrade_modulus" : "roughness";
    state.swap("foundation", ["roughness", "subgrade_modulus"], key, values[next]);
    changed();
  };
  return fieldset(
    "Roughness",
    list({ label: "Asperities", key: "roughness", value: kind, options: [["linear", "give in proportion"], ["power", "stiffen under load"], ["subgrade", "by a subgrade modulus"], ["smooth", "none: smooth surface"]], chosen }),
    kind === "linear" && quantityOf({ path: "foundation.roughness", label: "Compliance", symbol: "χ", kind: "compliance", range: log }),
    kind === "subgrade" && quantityOf({ path: "foundation.subgrade_modulus", label: "Modulus", symbol: "1/χ", kind: "subgrade", range: log }),
    kind === "power" && [
      quantityOf({ path: "foundation.roughness.coefficient", label: "Coefficient", symbol: "B", range: log, hint: "v = B p^κ, SI units" }),
      quantityOf({ path: "foundation.roughness.exponent", label: "Exponent", symbol: "κ", range: { scale: "linear", min: 0.05, max: 1 } }),
    ],
  );
}

/** What decides which controls there are. */
function shapeNow() {
  const keys = (value) => (typeof value === "object" && value !== null && !Array.isArray(value) ? Object.keys(value).map((key) => [key, keys(value[key])]) : 0);
  const { tree } = state;
  const names = ["foundation", "punch", "load", "body", "dimensionless"].map((name) => [name, keys(tree[name])]);
  return JSON.stringify([names, state.get(`${state.punch}.geometry`), state.get("solver.contact"), state.get("foundation.base"), state.si["foundation.roughness"] === 0, state.get(`${state.punch}.profile.csv`)]);
}

/** Builds the form anew where it has other controls than before, else shows its values. */
export function showInputs({ isNew = false, isBuilt = false } = {}) {
  const now = shapeNow();
  if (!isNew && !isBuilt && now === shape) {
    for (const control of controls) control.sync();
    return;
  }
  shape = now;
  const focused = document.activeElement?.closest?.("#inputs") ? document.activeElement.dataset.key : null;
  controls = [];
  form.replaceChildren(...[load(), punch(), ground(), roughness()].filter(Boolean));
  if (focused) form.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus();
}

/** Shows a fault at the control that it belongs to; true where there is one. */
export function blame(fault) {
  let isFound = false;
  for (const control of controls) {
    const isThis = Boolean(fault?.field) && (fault.field === control.path || (control.isTable && fault.field.startsWith(`${control.path}.`)));
    control.blame(isThis ? [fault.what, fault.help].filter(Boolean).join("; ") : null);
    isFound ||= isThis;
  }
  return isFound;
}

form.addEventListener("submit", (event) => event.preventDefault());

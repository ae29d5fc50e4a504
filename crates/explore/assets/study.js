// One or two inputs varied, and how the answer responds.

import { between, Chart, ends, legend } from "./chart.js";
import { byId, html, save, settled, show, unique } from "./dom.js";
import { ask } from "./engine.js";
import { state } from "./state.js";
import { toml } from "./toml.js";
import { axisUnit, digits, quantity, written } from "./units.js";

/** Cases that are asked for together. */
const TOGETHER = 8;
const MOST_ROWS = 400;

const NAMES = {
  "load.force": "force", "load.settlement": "settlement", "load.moment": "moment", "load.eccentricity": "eccentricity", "load.tilt": "tilt",
  "punch.half_width": "half-width", "punch.outer_half_width": "outer half-width", "punch.inner_half_gap": "half the gap", "punch.period": "period", "punch.radius": "radius",
  "foundation.young_modulus": "modulus", "foundation.poisson_ratio": "Poisson’s ratio", "foundation.roughness": "roughness", "foundation.subgrade_modulus": "subgrade modulus",
  "foundation.roughness.coefficient": "roughness coefficient", "foundation.roughness.exponent": "roughness exponent", "foundation.thickness": "thickness",
  "foundation.coating.thickness": "thickness of the coating", "foundation.coating.young_modulus": "modulus of the coating", "foundation.coating.poisson_ratio": "Poisson’s ratio of the coating",
  "foundation.grading_exponent": "exponent of depth", "foundation.grading_modulus": "modulus at 1 m", "body.young_modulus": "modulus of the punch", "body.poisson_ratio": "Poisson’s ratio of the punch",
};
const KINDS = {
  settlement: "length", tilt: "angle", pressure_left: "pressure", pressure_middle: "pressure", pressure_right: "pressure", mean_pressure: "pressure", peak_pressure: "pressure", peak_pressure_at: "length", contact_width: "length", theta0: "none", number_of_zones: "none",
};
const FIRST_OUTPUTS = ["settlement", "peak_pressure", "contact_width", "tilt"];

const form = byId("study-form");
const chart = new Chart(byId("study-chart"), { height: 340, reading: byId("study-reading"), label: "Response of the answer" });
let begun = null;
let chosen = { first: null, second: "", output: "peak_pressure", outputs: FIRST_OUTPUTS };
let run = 0;
let found = null;

const isRound = () => state.get(`${state.punch}.geometry`) === "circular";

function kindOf(key) {
  if (state.isDimensionless) return "none";
  const last = key.split(".").at(-1);
  if (last === "force") return isRound() ? "force" : "line_force";
  if (last === "moment") return isRound() ? "moment" : "force";
  if (last in KINDS) return KINDS[last];
  if (/width|gap|period|radius|thickness|eccentricity/.test(last)) return "length";
  if (last === "subgrade_modulus") return "subgrade";
  if (/modulus/.test(last)) return "pressure";
  if (last === "roughness") return "compliance";
  return "none";
}

const named = (key) => NAMES[key] ?? key.split(".").at(-1).replaceAll("_", " ");

/** The keys that can vary: the numbers of the problem. */
function keys() {
  return Object.keys(state.si).filter((key) => /^(load|punch|foundation|body|dimensionless)\./.test(key) && !/\.profile$/.test(key));
}

/** How a key is varied where nothing was said: from a quarter to four times its value. */
function usual(key, count) {
  const value = state.si[key];
  const kind = kindOf(key);
  if (/poisson/.test(key)) return { from: "0", to: "0.49", count, scale: "linear" };
  if (/exponent/.test(key)) return { from: "0.2", to: "0.95", count, scale: "linear" };
  if (value > 0) return { from: quantity(value / 4, kind), to: quantity(value * 4, kind), count, scale: "log" };
  const reach = /moment/.test(key) ? 0.4 * (state.si["load.force"] ?? 1) * state.halfWidth : /tilt/.test(key) ? 1e-4 : 0.4 * state.halfWidth;
  return { from: quantity(-reach, kind), to: quantity(reach, kind), count, scale: "linear" };
}

/** What a study file states of a key, as the form shows it. */
function stated(vary) {
  if (Array.isArray(vary)) return { list: vary.join(", ") };
  const { from, to, count, scale } = vary;
  return { from: String(from), to: String(to), count: count ?? 25, scale: scale ?? "linear" };
}

function begin() {
  const all = keys();
  const study = state.study;
  const varied = Object.entries(study?.vary ?? {});
  const preferred = ["load.force", "dimensionless.force", "load.settlement"].find((key) => all.includes(key)) ?? all[0];
  const outputs = study?.outputs ?? FIRST_OUTPUTS;
  chosen = {
    first: varied[0]?.[0] ?? preferred,
    second: varied[1]?.[0] ?? "",
    output: outputs.includes("peak_pressure") ? "peak_pressure" : outputs[0],
    outputs,
    values: {},
  };
  varied.slice(0, 2).forEach(([key, vary], i) => {
    // What is drawn from a distribution has no count; the page varies between its ends.
    if (Array.isArray(vary) || vary.from !== undefined) chosen.values[`${i} ${key}`] = stated(vary);
  });
  build();
}

function valuesOf(index, key) {
  const name = `${index} ${key}`;
  chosen.values[name] ??= usual(key, index === 0 ? 25 : 3);
  return chosen.values[name];
}

const rerun = settled(() => start(), 250);

function text(label, values, key) {
  const id = unique("study");
  const input = html("input", { type: "text", id, value: values[key] ?? "", spellcheck: "false", "data-key": `${label} ${key}` });
  input.addEventListener("input", () => {
    values[key] = input.value;
    rerun();
  });
  return html("label", { class: "stackled", for: id }, label, input);
}

function pick(label, options, value, key, changed) {
  const id = unique("study");
  const select = html("select", { id, "data-key": key, onchange: () => changed(select.value) }, options.map(([one, name]) => html("option", { value: one, selected: one === value }, name)));
  return html("label", { class: "stackled", for: id }, label, select);
}

function group(index, name, key, options) {
  const set = (next) => {
    chosen[index === 0 ? "first" : "second"] = next;
    build();
    start();
  };
  const parts = [pick("Input", options, key, `input ${index}`, set)];
  if (key) {
    const values = valuesOf(index, key);
    if (values.list !== undefined) {
      parts.push(text("Values", values, "list"));
    } else {
      parts.push(text("From", values, "from"), text("To", values, "to"), text("Points", values, "count"));
      parts.push(
        pick("Scale", [["linear", "even"], ["log", "logarithmic"]], values.scale, `scale ${index}`, (scale) => {
          values.scale = scale;
          rerun();
        }),
      );
    }
  }
  return html("fieldset", { class: "group" }, html("legend", {}, name), parts);
}

function build() {
  const focused = form.contains(document.activeElement) ? document.activeElement.dataset.key : null;
  const options = keys().map((key) => [key, named(key)]);
  form.replaceChildren(
    group(0, "Vary", chosen.first, options),
    group(1, "and with it", chosen.second, [["", "nothing else"], ...options.filter(([key]) => key !== chosen.first)]),
    html(
      "fieldset",
      { class: "group" },
      html("legend", {}, "Look at"),
      pick("Answer", begun.outputs.map((name) => [name, name.replaceAll("_", " ")]), chosen.output, "output", (name) => {
        chosen.output = name;
        if (!chosen.outputs.includes(name)) {
          chosen.outputs = [...chosen.outputs, name];
          start();
        } else if (found) draw();
      }),
    ),
  );
  if (focused) form.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus();
}

function variation(index, key) {
  const { list, from, to, count, scale } = valuesOf(index, key);
  if (list !== undefined) return list.split(",").map((one) => written(one)).filter((one) => one !== "");
  return { from: written(String(from)), to: written(String(to)), count: Number(count), scale };
}

/** The study as a file. */
function file() {
  const vary = { [chosen.first]: variation(0, chosen.first) };
  if (chosen.second) vary[chosen.second] = variation(1, chosen.second);
  return toml({ ...state.tree, study: { vary, outputs: chosen.outputs } });
}

async function start() {
  if (!chosen.first) return;
  const mine = ++run;
  const progress = byId("study-progress");
  const place = byId("study-trouble");
  const question = { ...state.question(), toml: file() };
  found = null;
  showDoubts([]);
  let from = 0;
  let columns = null;
  let cases = 1;
  while (from < cases) {
    const told = await ask("study", { ...question, from, count: TOGETHER });
    if (mine !== run) return;
    show(place, Boolean(told.fault));
    if (told.fault) {
      place.replaceChildren(html("p", {}, told.fault.what ? `${told.fault.field ?? ""}: ${told.fault.what}${told.fault.help ? `; ${told.fault.help}` : ""}` : told.fault.message));
      show(progress, false);
      return;
    }
    cases = told.cases;
    columns ??= Object.fromEntries(Object.keys(told.columns).map((name) => [name, []]));
    for (const [name, values] of Object.entries(told.columns)) columns[name].push(...values);
    from = Math.max(told.to, from + 1);
    found = { ...told, columns };
    progress.max = cases;
    progress.value = from;
    show(progress, from < cases);
    draw();
  }
  table();
  doubt(question, mine, cases);
}

/** Asks what is doubtful about the cases, when the curve is there. */
async function doubt(question, mine, cases) {
  const all = new Map();
  for (let from = 0; from < cases; ) {
    const told = await ask("study-doubts", { ...question, from, count: TOGETHER });
    if (mine !== run || told.fault) return;
    for (const one of told.doubts) {
      const known = all.get(one.code);
      if (known) known.count += one.count;
      else all.set(one.code, { ...one });
    }
    showDoubts([...all.values()]);
    from = Math.max(told.to, from + 1);
  }
}

function showDoubts(doubts) {
  const said = ({ code, message, count }) => html("li", { "data-code": code }, count > 1 ? `${message} (${count - 1} more of the cases)` : message);
  byId("study-warnings").replaceChildren(...doubts.map(said));
  show(byId("study-warnings"), doubts.length > 0);
}

/** The curves: the answer over the first input, one for each value of the second. */
function curves() {
  const { columns } = found;
  const output = columns[chosen.output] ?? [];
  const errors = columns[`${chosen.output}_error`] ?? [];
  const first = columns[chosen.first] ?? [];
  const second = chosen.second ? columns[chosen.second] : null;
  const all = new Map();
  first.forEach((x, i) => {
    const name = second ? second[i] : "";
    if (!all.has(name)) all.set(name, []);
    if (typeof x === "number") all.get(name).push([x, output[i], errors[i]]);
  });
  for (const points of all.values()) points.sort((one, other) => one[0] - other[0]);
  return all;
}

/** The unit of a column: the one that the file chose, or one that suits its values. */
function unitOf(key, values) {
  const numbers = values.filter((one) => typeof one === "number" && Number.isFinite(one));
  return found.units?.[key] ?? axisUnit(Math.max(0, ...numbers.map(Math.abs)), kindOf(key));
}

/** A value in words, in the unit that the file chose, else with a prefix of its own. */
function said(key, value, count) {
  const unit = found.units?.[key];
  return unit ? `${digits(value * unit.factor, count)} ${unit.label}`.trim() : quantity(value, kindOf(key), count);
}

function draw() {
  const all = curves();
  const points = [...all.values()].flat();
  const xs = points.map(([x]) => x);
  if (xs.length === 0) return;
  const isLog = valuesOf(0, chosen.first).scale === "log" && Math.min(...xs) > 0;
  const xUnit = unitOf(chosen.first, xs);
  const values = points.map(([, y]) => y ?? NaN);
  const isDrawn = values.some(Number.isFinite);
  show(byId("study-trouble"), !isDrawn);
  if (!isDrawn) byId("study-trouble").replaceChildren(html("p", {}, `${chosen.output.replaceAll("_", " ")}: ${found.columns.reason?.some(Boolean) ? found.columns.reason.find(Boolean) : "infinite in all cases, as the pressure at a corner without roughness is; look at another answer"}`));
  if (!isDrawn) return;
  const yUnit = unitOf(chosen.output, values);
  const y = ends(values.map((one) => one * yUnit.factor), { zero: false });
  const named_ = (value) => (chosen.second ? (typeof value === "number" ? said(chosen.second, value, 3) : String(value)) : named(chosen.output));
  const layers = [];
  const names = [];
  let index = 0;
  for (const [value, curve] of all) {
    const kind = `k${index++ % 8}`;
    const scaled = curve.map(([at, one]) => [at * xUnit.factor, (one ?? NaN) * yUnit.factor]);
    const band = curve.map(([at, one, error]) => [at * xUnit.factor, (one - (error ?? 0)) * yUnit.factor, (one + (error ?? 0)) * yUnit.factor]);
    const largest = Math.max(...curve.map(([, , error]) => error ?? 0)) * yUnit.factor;
    if (largest > 2e-3 * (y[1] - y[0])) layers.push({ kind: "band", class: "k-band", points: band });
    layers.push({ kind: "line", class: kind, points: scaled });
    if (curve.length <= 60) layers.push({ kind: "dots", class: kind, points: scaled, radius: 2.6 });
    names.push([kind, named_(value)]);
  }
  const [low, high] = room(Math.min(...xs) * xUnit.factor, Math.max(...xs) * xUnit.factor, isLog);
  chart.draw({
    x: [low, high],
    y,
    xLog: isLog,
    xLabel: label(named(chosen.first), xUnit),
    yLabel: label(chosen.output.replaceAll("_", " "), yUnit),
    layers,
    description: `${named(chosen.output)} over ${named(chosen.first)}: from ${said(chosen.output, Math.min(...values.filter(Number.isFinite)), 3)} to ${said(chosen.output, Math.max(...values.filter(Number.isFinite)), 3)}`,
    readings: (at) => {
      const read = [...all].map(([value, curve]) => [value, between(curve.map(([x]) => x * xUnit.factor), curve.map(([, one]) => (one ?? NaN) * yUnit.factor), at)]);
      const told = read.filter(([, one]) => Number.isFinite(one)).map(([value, one]) => `${chosen.second ? `${named_(value)}: ` : ""}${said(chosen.output, one / yUnit.factor, 5)}`);
      return { text: `${said(chosen.first, at / xUnit.factor, 4)}:  ${told.join("; ")}`, dots: read.map(([, one], i) => [at, one, `k${i % 8}`]) };
    },
  });
  legend(byId("study-legend"), names);
}

/** Ends with some room for the dots. */
function room(low, high, isLog) {
  if (!(low < high)) return [low - 1, high + 1];
  if (isLog) return [low / (high / low) ** 0.015, high * (high / low) ** 0.015];
  return [low - 0.015 * (high - low), high + 0.015 * (high - low)];
}

const label = (name, unit) => (unit.label ? `${name} [${unit.label}]` : name);

function table() {
  const { columns, variables, outputs, cases } = found;
  const shown = [
    ...variables.filter((key) => key in columns).map((key) => column(named(key), columns[key], unitOf(key, columns[key]), 6)),
    ...outputs.flatMap((key) => {
      const unit = unitOf(key, columns[key]);
      const errors = columns[`${key}_error`];
      return [column(key.replaceAll("_", " "), columns[key], unit, 6), ...(errors ? [{ ...column("±", errors, unit, 2), cell: (i) => (typeof errors[i] === "number" ? digits(errors[i] * unit.factor, 2) : "–") }] : [])];
    }),
  ];
  const head = html("thead", {}, html("tr", {}, html("th", { scope: "col" }, "case"), shown.map(({ name }) => html("th", { scope: "col", class: "number" }, name))));
  const count = Math.min(cases, MOST_ROWS);
  const rows = Array.from({ length: count }, (_, i) => html("tr", { title: columns.reason?.[i] || null }, html("th", { scope: "row" }, String(columns.case?.[i] ?? i)), shown.map(({ cell }) => html("td", { class: "number" }, cell(i)))));
  const refused = (columns.reason ?? []).filter(Boolean);
  const caption = html("caption", { class: "unseen" }, "The cases of the study, each answer with its stated error");
  byId("cases").replaceChildren(caption, head, html("tbody", {}, rows));
  byId("study-command").textContent = `${cases} cases${refused.length ? `; ${refused.length} refused, the first: ${refused[0]}` : ""}. The same, in SI units as the CSV is: shtaerman sweep ${stem()}-study.toml --output ${stem()}-study`;
}

/** A column of the table: its name with the unit, and what stands in a row. */
function column(name, values, unit, count) {
  const none = (i) => (found.columns.reason?.[i] ? "none" : "infinite");
  const cell = (i) => (typeof values[i] === "number" ? digits(values[i] * unit.factor, count) : values[i] ?? none(i));
  return { name: label(name, unit), cell };
}

const stem = () => state.name.replace(/\.toml$/, "");

byId("save-study").addEventListener("click", () => chosen.first && save(`${stem()}-study.toml`, file(), "application/toml"));
byId("save-cases").addEventListener("click", () => {
  if (!found) return;
  const names = Object.keys(found.columns);
  const quoted = (value) => (typeof value === "string" && /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value ?? "");
  const rows = found.columns[names[0]].map((_, i) => names.map((name) => quoted(found.columns[name][i])).join(","));
  save(`${stem()}-study.csv`, `${names.join(",")}\n${rows.join("\n")}\n`, "text/csv");
});
form.addEventListener("submit", (event) => event.preventDefault());

let shownFor = "";
/** Shows the tab; where the problem has changed, its study begins anew. */
export function showStudy(start_) {
  begun = start_;
  const now = state.toml();
  const isSame = now === shownFor && !state.study;
  shownFor = now;
  if (isSame) {
    if (found) draw();
    return;
  }
  const known = new Set(keys());
  if (!chosen.first || state.study || !known.has(chosen.first) || (chosen.second && !known.has(chosen.second))) begin();
  else {
    chosen.values = {};
    build();
  }
  state.study = null;
  start();
}

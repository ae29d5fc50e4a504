// The paper's kernels: eigenfunctions, eigenvalues, and an equation on each.

import { between, Chart, ends, legend } from "./chart.js";
import { byId, html, settled, show } from "./dom.js";
import { Slider } from "./controls.js";
import { ask, Latest } from "./engine.js";
import { toml } from "./toml.js";
import { digits } from "./units.js";

const DRAWN = 5;
const COUNT = 16;

/** Where the sliders go, by name of the parameter; `b` follows `a`. */
const RANGES = {
  a: { scale: "log", min: 0.1, max: 10, fixed: true, value: 1 },
  b: { scale: "linear", min: 0.02, max: 0.98, value: 0.4 },
  alpha: { scale: "linear", min: 0.05, max: 3.1, value: 2 },
  mu: { scale: "linear", min: 0.02, max: 0.95, value: 0.3 },
  kappa: { scale: "log", min: 0.05, max: 50, fixed: true, value: 1 },
  gamma: { scale: "linear", min: -0.45, max: 0.45, value: 0 },
  chi0: { scale: "log", min: 0.05, max: 50, fixed: true, value: 1 },
  m: { scale: "linear", min: 0, max: 8, value: 0 },
};
/** Where a kernel takes a parameter in another range. */
const OTHERS = { macdonald: { mu: { scale: "linear", min: -0.45, max: 0.45, value: 0.2 } }, "weber-sonine": { mu: { scale: "linear", min: 0, max: 4, value: 0 } } };
const SYMBOLS = { a: "a", b: "b/a", alpha: "α", mu: "μ", kappa: "κ", gamma: "γ", chi0: "χ₀", m: "m" };
const PHYSICAL = {
  log: "strip punch, plane strain",
  "log-ratio": "odd loads on two strips",
  "log-ratio-limit": "odd loads on one strip",
  "log-square": "two equal strips",
  "log-sine": "on a circle, or a row",
  power: "ground stiffer with depth",
  macdonald: "antiplane, decaying",
  "weber-sonine": "disks",
  yukawa: "screened disks",
};

const form = byId("kernel-form");
const functions = new Chart(byId("functions"), { height: 280, reading: byId("functions-reading"), label: "First eigenfunctions" });
const eigenvalues = new Chart(byId("eigenvalues"), { height: 200, reading: byId("eigenvalues-reading"), label: "Eigenvalues" });
const solution = new Chart(byId("equation"), { height: 230, reading: byId("equation-reading"), label: "Solution of the equation" });
const latest = new Latest("kernel", answered);
const latestEquation = new Latest("equation", solved);
let families = [];
let family = null;
let values = {};
let equation = { kind: "second", lambda: 1, rhs: "1" };
const solve = settled(askEquation, 120);

/** Builds the tab at first; an equation file sets it. */
export function showKernels(known, { tree } = {}) {
  const isFirst = families.length === 0;
  families = known;
  if (tree) {
    const { name, interval, ...parameters } = tree.kernel ?? {};
    family = families.find((one) => one.name === name && one.half_line === (interval === "half-line")) ?? families[0];
    values = { ...defaults(family), ...Object.fromEntries(Object.entries(parameters).map(([key, value]) => [key, typeof value === "number" ? value : parseFloat(value)])) };
    equation = { kind: "second", lambda: 1, rhs: "1", ...tree.equation };
  } else if (isFirst) {
    family = families[0];
    values = defaults(family);
  }
  if (isFirst || tree) {
    build();
    buildEquation();
  }
  askKernel();
}

const rangeOf = (of, name) => OTHERS[of.name]?.[name] ?? RANGES[name];
const defaults = (of) => Object.fromEntries(of.parameters.map(({ name }) => [name, rangeOf(of, name).value]));

function build() {
  const focused = form.contains(document.activeElement) ? document.activeElement.value : null;
  const options = families.map((one, i) => {
    const input = html("input", { type: "radio", name: "kernel", value: String(i), checked: one === family });
    input.addEventListener("change", () => {
      family = one;
      values = defaults(one);
      build();
      askKernel();
    });
    return html("label", { class: "family" }, input, html("span", {}, html("span", { class: "formula" }, pretty(one.formula)), html("span", { class: "where" }, `${one.title}, ${one.interval.replaceAll("alpha", "α").replace("inf", "∞")}${PHYSICAL[one.name] ? `: ${PHYSICAL[one.name]}` : ""}`)));
  });
  const sliders = family.parameters.map(({ name, is_whole: isWhole, range }) => {
    const slider = new Slider({
      label: SYMBOLS[name] ?? name,
      value: name === "b" ? values.b / values.a : values[name],
      range: rangeOf(family, name),
      isWhole,
      moved: (value) => {
        // The inner end stays at its share of the outer one.
        if (name === "a" && "b" in values) values.b *= value / values.a;
        values[name] = name === "b" ? value * values.a : value;
        askKernel();
      },
    });
    slider.input.title = range;
    return slider.element;
  });
  form.replaceChildren(html("fieldset", {}, html("legend", {}, "Kernel"), options), html("fieldset", {}, html("legend", {}, "Parameters"), sliders, html("p", { class: "hint" }, "weight w = ", html("span", { class: "formula" }, pretty(family.weight)), `, integrals by ${family.measure}`)));
  if (focused !== null) form.querySelector(`input[name="kernel"][value="${focused}"]`)?.focus();
}

const SIGNS = [[" - ", " − "], ["^-", "^−"], ["kappa", "κ"], ["chi0", "χ₀"], ["gamma", "γ"], ["mu", "μ"], ["alpha", "α"], ["inf", "∞"], ["pi", "π"], ["int", "∫"], ["sqrt", "√"]];

/** A formula as the program writes it, with the signs of print, indices and exponents. */
function pretty(formula) {
  const signs = SIGNS.reduce((text, [plain, sign]) => text.replaceAll(plain, sign), formula);
  return signs.split(/([_^](?:\([^)]*\)|−?[^\s()|_^/,]+))/).map((part) => {
    const raised = { _: "sub", "^": "sup" }[part[0]];
    return raised && part.length > 1 ? html(raised, {}, part.slice(1).replace(/^\((.*)\)$/, "$1")) : part;
  });
}

function askKernel() {
  latest.ask({ name: family.name, half_line: family.half_line, parameters: values, count: COUNT, drawn: DRAWN });
  solve();
}

function answered(answer, _note, isLast) {
  const place = byId("kernel-trouble");
  show(place, Boolean(answer.fault));
  if (answer.fault) {
    if (isLast) place.replaceChildren(html("p", {}, answer.fault.message));
    return;
  }
  drawFunctions(answer);
  drawEigenvalues(answer.spectrum);
  byId("kernel-command").textContent = `The same: ${answer.command} --count ${COUNT} --verify`;
}

function drawFunctions({ functions: curves }) {
  const scaled = curves.map(([name, points]) => {
    const largest = Math.max(...points.map(([, y]) => Math.abs(y ?? 0))) || 1;
    return [name, points.map(([x, y]) => [x, (y ?? NaN) / largest])];
  });
  const xs = scaled[0][1].map(([x]) => x);
  functions.draw({
    x: [xs[0], xs.at(-1)],
    y: [-1.12, 1.12],
    xLabel: "x",
    yLabel: "φₙ / max |φₙ|",
    layers: scaled.map(([, points], i) => ({ kind: "line", class: `k${i}`, points })),
    description: `The first ${scaled.length} eigenfunctions, each scaled to 1`,
    readings: (at) => {
      const read = scaled.map(([, points]) => between(xs, points.map(([, y]) => y), at));
      return { text: `x = ${digits(at, 4)}:  ${read.map((one, i) => `φ${"₀₁₂₃₄₅₆₇₈₉"[i]} = ${digits(one, 3)}`).join(", ")}`, dots: read.map((one, i) => [at, one, `k${i}`]) };
    },
  });
  legend(byId("functions-legend"), scaled.map(([name], i) => [`k${i}`, name]));
}

function drawEigenvalues(spectrum) {
  const { index, eigenvalue, norm } = spectrum;
  const sizes = eigenvalue.map(Math.abs).filter((one) => one > 0);
  const [low, high] = [Math.min(...sizes), Math.max(...sizes)];
  eigenvalues.draw({
    x: [index[0] - 0.5, index.at(-1) + 0.5],
    y: [low / 2, high * 2],
    yLog: true,
    xLabel: "n",
    yLabel: "|λₙ|",
    xTicks: index.filter((n) => n % 3 === 0),
    layers: [{ kind: "line", class: "k0", points: index.map((n, i) => [n, Math.abs(eigenvalue[i])]) }, { kind: "dots", class: "k0", points: index.map((n, i) => [n, Math.abs(eigenvalue[i])]) }],
    description: `Eigenvalues, falling from ${digits(high, 4)} to ${digits(low, 4)}`,
    readings: (at) => {
      const i = Math.min(index.length - 1, Math.max(0, Math.round(at) - index[0]));
      return { x: index[i], text: `λ${index[i]} = ${digits(eigenvalue[i], 8)}`, dots: [[index[i], Math.abs(eigenvalue[i]), "k0"]] };
    },
  });
  const head = html("thead", {}, html("tr", {}, ["n", "eigenvalue λₙ", "norm hₙ", "λₙ/hₙ"].map((name) => html("th", { scope: "col", class: "number" }, name))));
  const rows = index.map((n, i) => html("tr", {}, html("th", { scope: "row", class: "number" }, String(n)), [eigenvalue[i], norm[i], spectrum.expansion_factor[i]].map((one) => html("td", { class: "number" }, digits(one, 12)))));
  byId("spectrum").replaceChildren(html("caption", { class: "unseen" }, "Eigenvalues and norms"), head, html("tbody", {}, rows));
}

function buildEquation() {
  const kind = html("select", { id: "equation-kind", onchange: () => {
    equation.kind = kind.value;
    show(slider.element, kind.value === "second");
    solve();
  } }, [["second", "φ + λ ∫ K φ ds = f"], ["first", "∫ K φ ds = f"]].map(([value, name]) => html("option", { value, selected: value === equation.kind }, name)));
  const rhs = html("input", { type: "text", class: "mono", id: "equation-rhs", value: String(equation.rhs), spellcheck: "false" });
  rhs.addEventListener("input", () => {
    equation.rhs = rhs.value;
    solve();
  });
  const slider = new Slider({
    label: "λ",
    value: typeof equation.lambda === "number" ? equation.lambda : 1,
    range: { scale: "log", min: 0.01, max: 100, fixed: true },
    moved: (value) => {
      equation.lambda = value;
      solve();
    },
  });
  byId("equation-form").replaceChildren(html("label", { class: "stackled", for: "equation-kind" }, "Equation", kind), html("label", { class: "stackled", for: "equation-rhs" }, "f(x)", rhs), slider.element);
  show(slider.element, equation.kind === "second");
}

function askEquation() {
  const { kind, lambda, rhs } = equation;
  const tree = { equation: { kind, ...(kind === "second" && { lambda }), rhs }, kernel: { name: family.name, ...values, ...(family.half_line && { interval: "half-line" }) } };
  latestEquation.ask({ name: "equation.toml", toml: toml(tree), files: {} });
}

function solved(answer, _note, isLast) {
  const place = byId("equation-trouble");
  show(place, Boolean(answer.fault));
  if (answer.fault) {
    if (isLast) place.replaceChildren(html("p", {}, answer.fault.what ? `${answer.fault.field ?? "equation"}: ${answer.fault.what}${answer.fault.help ? `; ${answer.fault.help}` : ""}` : answer.fault.message.split("\n")[0]));
    return;
  }
  const { x, phi } = answer.answer.solution;
  const finite = phi.filter(Number.isFinite).sort((one, other) => one - other);
  // Where a solution of the first kind is infinite, its ends are cut.
  const isCut = phi.some((one) => one === null);
  const seen = isCut ? finite.slice(Math.floor(0.04 * finite.length), Math.ceil(0.96 * finite.length)) : finite;
  const points = x.map((at, i) => [at, phi[i] ?? NaN]);
  solution.draw({
    x: [x[0], x.at(-1)],
    y: ends(seen, { room: 0.1 }),
    xLabel: "x",
    yLabel: "φ",
    layers: [{ kind: "line", class: "k0", points }],
    description: `The solution, from ${digits(finite[0], 4)} to ${digits(finite.at(-1), 4)}`,
    readings: (at) => {
      const value = between(x, phi, at);
      return { text: `x = ${digits(at, 4)}:  φ = ${digits(value, 6)}`, dots: [[at, value, "k0"]] };
    },
  });
  byId("equation-text").textContent = answer.text.split("\n").slice(1).join("\n").trim();
}

form.addEventListener("submit", (event) => event.preventDefault());
byId("equation-form").addEventListener("submit", (event) => event.preventDefault());

// The base of the punch: a formula, a curve drawn by hand, or a measured trace.

import { html, svg, unique } from "./dom.js";
import { choice } from "./controls.js";
import { state } from "./state.js";
import { parts, quantity, written } from "./units.js";

const HANDLES = 21;
const DRAWN = "drawn.csv";
const UNITS = [["m", "m"], ["mm", "mm"], ["um", "µm"], ["nm", "nm"], ["in", "in"], ["uin", "µin"]];
/** A trace is sent with every question. */
const LARGEST = 4 << 20;

const SHAPES = [
  ["flat", "0", "0"],
  ["crown", "x^2 / (2*20)", "r^2 / (2*20)"],
  ["relieved edges", "2e-6 * (max(0, abs(xi) - 0.8)/0.2)^2", "2e-6 * (max(0, rho - 0.8)/0.2)^2"],
  ["wave", "0.2e-6 * (1 - cos(4*pi*xi))", "0.2e-6 * (1 - cos(4*pi*rho))"],
  ["wedge", "1e-4 * abs(x)", "1e-4 * r"],
  ["worn step", "where(xi > 0.5, 0.5e-6, 0)", null],
];
const BARE_SHAPES = [["flat", "0"], ["parabola", "xi^2"], ["wave", "0.5*cos(2*pi*xi)"], ["wedge", "abs(xi)"]];

const path = () => `${state.punch}.profile`;

function kindNow() {
  const profile = state.get(path());
  if (typeof profile !== "object" || profile === null) return "formula";
  return profile.csv === DRAWN && state.drawn ? "drawn" : "csv";
}

/** The control; it joins `controls` for its faults. */
export function profileControl(controls) {
  const kind = kindNow();
  const element = html("div", { class: "field whole", "data-path": path() });
  const fault = html("p", { class: "fault" });
  fault.hidden = true;
  const control = { path: path(), isTable: true, sync: () => {}, blame: () => {} };
  controls.push(control);
  const chosen = (next) => {
    if (next === "drawn") {
      state.drawn ??= startingHeights();
      writeDrawn();
    } else if (next === "csv") {
      const name = Object.keys(state.files).find((one) => one !== DRAWN);
      state.set(path(), name ? { csv: name, ...(state.isDimensionless ? {} : { x_unit: "mm", f_unit: "um" }) } : { csv: "" });
    } else {
      state.set(path(), state.formula ?? "0");
    }
    state.changed({ isBuilt: true });
  };
  element.append(
    choice({ label: "Base, positive away from the body", key: "profile", value: kind, options: [["formula", "Formula"], ["drawn", "Drawn"], ["csv", "Trace (CSV)"]], chosen }),
    ...{ formula, drawn, csv }[kind](control),
    fault,
  );
  control.blame = (text) => {
    // A trace that is not there yet is asked for, not blamed.
    const isAwaited = kind === "csv" && state.get(`${path()}.csv`) === "";
    fault.textContent = isAwaited ? "" : text ?? "";
    fault.hidden = !text || isAwaited;
    control.text?.toggleAttribute("aria-invalid", false);
    if (text && control.text) control.text.setAttribute("aria-invalid", "true");
  };
  return element;
}

function formula(control) {
  const id = unique("profile");
  const text = html("input", { type: "text", class: "mono", id, spellcheck: "false", autocapitalize: "off", "data-key": path() });
  const isRound = state.get(`${state.punch}.geometry`) === "circular";
  const shapes = state.isDimensionless ? BARE_SHAPES : SHAPES.map(([name, plane, round]) => [name, isRound ? round : plane]).filter(([, one]) => one);
  const pick = html(
    "select",
    {
      "aria-label": "A usual shape",
      "data-key": `${path()} shape`,
      onchange: () => {
        if (!pick.value) return;
        state.set(path(), pick.value);
        pick.value = "";
        state.changed({});
      },
    },
    html("option", { value: "" }, "Shapes"),
    shapes.map(([name, one]) => html("option", { value: one }, name)),
  );
  text.addEventListener("input", () => {
    state.set(path(), text.value.trim());
    state.formula = text.value.trim();
    state.changed({ by: text });
  });
  control.text = text;
  control.sync = () => {
    if (document.activeElement === text) return;
    const value = state.get(path());
    text.value = value === undefined ? "" : String(value);
    if (typeof value === "string") state.formula = value;
  };
  control.sync();
  const variables = state.isDimensionless ? "f₀ as a formula in xi = x/a" : `f in metres, ${isRound ? "r" : "x"} in metres, xi = x/a`;
  return [html("div", { class: "field pick" }, html("label", { class: "hint", for: id }, variables), pick), text];
}

function startingHeights() {
  const a = state.halfWidth || 5e-3;
  const scale = state.isDimensionless ? 1 : 1e-6;
  return { scale: state.isDimensionless ? 2 : "2 µm", heights: Array.from({ length: HANDLES }, (_, i) => Number((scale * (2 * (i / (HANDLES - 1)) - 1) ** 2).toPrecision(3))), a };
}

/** The size of the drawing in metres. */
function fullScale() {
  const found = parts(state.drawn.scale);
  const units = { "": 1, m: 1, mm: 1e-3, "µm": 1e-6, um: 1e-6, "μm": 1e-6, nm: 1e-9, in: 0.0254, uin: 2.54e-8 };
  const factor = found && units[found.unit];
  return found && factor && found.number > 0 ? found.number * factor : state.isDimensionless ? 2 : 2e-6;
}

/** The drawn curve as a trace from edge to edge. */
export function writeDrawn() {
  if (!state.drawn) return;
  const a = state.halfWidth || state.drawn.a;
  const last = state.drawn.heights.length - 1;
  const rows = state.drawn.heights.map((height, i) => `${(2 * (i / last) - 1) * a},${height}`);
  state.files[DRAWN] = `${state.isDimensionless ? "xi,f0" : "x,f"}\n${rows.join("\n")}\n`;
  state.set(path(), { csv: DRAWN });
}

function drawn(control) {
  const [width, height, edge] = [300, 150, 14];
  const at = (i) => edge + (i / (HANDLES - 1)) * (width - 2 * edge);
  const up = (value) => height - edge - (value / fullScale()) * (height - 2 * edge);
  const line = svg("path", { class: "base" });
  const shown = (value) => (state.isDimensionless ? String(value) : quantity(value, "length"));
  const handles = Array.from({ length: HANDLES }, (_, i) =>
    svg("circle", { class: "handle", r: 5.5, cx: at(i), tabindex: 0, role: "slider", "aria-orientation": "vertical", "aria-label": `Height at ${Math.round(200 * (i / (HANDLES - 1)) - 100)} % of the half-width` }),
  );
  const pad = svg("svg", { class: "pad", viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none", role: "group", "aria-label": "Drawn base: drag, or use the arrow keys on a point" }, svg("line", { x1: 0, x2: width, y1: height - edge, y2: height - edge }), line, handles);
  let isSymmetric = state.drawn.isSymmetric ?? true;
  const redraw = () => {
    const { heights } = state.drawn;
    line.setAttribute("d", heights.map((value, i) => `${i ? "L" : "M"}${at(i)} ${up(value)}`).join(""));
    handles.forEach((handle, i) => {
      handle.setAttribute("cy", up(heights[i]));
      handle.setAttribute("aria-valuemin", 0);
      handle.setAttribute("aria-valuemax", fullScale());
      handle.setAttribute("aria-valuenow", heights[i]);
      handle.setAttribute("aria-valuetext", shown(heights[i]));
    });
  };
  const put = (i, value, what) => {
    const rounded = Number(Math.min(fullScale(), Math.max(0, value)).toPrecision(3));
    state.drawn.heights[i] = rounded;
    if (isSymmetric) state.drawn.heights[HANDLES - 1 - i] = rounded;
    writeDrawn();
    redraw();
    state.changed({ isMoving: true, ...what });
  };
  const drag = (event) => {
    const box = pad.getBoundingClientRect();
    const share = ((event.clientX - box.left) / box.width) * width;
    const i = Math.round(((share - edge) / (width - 2 * edge)) * (HANDLES - 1));
    const level = (height - edge - ((event.clientY - box.top) / box.height) * height) / (height - 2 * edge);
    if (i >= 0 && i < HANDLES) put(i, level * fullScale());
  };
  pad.addEventListener("pointerdown", (event) => {
    pad.setPointerCapture(event.pointerId);
    drag(event);
  });
  pad.addEventListener("pointermove", (event) => event.buttons && drag(event));
  pad.addEventListener("pointerup", () => state.changed({}));
  handles.forEach((handle, i) =>
    handle.addEventListener("keydown", (event) => {
      const step = { ArrowUp: 0.02, ArrowDown: -0.02, PageUp: 0.1, PageDown: -0.1 }[event.key];
      if (step) {
        event.preventDefault();
        put(i, state.drawn.heights[i] + step * fullScale(), { isMoving: false });
      } else if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
        event.preventDefault();
        handles[i + (event.key === "ArrowRight" ? 1 : -1)]?.focus();
      }
    }),
  );
  const id = unique("scale");
  const scale = html("input", { type: "text", id, value: String(state.drawn.scale), "data-key": "drawn scale" });
  scale.addEventListener("input", () => {
    state.drawn.scale = written(scale.value);
    redraw();
  });
  const box = html("input", { type: "checkbox", checked: isSymmetric, "data-key": "drawn symmetric" });
  box.addEventListener("change", () => {
    isSymmetric = box.checked;
    state.drawn.isSymmetric = isSymmetric;
  });
  control.sync = redraw;
  redraw();
  return [pad, html("div", { class: "field" }, html("label", { for: id }, "Height of the drawing"), scale), html("label", { class: "check" }, box, "Same on both sides")];
}

function csv(control) {
  const profile = state.get(path());
  const isThere = profile.csv && state.files[profile.csv] !== undefined;
  const rows = isThere ? state.files[profile.csv].split("\n").filter((line) => line.trim() && !line.startsWith("#")).length : 0;
  const picker = html("input", { type: "file", accept: ".csv,.txt,.dat,.tsv,text/csv,text/plain", class: "unseen", "data-key": "csv file", onchange: () => picker.files[0] && take(picker.files[0], said) });
  const said = html("p", { class: "hint" }, isThere ? `${profile.csv}: ${rows} lines` : "Positions and heights, two columns, from edge to edge of the punch.");
  const drop = html("div", { class: "drop" }, said, html("button", { type: "button", class: "small", "data-key": "csv button", onclick: () => picker.click() }, isThere ? "Another file" : "Choose a file"), html("span", {}, "or drop it here"), picker);
  drop.addEventListener("dragover", (event) => {
    event.preventDefault();
    drop.classList.add("over");
  });
  drop.addEventListener("dragleave", () => drop.classList.remove("over"));
  drop.addEventListener("drop", (event) => {
    event.preventDefault();
    event.stopPropagation();
    drop.classList.remove("over");
    const [file] = event.dataTransfer.files;
    if (file) take(file, said);
  });
  control.sync = () => {};
  const unit = (key, label) => {
    const id = unique("unit");
    const pick = html(
      "select",
      {
        id,
        "data-key": key,
        onchange: () => {
          state.set(`${path()}.${key}`, pick.value);
          state.changed({});
        },
      },
      UNITS.map(([value, text]) => html("option", { value, selected: (profile[key] ?? "m") === value }, text)),
    );
    return html("div", { class: "field" }, html("label", { for: id }, label), pick);
  };
  const tick = (key, label, on = true, value = profile[key]) => {
    const box = html("input", { type: "checkbox", checked: value === on, "data-key": key });
    box.addEventListener("change", () => {
      state.set(`${path()}.${key}`, box.checked ? on : undefined);
      state.changed({});
    });
    return html("label", { class: "check" }, box, label);
  };
  const text = (key, label, value, put, hint) => {
    const id = unique("trace");
    const input = html("input", { type: "text", id, value: value ?? "", placeholder: hint ?? "", "data-key": key });
    input.addEventListener("input", () => {
      put(input.value.trim() === "" ? undefined : written(input.value));
      state.changed({ by: input });
    });
    return html("div", { class: "field" }, html("label", { for: id }, label), input);
  };
  const plain = (key) => (value) => state.set(`${path()}.${key}`, value);
  const filter = (cutoff) => state.set(`${path()}.filter`, cutoff === undefined ? undefined : { kind: "gauss", cutoff });
  const isOpen = ["x_column", "f_column", "skip", "reverse", "filter"].some((key) => profile[key] !== undefined);
  return [
    drop,
    ...(state.isDimensionless ? [] : [unit("x_unit", "Unit of positions"), unit("f_unit", "Unit of heights")]),
    tick("centre", "Its middle lies under the middle of the punch"),
    tick("level", "Take its mean line away", "mean-line"),
    tick("flip", "Heights were measured towards the body"),
    html(
      "details",
      { open: isOpen },
      html("summary", { "data-key": "trace more" }, "More about the trace"),
      text("x_column", "Column of positions", profile.x_column, plain("x_column"), "1"),
      text("f_column", "Column of heights", profile.f_column, plain("f_column"), "2"),
      text("skip", "Lines to skip", profile.skip, plain("skip"), "0"),
      text("filter", "Gaussian filter, cutoff", profile.filter?.cutoff, filter, "0.8 mm"),
      tick("reverse", "Turn it end for end"),
    ),
  ];
}

/** Takes a trace that was dropped or chosen. */
export async function take(file, said) {
  if (file.size > LARGEST) {
    if (said) said.textContent = `${file.name} has ${file.size} bytes, more than the ${LARGEST} that the page takes: solve it on the command line.`;
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = "";
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  for (const name of Object.keys(state.files)) if (name !== DRAWN) delete state.files[name];
  state.files[file.name] = text;
  const old = state.get(path());
  const units = state.isDimensionless ? {} : { x_unit: old?.x_unit ?? "mm", f_unit: old?.f_unit ?? "um" };
  const { csv: _csv, x_unit: _x, f_unit: _f, ...rest } = typeof old === "object" && old !== null ? old : {};
  state.set(path(), { csv: file.name, ...units, ...rest });
  state.changed({ isBuilt: true });
}

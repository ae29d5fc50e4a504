// The page: what is shown follows the problem, and the problem follows what is moved and typed.

import { showAnswer, showTrouble } from "./answers.js";
import { become, byId, html, save, settled, show, tabs } from "./dom.js";
import { ask, Latest } from "./engine.js";
import { blame, showInputs } from "./inputs.js";
import { showKernels } from "./kernels.js";
import { askMap, forgetMap, showMap, viewWhileMoving } from "./map.js";
import { showModel } from "./model.js";
import { showPaper } from "./paper.js";
import { showPictures } from "./pictures.js";
import { take as takeTrace, writeDrawn } from "./profile.js";
import { state } from "./state.js";
import { showStudy } from "./study.js";
import "./theme.js";

/** The answer with its audit follows when nothing has moved for this time, in milliseconds. */
const REST = 180;

let begun = null;
const solve = new Latest("solve", answered, (isAudited) => isAudited);
const audit = settled(() => askFor(true), REST);

const isDrawn = () => state.drawn && state.get(`${state.punch}.profile.csv`) === "drawn.csv";

const question = () => JSON.stringify(state.question());
/** The question that the shown answer is of. */
let solvedFor = "";

function askFor(isAudited) {
  if (isDrawn()) writeDrawn();
  solve.ask({ ...state.question(), audit: isAudited, map: isAudited ? undefined : viewWhileMoving() }, isAudited);
}

const panel = byId("panel-contact");

function answered(answer, isAudited, isLast) {
  if (isLast && (isAudited || answer.fault)) panel.removeAttribute("aria-busy");
  if (answer.fault) {
    if (!isLast) return;
    // An answer whose audit took too long is an answer all the same.
    if (isAudited && !answer.fault.exit_code && state.answer && solvedFor === question()) {
      said(`Without audit: ${answer.fault.message}. The errors are those that the method states of itself.`);
      askMap(false, state.answer.picture.has_stresses);
      return;
    }
    const isTold = blame(answer.fault);
    showTrouble(answer.fault, isTold, answer.warnings);
    return;
  }
  const before = state.halfWidth;
  state.si = keepMoving(answer.inputs);
  state.answer = answer;
  solvedFor = question();
  blame(null);
  showTrouble(null);
  showInputs();
  showAnswer(answer);
  showPictures(answer);
  showModel(answer);
  if (answer.map) showMap(answer.map, solve.took);
  else if (isAudited && isLast) askMap(false, answer.picture.has_stresses);
  else askMap(true, answer.picture.has_stresses);
  showUnits();
  show(byId("save-map"), answer.picture.has_stresses);
  show(byId("save-profile"), Object.keys(state.files).length > 0);
  document.dispatchEvent(new CustomEvent("solved", { detail: { isAudited, isLast } }));
  if (isDrawn() && state.halfWidth !== before) askFor(isAudited);
}

/** What is being moved is ahead of the answer. */
function keepMoving(inputs) {
  const moved = document.activeElement?.closest?.(".field")?.dataset.path;
  const isMoving = document.activeElement?.type === "range" && solve.isBusy;
  return isMoving && moved in state.si ? { ...inputs, [moved]: state.si[moved] } : inputs;
}

const SYSTEMS = { si: "SI with prefixes", mm: "mm, N, MPa", inch: "inch, lbf, psi" };
const units = byId("units");
units.addEventListener("change", () => {
  state.set("output", units.value === "si" ? undefined : { ...state.get("output"), units: units.value });
  state.changed({});
});

function showUnits() {
  const stated = state.get("output.units") ?? "si";
  const isOwn = typeof stated !== "string";
  const chosen = isOwn ? "" : stated;
  const names = [...begun.unit_systems, ...(isOwn ? [""] : [])];
  if (document.activeElement === units) return;
  become(units, names.map((name) => html("option", { value: name }, name === "" ? "as the file says" : SYSTEMS[name] ?? name)));
  if (units.value !== chosen) units.value = chosen;
}

const editor = byId("editor");

function writeFile() {
  if (document.activeElement === editor) return;
  editor.value = state.toml();
  show(byId("editor-fault"), false);
}

// Nobody reads the file while a slider moves, and a frame in which little changes is drawn sooner.
const writeFileAtRest = settled(writeFile, REST);

state.addEventListener("change", ({ detail }) => {
  if (detail.isNew) {
    state.si = detail.si ?? {};
    state.answer = null;
    forgetMap();
  }
  if (!detail.by || detail.isBuilt) showInputs(detail);
  if (detail.isMoving) writeFileAtRest();
  else writeFile();
  document.title = `${state.name}: Shtaerman`;
  panel.setAttribute("aria-busy", "true");
  askFor(false);
  audit();
});

state.addEventListener("step", () => {
  byId("undo").disabled = !state.canUndo;
  byId("redo").disabled = !state.canRedo;
});

/** Takes a file as text: the controls follow it. */
async function take(name, text, files, { isTyped = false } = {}) {
  const read = await ask("read", { name, toml: text, files });
  const place = byId("editor-fault");
  if (!read.tree) {
    // No TOML at all: the text is kept where it can be mended.
    place.textContent = read.fault.message;
    show(place, true);
    editor.setAttribute("aria-invalid", "true");
    if (!isTyped) {
      editor.value = text;
      showTrouble(read.fault, false);
    }
    return;
  }
  editor.removeAttribute("aria-invalid");
  show(place, false);
  if (read.kind === "equation") {
    showKernels(begun.kernels, { tree: read.tree });
    choose("kernels");
    return;
  }
  const { study, ...tree } = read.tree;
  state.si = read.inputs;
  state.name = name;
  state.tree = tree;
  state.files = files;
  state.drawn = null;
  state.study = study ?? null;
  state.changed({ isNew: true, si: read.inputs });
  if (study) choose("study");
}

editor.addEventListener("input", settled(() => take(state.name, editor.value, state.files, { isTyped: true }), 250));
editor.addEventListener("pointerdown", writeFile);
editor.addEventListener("blur", () => {
  if (byId("editor-fault").hidden) editor.value = state.toml();
});

byId("undo").addEventListener("click", () => state.undo());
byId("redo").addEventListener("click", () => state.redo());
document.addEventListener("keydown", (event) => {
  const isText = event.target.matches?.('input[type="text"], textarea');
  if (!(event.ctrlKey || event.metaKey) || isText) return;
  const key = event.key.toLowerCase();
  if (key === "z" || key === "y") {
    event.preventDefault();
    if (key === "y" || event.shiftKey) state.redo();
    else state.undo();
  }
});

const said = settled((text) => {
  byId("said").textContent = text;
}, 0);

async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
    said(`${what} is in the clipboard.`);
  } catch {
    said("The browser does not let the page write to the clipboard.");
  }
}

byId("link").addEventListener("click", async () => {
  const link = await state.link();
  history.replaceState(null, "", `#${link}`);
  copy(location.href, "A link that holds this state");
});
for (const button of document.querySelectorAll("[data-copy]")) {
  button.addEventListener("click", () => copy(byId(button.dataset.copy).textContent, "The text"));
}

const stem = () => state.name.replace(/\.toml$/, "");

/** Saves what the program makes of the problem. */
async function saveMade(operation, question, key, name, type) {
  said("…");
  const made = await ask(operation, question);
  if (made.fault) {
    said(made.fault.message);
    return;
  }
  save(name, made[key], type);
  said(`${name} is saved.`);
}

byId("save-toml").addEventListener("click", () => {
  save(state.name, state.toml(), "application/toml");
  const names = Object.keys(state.files).filter((name) => name === state.get(`${state.punch}.profile.csv`));
  said(names.length ? `${state.name} is saved; it needs ${names[0]} beside it.` : `${state.name} is saved.`);
});
byId("save-profile").addEventListener("click", () => {
  const name = state.get(`${state.punch}.profile.csv`) ?? Object.keys(state.files)[0];
  const bytes = Uint8Array.from(state.files[name] ?? "", (one) => one.charCodeAt(0));
  save(name, bytes, "text/csv");
});
byId("save-csv").addEventListener("click", () => saveMade("csv", state.question(), "text", `${stem()}.csv`, "text/csv"));
byId("save-svg").addEventListener("click", () => saveMade("svg", state.question(), "text", `${stem()}.svg`, "image/svg+xml"));
byId("save-map").addEventListener("click", () => saveMade("map-svg", { ...state.question(), component: byId("component").value, points: [161, 81] }, "text", `${stem()}-stress.svg`, "image/svg+xml"));
byId("save-report").addEventListener("click", () => saveMade("report", state.question(), "text", `${stem()}.html`, "text/html"));

const choose = tabs(document.querySelector(".top [role=tablist]"), (name) => {
  state.tab = name;
  if (name === "study") showStudy(begun);
  if (name === "kernels") showKernels(begun.kernels);
  if (name === "paper") showPaper();
  if (name === "contact" && state.answer) showPictures(state.answer);
});
tabs(document.querySelector(".subtabs"));

// A file may be dropped anywhere.
document.addEventListener("dragover", (event) => event.preventDefault());
document.addEventListener("drop", async (event) => {
  event.preventDefault();
  const [file] = event.dataTransfer?.files ?? [];
  if (file && /\.toml$/i.test(file.name)) take(file.name, await file.text(), state.files);
  else if (file) takeTrace(file);
});

async function begin() {
  begun = await ask("start");
  if (begun.fault) {
    showTrouble(begun.fault, false);
    return;
  }
  byId("version").textContent = `Shtaerman ${begun.version}.`;
  const examples = byId("examples");
  examples.append(...begun.examples.map((one, i) => html("option", { value: String(i), title: one.title }, one.name.replace(/\.toml$/, "").replaceAll("_", " "))));
  examples.addEventListener("change", () => {
    const one = begun.examples[Number(examples.value)];
    if (examples.value !== "") take(one.name, one.toml, { ...one.files });
    examples.value = "";
  });
  const isHeld = location.hash.length > 1 && (await state.open(location.hash.slice(1)));
  if (isHeld) {
    choose(state.tab);
    return;
  }
  const file = begun.file ?? begun.examples[0];
  await take(file.name, file.toml, { ...file.files });
}

window.addEventListener("hashchange", () => state.open(location.hash.slice(1)));
begin();

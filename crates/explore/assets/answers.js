// The answer in figures and words.

import { become, byId, html, settled, show } from "./dom.js";
import { state } from "./state.js";

const SIGN = { bound: "guaranteed", estimate: "estimated" };

function cardsShown() {
  const table = state.isDimensionless ? "dimensionless" : "load";
  const isPrescribed = (key) => state.get(`${table}.${key}`) !== undefined;
  return [isPrescribed("settlement") ? "force" : "settlement", isPrescribed("tilt") ? "moment" : "tilt", "peak_pressure", "contact_width"];
}

/** What the shown digits are: the number, and smaller its unit. */
function value(text) {
  const found = /^(\S+) (.+)$/.exec(text);
  return found ? [found[1], html("small", {}, ` ${found[2]}`)] : [text];
}

function card(one) {
  const error = one.error ? `± ${one.error}, ${SIGN[one.kind] ?? ""}` : one.key === "contact_width" && one.kind ? "edges exact" : "no error stated";
  return html(
    "div",
    { class: "figure", "data-key": one.key, "data-si": one.si ?? "" },
    html("div", { class: "name" }, one.name),
    html("div", { class: "value" }, value(one.value)),
    html("div", { class: "error" }, error),
  );
}

// A screen reader hears the words when nothing moves any more.
const say = settled((words) => {
  become(byId("words"), words.map((text, i) => html("p", { class: i === words.length - 1 && words.length > 3 ? "sure" : "" }, `${text} `)));
}, 120);

function showDoubts(doubts) {
  become(byId("warnings"), doubts.map((warning) => html("li", { "data-code": warning.code }, warning.message)));
  show(byId("warnings"), doubts.length > 0);
}

/** Shows a solved contact. */
export function showAnswer(answer) {
  const cards = cardsShown();
  become(byId("cards"), cards.map((key) => card(answer.cards.find((one) => one.key === key))));
  say(answer.words);
  const { warnings } = answer.answer;
  // An error a little above what was aimed at is stated with the answer: it belongs to the notes.
  const doubts = warnings.filter(({ code }) => code !== "tolerance_not_met");
  showDoubts(doubts);
  const rows = answer.table.map(([name, shown, note]) => html("tr", {}, html("th", { scope: "row" }, name), html("td", {}, html("strong", {}, shown)), html("td", { class: "note" }, note)));
  become(byId("table").tBodies[0], rows);
  const short = warnings.filter((warning) => !doubts.includes(warning)).map(({ message }) => `accuracy: ${message}`);
  const notes = [...answer.notes.split("\n").filter(Boolean), ...short].map((line) => {
    const at = line.indexOf(": ");
    return html("div", {}, html("dt", {}, `${line.slice(0, at)}:`), html("dd", {}, line.slice(at + 2)));
  });
  become(byId("notes"), notes);
  byId("python").textContent = answer.python;
  byId("shell").textContent = `${answer.command}\n${answer.command} --plot punch.svg --format json`;
}

/** Shows why there is no answer, and what is doubtful about the file, or that there is none. */
export function showTrouble(fault, isTold, doubts = []) {
  const place = byId("trouble");
  show(place, Boolean(fault));
  document.querySelector(".contact").classList.toggle("stale", Boolean(fault));
  if (!fault) {
    place.replaceChildren();
    return;
  }
  showDoubts(doubts);
  const [first, ...rest] = fault.message.split("\n");
  const parts = [html("p", {}, isTold ? `${fault.field ? `${fault.field}: ` : ""}${fault.what}${fault.help ? `; ${fault.help}` : ""}` : first)];
  // The place in the file is told where no control shows it.
  if (!isTold && rest.length) parts.push(html("pre", {}, rest.join("\n")));
  place.replaceChildren(...parts);
}

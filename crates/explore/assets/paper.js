// The paper's tables and its figure.

import { between, Chart, ends, legend } from "./chart.js";
import { byId, html } from "./dom.js";
import { Slider } from "./controls.js";
import { ask, Latest } from "./engine.js";
import { digits } from "./units.js";

const figure = new Chart(byId("figure2"), { height: 300, reading: byId("figure2-reading"), label: "Fig. 2" });
const latest = new Latest("curve", drawn);
const differing = byId("differing");
let figures = null;

differing.addEventListener("change", () => figures && tables());
byId("figure2-form").addEventListener("submit", (event) => event.preventDefault());

/** Shows the tab; the tables are computed once. */
export async function showPaper() {
  if (!byId("figure2-form").hasChildNodes()) {
    const moved = (lambda0) => latest.ask({ lambda0 });
    byId("figure2-form").append(new Slider({ label: "λ₀ = a/(E χ)", value: 10, range: { scale: "log", min: 0.001, max: 100, fixed: true }, moved }).element);
  }
  if (figure.content) figure.draw(figure.content);
  else latest.ask({ lambda0: 10 });
  if (figures) return;
  const told = await ask("paper");
  if (told.fault) {
    byId("agreeing").textContent = told.fault.message;
    return;
  }
  figures = told.figures;
  byId("agreeing").textContent = `${told.agreeing} of ${told.total} printed figures are what the paper’s own computation gives, to the last printed digit. ν = 0.25, P₀ = 0.001, M₀ = 0.0001; the captions of Tables 1 and 2 are swapped in print.`;
  tables();
}

function drawn(curve) {
  if (curve.fault) return;
  const { xi, as_printed: printed, exact, lambda0, theta0 } = curve;
  const y = ends([...printed, ...exact], { zero: true });
  figure.draw({
    x: [-1, 1],
    y,
    xLabel: "ξ = x/a",
    yLabel: "p₀ = p/E",
    layers: [
      { kind: "line", class: "k1 dashed", points: xi.map((at, i) => [at, printed[i]]) },
      { kind: "line", class: "k0", points: xi.map((at, i) => [at, exact[i]]) },
    ],
    description: `Pressure for lambda0 = ${lambda0}: in the middle ${digits(between(xi, exact, 0), 4)}, by the printed formula ${digits(between(xi, printed, 0), 4)}`,
    readings: (at) => {
      const [one, other] = [between(xi, exact, at), between(xi, printed, at)];
      return { text: `ξ = ${digits(at, 3)}:  true ${digits(one, 5)}, as printed ${digits(other, 5)}`, dots: [[at, other, "k1"], [at, one, "k0"]] };
    },
  });
  legend(byId("figure2-legend"), [["k0", `as it is, λ₀ = ${digits(lambda0, 3)}, θ₀ = ${digits(theta0, 4)}`], ["k1", "as the paper computed it: (3.8) as printed, n = 45", "dash"]]);
}

function tables() {
  const heads = ["λ₀", "f₀/λ₀", "", "printed", "as the paper computed it", "true", "why it differs"];
  const parts = [1, 2, 3].map((number) => {
    const rows = figures.filter((one) => one.table === number && (!differing.checked || one.reason));
    let last = null;
    const body = rows.map((one) => {
      const group = `${one.lambda0} ${one.profile}`;
      const isFirst = group !== last;
      last = group;
      return html(
        "tr",
        { class: isFirst ? "first-of-group" : null },
        html("th", { scope: "row" }, one.lambda0),
        html("td", { class: "formula" }, pretty(one.profile)),
        html("td", { class: "formula" }, pretty(one.symbol)),
        html("td", { class: `number${one.agrees ? "" : " differs"}` }, one.printed),
        html("td", { class: "number" }, digits(one.as_the_paper, 8)),
        html("td", { class: `number${one.reason ? " differs" : ""}` }, digits(one.exact, 10)),
        html("td", { class: "note" }, one.why ?? ""),
      );
    });
    const head = html("thead", {}, html("tr", {}, heads.map((name, i) => html("th", { scope: "col", class: i >= 3 && i <= 5 ? "number" : null }, name || html("span", { class: "unseen" }, "quantity")))));
    const id = `paper-table-${number}`;
    const profiles = [...new Set(figures.filter((one) => one.table === number).map((one) => pretty(one.profile)))];
    return [
      html("h3", { id }, `Table ${number}: f₀/λ₀ = ${profiles.join(" and ")}`),
      html("div", { class: "scroll", tabindex: 0, role: "region", "aria-labelledby": id }, html("table", { class: "figures" }, html("caption", { class: "unseen" }, `Table ${number}`), head, html("tbody", {}, body))),
    ];
  });
  byId("paper-tables").replaceChildren(...parts.flat());
}

const pretty = (symbol) => symbol.replace("delta0", "δ₀").replace("alpha0", "α₀").replace("p0", "p₀").replace("M0", "M₀").replace("P0", "P₀").replaceAll("xi", "ξ").replaceAll("^2", "²");

// The model as a formula: the parts that the problem has.

import { byId, show } from "./dom.js";
import { state } from "./state.js";

/** Shows the parts for the problem as it is. */
export function showModel({ picture }) {
  const foundation = state.get("foundation") ?? {};
  const bare = state.get("dimensionless") ?? {};
  const law = picture.is_smooth ? "smooth" : typeof foundation.roughness === "object" || bare.exponent !== undefined ? "power" : "linear";
  const isLayered = foundation.thickness !== undefined || foundation.coating !== undefined || bare.thickness !== undefined;
  const kernel = isLayered ? "layered" : foundation.grading_modulus !== undefined ? "graded" : { circular: "circular", periodic: "periodic" }[picture.geometry] ?? "plane";
  const parts = { law, kernel, contact: state.get("solver.contact") ?? "unilateral" };
  for (const part of byId("model").querySelectorAll("[class]")) {
    const [kind, value] = part.getAttribute("class").split("-");
    if (kind in parts) part.toggleAttribute("hidden", parts[kind] !== value);
  }
  show(byId("model"), true);
}

// Light, dark, or as the system has it.

import { byId } from "./dom.js";

const NAMES = { auto: "as the system", light: "light", dark: "dark" };
const button = byId("theme");

function kept() {
  try {
    return localStorage.getItem("theme") ?? "auto";
  } catch {
    return "auto";
  }
}

function use(theme) {
  if (theme === "auto") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
  button.setAttribute("aria-label", `Theme: ${NAMES[theme]}`);
  button.title = `Theme: ${NAMES[theme]}`;
}

let now = kept() in NAMES ? kept() : "auto";
use(now);
button.addEventListener("click", () => {
  const order = Object.keys(NAMES);
  now = order[(order.indexOf(now) + 1) % order.length];
  use(now);
  try {
    localStorage.setItem("theme", now);
  } catch {
    // Not kept where nothing may be.
  }
});

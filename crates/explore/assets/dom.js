// Elements of HTML and SVG, made without parsing text.

const SVG = "http://www.w3.org/2000/svg";

export const byId = (id) => document.getElementById(id);

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "value" && "value" in element) element.value = value;
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** An element of HTML; attributes that begin with `on` are listeners. */
export const html = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);

/** An element of SVG. */
export const svg = (tag, attributes, ...children) => fill(document.createElementNS(SVG, tag), attributes, children);

/**
 * Makes the children of an element those given, and keeps what is there already: only what differs is laid out and painted anew.
 * The given ones have no listeners and no state beyond their attributes.
 */
export function become(element, children) {
  const old = [...element.childNodes];
  children.forEach((child, i) => {
    if (!old[i]) element.append(child);
    else if (!alter(old[i], child)) old[i].replaceWith(child);
  });
  for (const one of old.slice(children.length)) one.remove();
}

/** Makes one node the other, if they are of one kind. */
function alter(node, other) {
  if (node.isEqualNode(other)) return true;
  if (node.nodeName !== other.nodeName) return false;
  if (node.nodeType !== Node.ELEMENT_NODE) {
    node.data = other.data;
    return true;
  }
  for (const { name, value } of other.attributes) if (node.getAttribute(name) !== value) node.setAttribute(name, value);
  for (const name of node.getAttributeNames()) if (!other.hasAttribute(name)) node.removeAttribute(name);
  become(node, [...other.childNodes]);
  return true;
}

/** Shows an element or not. */
export function show(element, isShown) {
  element.hidden = !isShown;
}

let last = 0;
/** A name that no other element has. */
export const unique = (stem) => `${stem}-${++last}`;

/** Calls `act` once the calls have ceased for `delay` milliseconds. */
export function settled(act, delay) {
  let timer = 0;
  return (...words) => {
    clearTimeout(timer);
    timer = setTimeout(() => act(...words), delay);
  };
}

/** Saves text as a file of the user. */
export function save(name, text, type) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = html("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** Tabs: arrows, Home and End move, as the patterns of WAI-ARIA have it; `chosen` hears of it. */
export function tabs(list, chosen) {
  const all = [...list.querySelectorAll('[role="tab"]')];
  const choose = (tab, isFocused) => {
    for (const other of all) {
      const isChosen = other === tab;
      other.setAttribute("aria-selected", String(isChosen));
      other.tabIndex = isChosen ? 0 : -1;
      show(byId(other.getAttribute("aria-controls")), isChosen);
    }
    if (isFocused) tab.focus();
    chosen?.(tab.id.replace("tab-", ""));
  };
  list.addEventListener("click", (event) => {
    const tab = event.target.closest('[role="tab"]');
    if (tab) choose(tab, true);
  });
  list.addEventListener("keydown", (event) => {
    const at = all.indexOf(document.activeElement);
    const next = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: all.length - 1 }[event.key];
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    choose(all[(next + all.length) % all.length], true);
  });
  return (name) => {
    const tab = all.find((one) => one.id === `tab-${name}`);
    if (tab) choose(tab, false);
  };
}

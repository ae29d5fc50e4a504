// Writes a problem file.

const bare = (key) => (/^[A-Za-z0-9_-]+$/.test(key) ? key : text(key));

// A string of JSON is one of TOML, but for the delete character.
const text = (value) => JSON.stringify(value).replaceAll("\u007f", "\\u007f");

function number(value) {
  if (Number.isInteger(value) && Math.abs(value) < 2 ** 53) return String(value);
  const written = String(value);
  return /[.e]/.test(written) ? written : `${written}.0`;
}

const isTable = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

function item(value) {
  if (typeof value === "string") return text(value);
  if (typeof value === "number") return number(value);
  if (typeof value === "boolean") return String(value);
  if (Array.isArray(value)) return `[${value.map(item).join(", ")}]`;
  const entries = Object.entries(value).map(([key, inner]) => `${bare(key)} = ${item(inner)}`);
  return entries.length ? `{ ${entries.join(", ")} }` : "{}";
}

function table(name, entries) {
  const lines = [`[${name}]`];
  const deeper = [];
  for (const [key, value] of entries) {
    // A table of tables, such as what varies in a study, is written line by line.
    if (isTable(value) && Object.values(value).length && Object.values(value).every((one) => isTable(one) || Array.isArray(one))) {
      for (const [inner, one] of Object.entries(value)) lines.push(`${bare(key)}.${bare(inner)} = ${item(one)}`);
    } else if (isTable(value) && key === "coating") {
      deeper.push("", ...table(`${name}.${bare(key)}`, Object.entries(value)));
    } else {
      lines.push(`${bare(key)} = ${item(value)}`);
    }
  }
  return [...lines, ...deeper];
}

/** The file of a tree: plain keys first, then its tables in their order. */
export function toml(tree) {
  const entries = Object.entries(tree);
  const plain = entries.filter(([, value]) => !isTable(value));
  const lines = plain.map(([key, value]) => `${bare(key)} = ${item(value)}`);
  for (const [name, value] of entries.filter(([, value]) => isTable(value))) {
    if (lines.length) lines.push("");
    lines.push(...table(bare(name), Object.entries(value)));
  }
  return `${lines.join("\n")}\n`;
}

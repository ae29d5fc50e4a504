// Numbers and units as people write them. What counts is read by the program; here it is only shown and moved.

const PREFIXES = [[-12, "p"], [-9, "n"], [-6, "µ"], [-3, "m"], [0, ""], [3, "k"], [6, "M"], [9, "G"], [12, "T"]];

/** The units of quantities: symbol, power of ten of one of it in SI, whether prefixes go with it. */
export const UNITS = {
  length: { symbol: "m", power: 0, from: -12, to: 3 },
  pressure: { symbol: "Pa", power: 0, from: -12, to: 12 },
  line_force: { symbol: "N/m", power: 0, from: -12, to: 12 },
  force: { symbol: "N", power: 0, from: -12, to: 12 },
  moment: { symbol: "N m", power: 0, from: -12, to: 12 },
  compliance: { symbol: "µm/MPa", power: -12, from: 0, to: 0 },
  subgrade: { symbol: "Pa/m", power: 0, from: 0, to: 12 },
  angle: { symbol: "rad", power: 0, from: -9, to: 0 },
  none: { symbol: "", power: 0, from: 0, to: 0 },
};

/** The factor and the label that suit values up to `largest` in SI. */
export function axisUnit(largest, kind) {
  const unit = UNITS[kind] ?? UNITS.none;
  const exponent = largest > 0 && Number.isFinite(largest) ? Math.floor(Math.log10(largest) + 1e-12) - unit.power : 0;
  const wanted = Math.min(unit.to, Math.max(unit.from, Math.floor(exponent / 3) * 3));
  const [power, prefix] = PREFIXES.find(([power]) => power === wanted) ?? [0, ""];
  return { factor: 10 ** -(power + unit.power), label: `${prefix}${unit.symbol}` };
}

/** A number with some significant digits and no more zeros than it needs. */
export function digits(value, count = 3) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return String(Number(value.toPrecision(count)).toExponential()).replace("e+", "e");
  return String(Number(value.toPrecision(count)));
}

/** An SI value with a prefix, in few digits: `5.01 mm`. */
export function quantity(value, kind, count = 3) {
  const { factor, label } = axisUnit(Math.abs(value), kind);
  const number = digits(value * factor, count);
  return label ? `${number} ${label}` : number;
}

/** A number and what stands behind it; none for other text. */
export function parts(text) {
  const found = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$/.exec(String(text));
  return found ? { number: Number(found[1]), unit: found[2] } : null;
}

/** The text for an SI value, in the unit of the text before where the number stays readable. */
export function inUnitOf(before, beforeSi, value, kind, count = 3) {
  const old = parts(before);
  if (old && old.unit && old.number !== 0 && Number.isFinite(beforeSi) && beforeSi !== 0) {
    const number = value / (beforeSi / old.number);
    const size = Math.abs(number);
    if (value === 0 || (size >= 0.01 && size < 10000)) return `${digits(number, count)} ${old.unit}`;
  }
  return value === 0 && (!UNITS[kind] || kind === "none") ? "0" : quantity(value, kind, count);
}

/** What a file has for a text: a bare number stays one. */
export function written(text) {
  const trimmed = text.trim();
  return /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(trimmed) ? Number(trimmed) : trimmed;
}

/** Round places between two ends, about `count` of them. */
export function ticks(from, to, count) {
  const span = to - from;
  if (!(span > 0) || !Number.isFinite(span)) return [from];
  const rough = span / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].find((one) => one * power >= rough * 0.999) * power;
  const found = [];
  for (let i = Math.ceil(from / step - 1e-9); i <= Math.floor(to / step + 1e-9); i++) found.push(Number((i * step).toPrecision(12)));
  return found;
}

/** Powers of ten between two ends, with their halves where there are few. */
export function logTicks(from, to) {
  const [low, high] = [Math.log10(from), Math.log10(to)];
  const every = Math.max(1, Math.ceil((high - low) / 6));
  const found = [];
  for (let power = Math.ceil(low - 1e-9); power <= Math.floor(high + 1e-9); power++) if (power % every === 0) found.push(10 ** power);
  if (found.length >= 2) return found;
  for (let power = Math.floor(low); power <= Math.ceil(high); power++) {
    for (const one of [1, 2, 5]) found.push(one * 10 ** power);
  }
  return [...new Set(found)].filter((value) => value >= from * 0.999 && value <= to * 1.001).sort((a, b) => a - b);
}

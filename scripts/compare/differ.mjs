// How two outputs differ: in which numbers and by how much, or in text.

const bits = new DataView(new ArrayBuffer(8));

/** Where a number stands among all numbers of 64 bits. */
function place(x) {
  bits.setFloat64(0, x);
  const whole = bits.getBigInt64(0);
  return whole < 0n ? -(whole & 0x7fff_ffff_ffff_ffffn) : whole;
}

/** Units in the last place between two numbers; the two zeros are one apart. */
export function ulps(a, b) {
  if (Object.is(a, b)) return 0;
  if (!Number.isFinite(a) || !Number.isFinite(b)) return Infinity;
  const apart = place(a) - place(b);
  return Math.max(1, Number(apart < 0n ? -apart : apart));
}

const relative = (a, b) => Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b), Number.MIN_VALUE);

/** Every value of a JSON result with the path of its field, in which the places of lists are left out. */
function* leaves(value, path = "", at = "") {
  if (Array.isArray(value)) {
    for (const [i, item] of value.entries()) yield* leaves(item, `${path}[]`, `${at}[${i}]`);
  } else if (value !== null && typeof value === "object") {
    for (const [key, item] of Object.entries(value)) yield* leaves(item, path ? `${path}.${key}` : key, at ? `${at}.${key}` : key);
  } else {
    yield { path, at, value };
  }
}

/** The cells of a CSV: the field is the title of the column. */
function* cells(text) {
  const rows = [...text.matchAll(/((?:"(?:[^"]|"")*"|[^"\n])*)\n/g)].map(([, row]) =>
    [...row.matchAll(/(?:^|,)("(?:[^"]|"")*"|[^,]*)/g)].map(([, cell]) => cell),
  );
  const titles = rows[0] ?? [];
  for (const [line, row] of rows.entries()) {
    for (const [column, cell] of row.entries()) {
      const number = line > 0 && cell !== "" && Number.isFinite(Number(cell));
      yield { path: titles[column] ?? "?", at: `line ${line + 1}, ${titles[column] ?? "?"}`, value: number ? Number(cell) : cell };
    }
  }
}

const NUMBER = /[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;

/** What a reader sees: words in one field, the numbers between them in another. */
function* words(text) {
  for (const [i, line] of text.split("\n").entries()) {
    const at = `line ${i + 1}`;
    yield { path: "text", at, value: line.replaceAll(NUMBER, "#").replaceAll(/ +/g, " ").replaceAll(/-+/g, "-"), line };
    for (const [number] of line.matchAll(NUMBER)) yield { path: "printed numbers", at, value: Number(number), step: lastPlace(number) };
  }
}

/** One unit of the last digit that is printed. */
function lastPlace(number) {
  const [, decimals = "", exponent = "0"] = /^[-+]?\d*\.?(\d*)(?:[eE]([-+]?\d+))?$/.exec(number) ?? [];
  return 10 ** (Number(exponent) - decimals.length);
}

function values(kind, text) {
  if (kind === "json") return [...leaves(JSON.parse(text))];
  return [...(kind === "csv" ? cells(text) : words(text))];
}

/**
 * Fields that differ between two outputs of one kind (json, csv, text):
 * `{path, at, old, now, count, relative, ulps}`, the first place and the largest difference of each.
 * Differences of text have no `ulps`. A number of `allowed` units in the last place is none; printed
 * with few digits, it may then move the last of them.
 */
export function differences(kind, old, now, { allowed = 0, ignore = [] } = {}) {
  if (old === now) return [];
  let pairs;
  try {
    pairs = [values(kind, old), values(kind, now)];
  } catch {
    pairs = [values("text", old), values("text", now)];
  }
  const fields = new Map();
  const note = (path, at, old, now, size) => {
    if (ignore.includes(path)) return;
    const field = fields.get(path) ?? { path, at, old, now, count: 0, relative: 0, ulps: size && 0 };
    field.count += 1;
    if (size) {
      field.ulps = Math.max(field.ulps ?? 0, size);
      field.relative = Math.max(field.relative, relative(old, now));
    } else field.ulps = undefined;
    fields.set(path, field);
  };
  let [a, b] = pairs;
  let same = true;
  if (kind === "json") {
    // A field that came or went does not hide what the others hold.
    const [before, after] = pairs.map((list) => new Set(list.map(({ at }) => at)));
    for (const { path, at, value } of a) if (!after.has(at)) note(path, at, value, "nothing");
    for (const { path, at, value } of b) if (!before.has(at)) note(path, at, "nothing", value);
    same = a.length === b.length && [...before].every((at) => after.has(at));
    const places = new Map(b.map((leaf) => [leaf.at, leaf]));
    a = a.filter(({ at }) => places.has(at));
    b = a.map(({ at }) => places.get(at));
  }
  for (let i = 0; i < Math.max(a.length, b.length); i += 1) {
    const [before, after] = [a[i], b[i]];
    if (!before || !after || before.at !== after.at) {
      note("structure", (before ?? after).at, before?.at ?? "nothing", after?.at ?? "nothing");
      return [...fields.values()];
    }
    if (Object.is(before.value, after.value)) continue;
    same = false;
    if (typeof before.value === "number" && typeof after.value === "number") {
      const size = ulps(before.value, after.value);
      const printed = before.step !== undefined && Math.abs(before.value - after.value) <= 1.01 * Math.max(before.step, after.step);
      if (size > allowed && !(allowed > 0 && printed)) note(before.path, before.at, before.value, after.value, size);
    } else note(before.path, before.at, before.line ?? before.value, after.line ?? after.value);
  }
  if (same && fields.size === 0) note("layout", "", "", "");
  return [...fields.values()];
}

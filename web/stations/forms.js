// How a property is given along the span, changed: one number, a list on the common radii, radii of its
// own. Values stay what they were at every radius, or words say why they cannot.

import { column } from "./columns.js";
import { COMMON, formOf, listed, nothing, ofForm, rowCount, short } from "./span.js";

/** Radii nearer than this share of R are the same, as the solver sees them. */
const SAME = 1e-9;

const numeric = (list) => list.every((value) => typeof value === "number");

/** Radii and values of a property that is a list or has radii of its own. */
export function curveOf(doc, id) {
  const form = formOf(doc, id);
  const r = (form === "own" ? doc.distribution[id].r : doc.distribution.r) ?? [];
  const values = (form === "own" ? doc.distribution[id].values : doc.distribution[id]) ?? [];
  return { r, values };
}

const ordered = ({ r, values }) =>
  r.length > 0 && r.length === values.length && numeric(r) && numeric(values) && r.every((x, i) => i === 0 || r[i - 1] <= x);

/** Where a property ends, in words. */
const reach = ({ r }) => `from ${r[0]} to ${r.at(-1)}`;

/** All radii of two sorted lists; one that stands twice in either stands twice. */
function union(a, b, near) {
  const out = [];
  const same = (x, y) => Math.abs(x - y) <= near;
  let [i, k] = [0, 0];
  while (i < a.length || k < b.length) {
    const x = Math.min(a[i] ?? Infinity, b[k] ?? Infinity);
    let [ofA, ofB] = [0, 0];
    const own = i < a.length && same(a[i], x) ? a[i] : x;
    while (i < a.length && same(a[i], own)) [i, ofA] = [i + 1, ofA + 1];
    while (k < b.length && same(b[k], own)) [k, ofB] = [k + 1, ofB + 1];
    out.push(...Array(Math.max(ofA, ofB)).fill(own));
  }
  return out;
}

/** Values of a curve on other radii that lie within its own; steps stay steps. */
function resampled({ r, values }, onto, near) {
  return onto.map((x, i) => {
    const outboard = i > 0 && onto[i - 1] === x;
    const here = r
      .map((own, k) => [own, k])
      .filter(([own]) => Math.abs(own - x) <= near)
      .map(([, k]) => k);
    if (here.length > 0) return values[outboard ? here.at(-1) : here[0]];
    const k = r.findIndex((own) => own > x);
    return short(values[k - 1] + ((values[k] - values[k - 1]) * (x - r[k - 1])) / (r[k] - r[k - 1]));
  });
}

function toList(doc, id) {
  const table = doc.distribution;
  const { radius } = doc.rotor ?? {};
  const near = SAME * (typeof radius === "number" ? Math.abs(radius) : 0);
  if (formOf(doc, id) !== "own") {
    if (rowCount(doc, COMMON) === 0) table.r = [0, radius ?? ""];
    listed(doc, id, rowCount(doc, COMMON));
    return null;
  }
  const own = curveOf(doc, id);
  const others = ofForm(doc, "list");
  if (others.length === 0) {
    table.r = own.r;
    table[id] = own.values;
    return null;
  }
  const faulty = [id, ...others].find((one) => !ordered(curveOf(doc, one)));
  if (faulty) return `The ${column(faulty).name} has faults; they go first.`;
  const { r } = table;
  if (Math.abs(own.r[0] - r[0]) > near || Math.abs(own.r.at(-1) - r.at(-1)) > near) {
    return `The ${column(id).name} is given ${reach(own)}, the common radii go ${reach({ r })}. Give both the same ends first; nothing is extended.`;
  }
  const onto = union(r, own.r, near);
  const curves = [...others, id].map((one) => [one, resampled(curveOf(doc, one), onto, near)]);
  table.r = onto;
  for (const [one, values] of curves) table[one] = values;
  return null;
}

function toNumber(doc, id) {
  if (formOf(doc, id) === "absent") {
    if (column(id).optional) doc.distribution[id] = 0;
    return null;
  }
  const { values } = curveOf(doc, id);
  if (!numeric(values) || values.length === 0) return `The ${column(id).name} has values that are no numbers.`;
  if (values.some((value) => value !== values[0])) {
    const [least, most] = values.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity]);
    return `The ${column(id).name} is not the same at all radii: it goes from ${least} to ${most}.`;
  }
  doc.distribution[id] = values[0];
  return null;
}

function toOwn(doc, id) {
  const table = doc.distribution;
  const common = table.r ?? [];
  if (formOf(doc, id) === "list") {
    table[id] = { r: [...common], values: table[id] };
    return null;
  }
  const value = formOf(doc, id) === "number" ? table[id] : nothing(id);
  const ends = common.length > 1 ? [common[0], common.at(-1)] : [0, doc.rotor?.radius ?? ""];
  table[id] = { r: ends, values: [value, value] };
  return null;
}

/** Gives a property another form. Gives words where that would change it. */
export function convert(doc, id, form) {
  doc.distribution ??= {};
  if (formOf(doc, id) === form) return null;
  if (form === "absent") {
    delete doc.distribution[id];
    return null;
  }
  return { list: toList, number: toNumber, own: toOwn }[form](doc, id);
}

// Blocks from spreadsheets, names of columns, and changes of the stations, without a browser.

import assert from "node:assert/strict";
import { test } from "node:test";
import { createDocument, setAt } from "../../web/blade/document.js";
import { isBladeShaped } from "../../web/blade/shape.js";
import { columnOf, isUnit } from "../../web/stations/columns.js";
import { convert } from "../../web/stations/forms.js";
import { MOST_ROWS, blockWords, readBlock, writeBlock } from "../../web/stations/paste/block.js";
import { headerNotes, mapped } from "../../web/stations/paste/panel.js";
import { profilePoints, profileWords } from "../../web/stations/profiles.js";
import {
  addRow,
  addStep,
  cellOf,
  columnsOf,
  deleteRows,
  formOf,
  moveRows,
  placeOf,
  putBlock,
  readOnly,
  replaceAll,
  setCell,
  stepAt,
} from "../../web/stations/span.js";

const rows = (text) => {
  const block = readBlock(text);
  assert.equal(block.refused, undefined);
  return block.rows;
};
const refused = (text, words) => assert.match(readBlock(text).refused ?? "", words, JSON.stringify(text.slice(0, 60)));

test("tabs, semicolons and commas part columns; quotes and line ends of all kinds", () => {
  const want = [
    [0, 1.5, -2],
    [1, 2e3, 0.5],
  ];
  for (const text of [
    "0\t1.5\t-2\n1\t2e3\t.5",
    "0\t1.5\t−2\r\n1\t2E+3\t0.5\r\n",
    "0;1,5;-2\n1;2e3;0,5\n\n",
    "0,1.5,-2\r1,2000,0.5",
    '"0","1.5","-2"\n"1","2e3","0.5"',
    "\ufeff0; 1.5 ;-2;;\n1;2e3;.5;;\n;;;;\n",
  ]) {
    assert.deepEqual(rows(text), want, JSON.stringify(text));
  }
});

test("decimal commas are read between tabs and semicolons, and it is said", () => {
  const block = readBlock("0,5\t1,25\n10,4\t2\n");
  assert.deepEqual(block.rows, [
    [0.5, 1.25],
    [10.4, 2],
  ]);
  assert.equal(blockWords(block), "2 rows × 2 columns; decimal commas read as points");
  assert.equal(blockWords(readBlock("1\t2")), "1 row × 2 columns");
});

test("what can be read in two ways is refused, not guessed", () => {
  for (const text of ["1.234,5\t2", "1,234.5\t2", "1 234\t2", "1 234,5;2", "1'234.5\t2", "1,234,567\t2", "1.234.567\t2", '"1,234,567",2'])
    refused(text, /thousands separator/);
  refused("1,234\t2\n5,678\t3", /may be 1\.234 or 1234/);
  refused("1,5\t2.5", /commas and points/);
  refused('"1,5",2', /comma inside a number/);
  refused("0,5\n10,4", /one number or two/);
  refused("0.1  2.5 3\n0.2  2.6 4", /tabs, semicolons or commas/);
  refused('0\t"1', /quote is opened/);
  refused("", /nothing to paste/);
  refused(" \n\t\n", /nothing to paste/);
  refused(",".repeat(1e6), /nothing|more than/);
});

test("a decimal comma that settles it settles all", () => assert.deepEqual(rows("1,234\t0,5"), [[1.234, 0.5]]));

test("empty cells stay empty, and what is no number stays its text", () => {
  assert.deepEqual(rows("1\t\t3\n4\t5"), [
    [1, "", 3],
    [4, 5, ""],
  ]);
  assert.deepEqual(rows("1\t<script>alert(1)</script>\n\n2\t#DIV/0!"), [
    [1, "<script>alert(1)</script>"],
    ["", ""],
    [2, "#DIV/0!"],
  ]);
  assert.deepEqual(rows("1\t1e999\tNaN\tInfinity"), [[1, "1e999", "NaN", "Infinity"]]);
  assert.ok(rows(`1\t${"x".repeat(1e6)}`)[0][1].length < 300);
  assert.deepEqual(rows('1\t"a ""b""\nc"'), [[1, 'a "b" c']]);
});

test("more rows than the limit are refused with both numbers, at once", () => {
  const text = "1\t2\t3\n".repeat(100_000);
  refused(text, new RegExp(`^100000 rows.*at most ${MOST_ROWS}`));
  refused("1\n".repeat(MOST_ROWS + 1), new RegExp(`^${MOST_ROWS + 1} rows`));
  assert.equal(rows("1\n".repeat(MOST_ROWS)).length, MOST_ROWS);
  assert.equal(rows(`r\n${"1\n".repeat(MOST_ROWS)}`).length, MOST_ROWS);
});

test("columns are known by the names of the field", () => {
  const names = {
    r: ["r", "R [mm]", "Radius", "radius (in)", "Radial station", "x"],
    mass: ["m", "mass", "Mass per length [kg/m]", "mass/length", "running mass", "μ (kg/m)"],
    flap_stiffness: ["EI flap", "EI_flap [Nm²]", "flap stiffness", "Flapwise bending stiffness", "flatwise EI", "EI_beam", "EI (flap) [Nm²]"],
    lag_stiffness: ["EI lag", "lead-lag stiffness", "EI chord", "edgewise stiffness [N m^2]", "chordwise"],
    torsion_stiffness: ["GJ", "GJ [lbf in2]", "torsional stiffness", "torsion"],
    polar_inertia: ["polar inertia", "I_theta", "Polar mass moment of inertia [kg m]", "torsional inertia"],
    mass_offset: ["mass offset", "cg offset", "x_cg", "e"],
    twist: ["twist", "Twist [deg]", "theta"],
  };
  for (const [id, all] of Object.entries(names)) for (const name of all) assert.equal(columnOf(name), id, name);
  for (const name of ["station", "no.", "foo", "", "flap inertia of the hub area", "toString", "__proto__"])
    assert.ok([null, "polar_inertia"].includes(columnOf(name)), name);
});

test("a row of names is taken off, with units beside or below them", () => {
  const block = readBlock("Radius [mm]\tEI flap (N m²)\tcolour\n1\t2\t3\n");
  assert.deepEqual(block.rows, [[1, 2, 3]]);
  assert.deepEqual(
    block.header.map(({ id, unit }) => [id, unit]),
    [
      ["r", "mm"],
      ["flap_stiffness", "N m²"],
      [null, null],
    ],
  );
  const below = readBlock("r;m;GJ\n[mm];[kg/m];\n1;2;3\n");
  assert.deepEqual([below.rows, below.header.map(({ unit }) => unit)], [[[1, 2, 3]], ["mm", "kg/m", null]]);
  const to = mapped(block.header, ["r", "flap_stiffness"]).to;
  assert.deepEqual(to, ["r", "flap_stiffness", null]);
  assert.deepEqual(headerNotes(block.header, to, {}), ["left out: “colour”", "units are not converted: r is headed [mm], taken as m"]);
  assert.match(mapped(readBlock("r\tmass\tm\n1\t2\t3").header, ["r", "mass"]).words, /Two columns/);
  refused("r/R\tmass\n0\t1", /ratio/);
  refused("r\tmass\n", /no rows/);
});

test("units are the same however they are spelt", () => {
  for (const text of ["Nm²", "N m^2", "N·m2", "N*m**2", "m^2 N"]) assert.ok(isUnit(text, "flap_stiffness", {}), text);
  for (const text of ["lb-in", "lb·in", "lb in^2/in"]) assert.ok(isUnit(text, "polar_inertia", { length: "in", mass: "lb", force: "lbf" }), text);
  assert.ok(isUnit("°", "twist", { angle: "deg" }));
  for (const [text, id] of [
    ["mm", "r"],
    ["kNm²", "flap_stiffness"],
    ["g/m", "mass"],
    ["deg", "twist"],
  ])
    assert.equal(isUnit(text, id, {}), false, text);
});

test("copied cells come back with every digit", () => {
  const block = [
    [0.1 + 0.2, 1e-7, -5],
    ["", "a\tb", 'q"'],
  ];
  assert.deepEqual(readBlock(writeBlock(block)).rows.flat().slice(0, 4), [0.30000000000000004, 1e-7, -5, ""]);
  assert.equal(writeBlock(block), '0.30000000000000004\t1e-7\t-5\n\t"a\tb"\t"q"""');
});

const blade = () => ({
  rotor: { radius: 10 },
  distribution: {
    r: [0, 4, 4, 10],
    mass: [1, 2, 3, 4],
    flap_stiffness: 5,
    lag_stiffness: { r: [0, 2, 10], values: [8, 6, 2] },
    torsion_stiffness: [7, 7, 7, 7],
    polar_inertia: 1,
  },
});

test("a property takes another form with its values, or says why not", () => {
  const doc = blade();
  assert.equal(convert(doc, "lag_stiffness", "list"), null);
  assert.deepEqual(doc.distribution.r, [0, 2, 4, 4, 10]);
  assert.deepEqual(doc.distribution.mass, [1, 1.5, 2, 3, 4]);
  assert.deepEqual(doc.distribution.lag_stiffness, [8, 6, 5, 5, 2]);
  assert.match(convert(doc, "mass", "number"), /not the same at all radii: it goes from 1 to 4/);
  assert.equal(convert(doc, "torsion_stiffness", "number"), null);
  assert.equal(doc.distribution.torsion_stiffness, 7);
  assert.equal(convert(doc, "mass", "own"), null);
  assert.deepEqual(doc.distribution.mass, { r: [0, 2, 4, 4, 10], values: [1, 1.5, 2, 3, 4] });
  assert.equal(convert(doc, "flap_stiffness", "list"), null);
  assert.deepEqual(doc.distribution.flap_stiffness, [5, 5, 5, 5, 5]);
  assert.equal(convert(doc, "twist", "own"), null);
  assert.deepEqual(doc.distribution.twist, { r: [0, 10], values: [0, 0] });
  assert.equal(convert(doc, "twist", "absent"), null);
  assert.equal(formOf(doc, "twist"), "absent");
  const short = blade();
  short.distribution.lag_stiffness.r[0] = 1;
  assert.match(convert(short, "lag_stiffness", "list"), /from 1 to 10, the common radii go from 0 to 10/);
  short.distribution.mass[1] = "x";
  assert.match(convert(short, "lag_stiffness", "list"), /has faults/);
});

test("what only coupled motion needs has a column where it is given, and goes with its rows", () => {
  const doc = blade();
  assert.deepEqual(columnsOf(doc, "").slice(-2), ["mass_offset", "twist"]);
  Object.assign(doc.distribution, { lag_inertia: [1, 2, 3, 4], axial_stiffness: { r: [0, 10], values: [5, 5] } });
  assert.deepEqual(columnsOf(doc, "").slice(-3), ["twist", "lag_inertia", "axial_stiffness"]);
  addRow(doc, "", 1);
  assert.deepEqual(doc.distribution.lag_inertia, [1, 1.5, 2, 3, 4]);
  deleteRows(doc, "", 2, 4);
  assert.deepEqual(doc.distribution.lag_inertia, [1, 1.5]);
  assert.deepEqual(placeOf(doc, "distribution.axial_stiffness.values[1]"), { sheet: "axial_stiffness", row: 1, id: "axial_stiffness" });
});

test("an edit keeps what the form has no field for", () => {
  const state = { doc: null };
  const store = { get: () => state, set: (more) => Object.assign(state, more) };
  const document = createDocument(store);
  const own = { rotor: { radius: 10, pitch: 8, spring_angle: "pitch" }, point_mass: [{ r: 9, mass: 0.4, offset: 0.1 }] };
  document.open({ ...blade(), ...structuredClone(own) }, { choice: "" });
  document.edit((doc) => setAt(doc, "rotor.radius", 12));
  document.edit((doc) => setCell(doc, "", 0, "mass", 7));
  assert.deepEqual(state.doc.rotor, { ...own.rotor, radius: 12 });
  assert.deepEqual(state.doc.point_mass, own.point_mass);
  assert.equal(isBladeShaped(state.doc), true);
});

test("rows are added, repeated, moved and taken out in all lists together", () => {
  const doc = blade();
  addRow(doc, "", 1);
  assert.deepEqual(
    [doc.distribution.r, doc.distribution.mass],
    [
      [0, 2, 4, 4, 10],
      [1, 1.5, 2, 3, 4],
    ],
  );
  addRow(doc, "", 5);
  assert.equal(cellOf(doc, "", 5, "mass"), "");
  deleteRows(doc, "", 5, 5);
  deleteRows(doc, "", 1, 1);
  assert.deepEqual(doc, blade());
  assert.match(addStep(doc, "", 1), /twice already/);
  assert.equal(addStep(doc, "", 0), null);
  assert.deepEqual(doc.distribution.r, [0, 0, 4, 4, 10]);
  assert.deepEqual([stepAt(doc, "", 0), stepAt(doc, "", 1), stepAt(doc, "", 4)], ["inboard", "outboard", null]);
  assert.equal(moveRows(doc, "", 3, 4, -1), true);
  assert.deepEqual(doc.distribution.mass, [1, 1, 3, 4, 2]);
  assert.equal(moveRows(doc, "", 2, 3, 1), true);
  assert.deepEqual(doc.distribution.mass, [1, 1, 2, 3, 4]);
  assert.equal(moveRows(doc, "", 0, 1, -1), false);
});

test("a block grows the table; a single number becomes a list where it must", () => {
  const doc = blade();
  assert.match(putBlock(doc, "", 0, ["r", "mass", "flap_stiffness", "lag_stiffness"], [[0, 1, 2, 3]], 99), /radii of its own/);
  assert.equal(
    putBlock(
      doc,
      "",
      3,
      ["r", "mass", "flap_stiffness"],
      [
        [8, 4, 5],
        [10, 5, 6],
      ],
      99,
    ),
    null,
  );
  assert.deepEqual(doc.distribution.r, [0, 4, 4, 8, 10]);
  assert.deepEqual(doc.distribution.flap_stiffness, [5, 5, 5, 5, 6]);
  assert.deepEqual(doc.distribution.torsion_stiffness, [7, 7, 7, 7, ""]);
  assert.match(putBlock(doc, "", 3, ["r"], [[1], [2]], 4), /5 rows; at most 4/);
  const kept = replaceAll(
    doc,
    ["r", "mass"],
    [
      [0, 1],
      [10, 2],
    ],
  );
  assert.deepEqual(kept, ["flap_stiffness", "torsion_stiffness"]);
  assert.deepEqual(doc.distribution.flap_stiffness, { r: [0, 4, 4, 8, 10], values: [5, 5, 5, 5, 6] });
});

test("paths of faults lead to cells", () => {
  const doc = blade();
  for (const [sheet, row, id, path] of [
    ["", 3, "mass", "distribution.mass[3]"],
    ["", 1, "r", "distribution.r[1]"],
    ["lag_stiffness", 1, "lag_stiffness", "distribution.lag_stiffness.values[1]"],
    ["lag_stiffness", 2, "r", "distribution.lag_stiffness.r[2]"],
    ["", -1, "flap_stiffness", "distribution.flap_stiffness"],
  ]) {
    assert.deepEqual(placeOf(doc, path), { sheet, row, id });
  }
  assert.deepEqual(placeOf(doc, "distribution.mass"), { sheet: "", row: -1, id: "mass" });
  assert.deepEqual(placeOf(doc, "distribution.mass.values[2]"), { sheet: "", row: -1, id: "mass" }, "of a what-if blade");
  for (const path of ["rotor.radius", "distribution.foo", "distribution"]) assert.equal(placeOf(doc, path), null);
  assert.equal(setCell(doc, "", -1, "flap_stiffness", 9), null);
  assert.match(readOnly(doc, "", -1, "mass"), /rows below/);
  setCell(doc, "", 0, "twist", 2);
  assert.deepEqual(doc.distribution.twist, [2, 0, 0, 0]);
});

test("plots say in words what they show", () => {
  const doc = blade();
  assert.equal(profileWords(profilePoints(doc, "mass"), "list", "kg/m", "m"), "from 1 kg/m at r = 0 m to 4 at 10, between 1 and 4; a step at r = 4");
  assert.equal(profileWords(profilePoints(doc, "flap_stiffness"), "number", "N·m²", "m"), "5 N·m² at all radii");
  doc.distribution.mass[2] = "x";
  assert.equal(profilePoints(doc, "mass"), null);
});

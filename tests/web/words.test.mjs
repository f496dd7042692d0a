// Numbers, words, places and files as the page writes them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { pack, unpack } from "../../web/app/pack.js";
import { STATE, createStore } from "../../web/app/state.js";
import { textOffset } from "../../web/blade/text.js";
import { faultPlace } from "../../web/lib/faults.js";
import { boundsWords, closestOf, crossingWords, crossingsWithin, fieldNumber, figures, marginWords, percentWords } from "../../web/lib/format.js";
import { closestWords } from "../../web/modes/table.js";
import { readBlock, writeBlock } from "../../web/stations/paste/block.js";
import { convergeCsv, csv, fanCsv, fileName } from "../../web/out/download.js";

test("numbers have four significant figures and a real minus sign", () => {
  const cases = [
    [72.304, "72.30"],
    [185.94, "185.9"],
    [12345.6, "12350"],
    [0.00123456, "0.001235"],
    [-1.5, "−1.500"],
    [0, "0"],
  ];
  for (const [value, text] of cases) assert.equal(figures(value), text);
});

test("input fields get plain numbers", () => {
  assert.equal(fieldNumber(660.0000000001), "660");
  assert.equal(fieldNumber(69.11503837897544), "69.115");
});

test("margins are said in words", () => {
  const margin = (nearest_harmonic, margin_per_rev) => ({ nearest_harmonic, margin_per_rev });
  assert.equal(marginWords(margin(3, -0.312)), "0.31 below 3P");
  assert.equal(marginWords(margin(1, 0.046), "/rev"), "0.05/rev above 1P");
  assert.equal(marginWords(margin(1, 0.0042)), "0.0042 above 1P");
  assert.equal(marginWords(margin(1, 1e-12)), "on 1P");
  assert.equal(marginWords(margin(null, null)), "–");
});

test("the closest mode is sought among the harmonics looked at", () => {
  const margins = [
    { label: "1F", nearest_harmonic: 1, margin_per_rev: 0.046 },
    { label: "5L", nearest_harmonic: 30, margin_per_rev: 0.001 },
  ];
  assert.equal(closestWords(margins, "660 rpm", 10), "1F is 0.05/rev above 1P at 660 rpm, the closest up to 10P.");
  assert.equal(closestWords(margins.slice(1), "660 rpm", 10), "");
  assert.equal(closestWords([], "0 rpm", 10), "");
});

test("a place counts characters, not UTF-16 units", () => {
  const text = "a\n𝛀 = 1\nx";
  assert.equal(text.slice(textOffset(text, 2, 3)), "= 1\nx");
  assert.equal(text.slice(textOffset(text, 3, 1)), "x");
  assert.equal(textOffset(text, 2, 99), text.indexOf("\nx"));
  assert.equal(textOffset(text, 99, 1) <= text.length, true);
});

test("a fault's place is said as far as it is known", () => {
  assert.equal(faultPlace({ line: 12, path: "rotor.radius" }), "line 12: rotor.radius");
  assert.equal(faultPlace({ line: null, path: "functions" }), "functions");
  assert.equal(faultPlace({ line: null, path: "" }), "");
});

test("CSV quotes what needs it and keeps every digit", () => {
  assert.equal(
    csv(
      ["a", 'b "c", d'],
      [
        [0.1 + 0.2, null],
        [5, "x"],
      ],
    ),
    'a,"b ""c"", d"\n0.30000000000000004,\n5,x\n',
  );
});

test("a word in CSV or on the clipboard is no formula, and a number stays one", () => {
  const hostile = ["=cmd|' /C calc'!A0", "+1+1", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "＝1+1"];
  for (const word of hostile) {
    assert.match(csv([word], []), /^"?'/, word);
    assert.match(csv(["r"], [[word]]), /\n"?'/, word);
    assert.match(writeBlock([[1, word]]), /^1\t"?'/, word);
  }
  assert.equal(csv(["r"], [[-1.5e-7, "1F", null]]), "r\n-1.5e-7,1F,\n");
  assert.equal(writeBlock([[-1.5, "", undefined]]), "-1.5\t\t");
  // What the sheet copies it reads back as it was.
  const rows = [[-1, "=1+1", "'quoted", "-x"]];
  assert.deepEqual(readBlock(writeBlock(rows)).rows, rows);
});

test("crossings, bounds and differences are said in one way", () => {
  const fan = {
    nominal: { speed_rad_s: 10 },
    crossings: [
      { label: "2F", harmonic: 3, speed_rad_s: 10.5 },
      { label: "1F", harmonic: 1, speed_rad_s: 9 },
      { label: "1L", harmonic: 9, speed_rad_s: 12 },
    ],
  };
  assert.deepEqual(crossingsWithin(fan, [0.9, 1.1]).map(crossingWords), ["1F × 1P", "2F × 3P"]);
  assert.deepEqual([null, 0, 5e-5, 0.0981, -1.26, 12.34, -250].map(percentWords), ["–", "0 %", "<0.0001 %", "+0.098 %", "−1.3 %", "+12 %", "−250 %"]);
  assert.equal(boundsWords({ frequency_rad_s: 10, lower_rad_s: 10 - 1e-9, upper_rad_s: 10 }, " rad/s"), "±2·10⁻⁹ rad/s");
  assert.equal(boundsWords({ frequency_rad_s: 10, lower_rad_s: null, upper_rad_s: null }, " rad/s"), "–");
  assert.equal(closestOf([{ nearest_harmonic: null, margin_per_rev: null }]), null);
});

test("CSV of a fan chart and of a convergence study", () => {
  const fan = {
    speeds_rad_s: [0, 1.5],
    branches: [
      { label: "1F", frequency_rad_s: [0, 1.6] },
      { label: "1T", frequency_rad_s: [7, 7.25] },
    ],
  };
  assert.equal(fanCsv(fan), "rotor speed [rad/s],1F [rad/s],1T [rad/s]\n0,0,7\n1.5,1.6,7.25\n");
  const converge = {
    functions: [1, 2],
    series: [{ label: "2F", classical_rad_s: [null, 3.5], piecewise_functions: [6], piecewise_rad_s: [2.8], converged_rad_s: 2.8 }],
  };
  assert.equal(
    convergeCsv(converge),
    "mode,family,functions,frequency [rad/s],error [%]\n2F,classical,1,,\n2F,classical,2,3.5,25\n2F,piecewise,6,2.8,0\n",
  );
});

test("file names hold nothing that a file system could mind", () => {
  assert.equal(fileName("TM 4760 research blade", "fan", "svg"), "tm-4760-research-blade-fan.svg");
  assert.equal(fileName("../../etc/<script>", "fan", "csv"), "etc-script-fan.csv");
  assert.equal(fileName("旋翼", "", "toml"), "blade.toml");
});

test("the state tells what really changed", () => {
  const store = createStore({ a: 1, b: 2 });
  const heard = [];
  store.subscribe((_, changed) => heard.push([...changed]));
  store.set({ a: 1 });
  store.set({ a: 2, b: 2 });
  assert.deepEqual(heard, [["a"]]);
});

test("what the state hands out is frozen, and a key that it does not declare is refused", () => {
  const store = createStore({ doc: { rotor: { radius: 2 } }, list: [], bytes: null });
  const before = store.get();
  assert.throws(() => (before.doc.rotor.radius = 3), TypeError);
  assert.throws(() => (before.doc = null), TypeError);
  assert.throws(() => before.list.push(1), TypeError);
  const given = { rotor: { radius: 3 }, stations: [{ r: 0 }, [1, 2]] };
  store.set({ doc: given, bytes: new Float64Array(2) });
  assert.throws(() => (given.rotor.radius = 4), TypeError, "what was given, too");
  assert.throws(() => (store.get().doc.stations[0].r = 1), TypeError);
  assert.throws(() => store.get().doc.stations[1].sort(), TypeError);
  assert.equal(before.doc.rotor.radius, 2, "what was handed out stays");
  assert.throws(() => store.set({ doc: null, documnet: 1 }), /no key “documnet”/);
  assert.equal(store.get().doc, given, "then nothing is set");
});

test("a listener that sets more is followed by listeners of the newest state", () => {
  const store = createStore({ tab: "fan", width: 0 });
  const heard = [];
  store.subscribe((_, changed) => changed.has("tab") && store.set({ width: 5 }));
  store.subscribe(({ tab, width }, changed) => heard.push([tab, width, ...changed]));
  store.set({ tab: "text" });
  assert.deepEqual(heard, [
    ["text", 5, "width"],
    ["text", 5, "tab"],
  ]);
});

test("each key of the state that a view is made of is declared", async () => {
  const { view } = await unpack(await pack({ ...STATE, doc: {} }));
  const declared = Object.keys(STATE);
  assert.ok(Object.keys(view).length > 10);
  assert.deepEqual(
    Object.keys(view).filter((key) => !declared.includes(key)),
    [],
  );
  assert.deepEqual(
    Object.entries(view).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(STATE[key])),
    [],
  );
});

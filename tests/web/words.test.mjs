// Numbers, words, places and files as the page writes them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { convergeCsv, csv, fanCsv, fileName } from "../../web/download.js";
import { faultPlace, fieldNumber, figures, marginWords, textOffset } from "../../web/format.js";
import { createStore } from "../../web/state.js";
import { closestWords } from "../../web/table.js";

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
  assert.equal(csv(["a", 'b "c", d'], [[0.1 + 0.2, null], [5, "x"]]), 'a,"b ""c"", d"\n0.30000000000000004,\n5,x\n');
});

test("CSV of a fan chart and of a convergence study", () => {
  const fan = { speeds_rad_s: [0, 1.5], branches: [{ label: "1F", frequency_rad_s: [0, 1.6] }, { label: "1T", frequency_rad_s: [7, 7.25] }] };
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

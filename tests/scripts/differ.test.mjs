// What scripts/compare-builds calls a difference.

import assert from "node:assert/strict";
import { test } from "node:test";
import { differences, ulps } from "../../scripts/compare/differ.mjs";

const next = 1 + Number.EPSILON;

test("units in the last place", () => {
  assert.equal(ulps(1, next), 1);
  assert.equal(ulps(next, 1), 1);
  assert.equal(ulps(0.5, 0.5), 0);
  assert.equal(ulps(0, -0), 1);
  assert.equal(ulps(-Number.MIN_VALUE, Number.MIN_VALUE), 2);
  assert.equal(ulps(1, NaN), Infinity);
});

test("JSON is compared field by field", () => {
  const json = (a, b, label = "1F") =>
    JSON.stringify({
      modes: [
        { label, f: a },
        { label: "2F", f: b },
      ],
      basis: { n: 1 },
    });
  assert.deepEqual(differences("json", json(1, 2), json(1, 2)), []);
  const [field, ...others] = differences("json", json(1, 2), json(next, 2));
  assert.deepEqual(others, []);
  assert.deepEqual({ ...field, relative: 0 }, { path: "modes[].f", at: "modes[0].f", old: 1, now: next, count: 1, relative: 0, ulps: 1 });
  assert.deepEqual(differences("json", json(1, 2), json(next, 2), { allowed: 1 }), []);
  assert.equal(differences("json", json(1, 2), json(1.1, 2), { allowed: 1 }).length, 1);
  assert.deepEqual(differences("json", json(1, 2), json(1.1, 2), { ignore: ["modes[].f"] }), []);
  const [label] = differences("json", json(1, 2), json(1, 2, "1L"), { allowed: 9 });
  assert.deepEqual([label.path, label.old, label.now, label.ulps], ["modes[].label", "1F", "1L", undefined]);
  // A number that became null, a field that is new, white space.
  assert.equal(differences("json", json(1, 2), json(1, null), { allowed: 9 })[0].ulps, undefined);
  const [added, moved] = differences("json", '{"a":1,"c":[1]}', '{"a":1,"b":2,"c":[2]}', { allowed: 9 });
  assert.deepEqual([added.path, added.old, added.now, moved.path, moved.old, moved.now], ["b", "nothing", 2, "c[]", 1, 2]);
  assert.equal(differences("json", '{"a":1,"b":2}', '{"b":2,"a":1}')[0].path, "layout");
  assert.equal(differences("json", '{"a":1}', '{"a": 1}')[0].path, "layout");
});

test("CSV is compared by columns", () => {
  const csv = (a, name = "x, y") => `label,f [rad/s],name\n1F,${a},"${name}"\n`;
  assert.deepEqual(differences("csv", csv(1), csv(1)), []);
  const [field] = differences("csv", csv(1), csv(2));
  assert.deepEqual([field.path, field.at, field.relative], ["f [rad/s]", "line 2, f [rad/s]", 0.5]);
  assert.equal(differences("csv", csv(1), csv(1, "x, z"))[0].path, "name");
  assert.equal(differences("csv", csv(1), `${csv(1)}2F,1,a\n`)[0].path, "structure");
});

test("numbers in text and the words between them", () => {
  const [field, ...others] = differences("text", '<line x1="10.25"/>\n', '<line x1="10.26"/>\n');
  assert.deepEqual([field.path, field.old, field.now, others.length], ["printed numbers", 10.25, 10.26, 0]);
  // The last printed digit may move where a number may.
  assert.deepEqual(differences("text", "f 10.25", "f 10.26", { allowed: 4 }), []);
  assert.equal(differences("text", "f 10.25", "f 10.27", { allowed: 4 }).length, 1);
  const [words] = differences("text", "f 10.25 Hz", "f 10.25 rpm", { allowed: 4 });
  assert.deepEqual([words.path, words.ulps], ["text", undefined]);
  assert.equal(differences("text", "one\ntwo", "one", { allowed: 4 })[0].path, "structure");
  assert.equal(differences("json", "not JSON", "not json")[0].path, "text");
});

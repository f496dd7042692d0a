// Native and wasm results are the same to the last bit, for every built-in blade.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { blades, json, pkg, run, same, value } from "./both.mjs";

const folder = mkdtempSync(join(tmpdir(), "bladefan-parity-"));
after(() => rmSync(folder, { recursive: true }));

/** Both results of a command; option names as the package has them. */
function both(command, { name, blade }, options) {
  const args = Object.entries(options).flatMap(([option, value]) => [`--${option.replace("_", "-")}`, String(value)]);
  return [json(command, name, ...args), value(pkg[command](blade, options))];
}

/** Compares a command's results and wants at least so many numbers in them. */
function compare(command, blade, options, least) {
  const count = same(...both(command, blade, options));
  assert.ok(count >= least, `only ${count} numbers were compared`);
}

const uncoupled = { model: "uncoupled" };

test("drawings have the same looks", () => {
  const file = join(folder, "looks.svg");
  const looks = [
    ["fan", { frequency_unit: "per-rev", width: 600 }],
    ["fan", { frequency_unit: "rpm", frequencies: "500:4000", height: 700 }],
    ["fan", { frequency_unit: "per-rev", frequencies: "2:6.5", speeds: "300rpm:500rpm:7", theme: "dark" }],
    ["shapes", { width: 700, height: 700 }],
    ["converge", { width: 390, frequency_unit: "per-rev" }],
    ["converge", { width: 600, height: 900, speed: 0, frequency_unit: "per-rev" }],
  ];
  for (const [kind, options] of looks) {
    for (const { name, blade } of blades) {
      const args = Object.entries(options).flatMap(([option, value]) => [`--${option.replace("_", "-")}`, String(value)]);
      const { status, stderr } = run(kind, name, "--svg", file, ...args);
      assert.equal(status, 0, stderr);
      const { svg } = value(pkg.chart_svg(kind, blade, options));
      assert.ok(svg === readFileSync(file, "utf8"), `${kind} of ${name} with ${args}: the two SVG texts differ`);
    }
  }
});

test("both have the same built-in blades", () => {
  const listed = json("blades").blades.map((blade) => blade.name);
  assert.deepEqual(
    blades.map((blade) => blade.name),
    listed,
  );
  assert.ok(listed.length >= 5, `${listed}`);
  for (const { name, toml, blade } of blades) {
    assert.equal(run("blades", name).stdout, toml);
    same(json("blades", name), blade);
  }
});

for (const entry of blades) {
  const { name, blade } = entry;
  const nominal = value(pkg.check(blade)).nominal_speed_rad_s;
  test(`${name}: check`, () => {
    same(json("check", name), value(pkg.check(blade)));
  });
  for (const ratio of [0, 1, 1.2]) {
    test(`${name}: modes at ${ratio} of nominal speed`, () => compare("modes", entry, { ...uncoupled, speed: ratio * nominal }, 15 * 5));
  }
  test(`${name}: modes with 60 functions`, () => compare("modes", entry, { ...uncoupled, functions: 60, modes: 10 }, 30 * 5));
  test(`${name}: fan`, () => compare("fan", entry, uncoupled, 101 * 16));
  test(`${name}: fan of other speeds`, () =>
    compare("fan", entry, { ...uncoupled, speeds: `0:${2 * nominal}:37`, harmonics: 20, dof: "lag,flap" }, 37 * 11));
  test(`${name}: shapes`, () => compare("shapes", entry, uncoupled, 101 * 3 * 15));
  test(`${name}: shapes by mass`, () => compare("shapes", entry, { ...uncoupled, normalise: "mass", points: 11, speed: 0 }, 11 * 3 * 15));
  test(`${name}: converge`, () => compare("converge", entry, uncoupled, 16 * 8));
  // More modes than the 15 functions of the other commands: here the number of functions varies.
  test(`${name}: converge with 16 modes`, () => compare("converge", entry, { ...uncoupled, modes: 16 }, 16 * 8));
  test(`${name}: coupled modes`, () => compare("modes", entry, { model: "coupled", pitch: "8deg" }, 12 * 10));
  test(`${name}: coupled fan`, () => compare("fan", entry, { model: "coupled", speeds: `0:${1.2 * nominal}:11`, precone: 0.03 }, 11 * 36));
  test(`${name}: the paper's functions, coupled`, () => compare("modes", entry, { model: "coupled", basis: "classical", functions: 9 }, 12 * 10));
  test(`${name}: coupled convergence`, () => compare("converge", entry, { model: "coupled", modes: 6, up_to: 5 }, 6 * 5));
  test(`${name}: coupled shapes`, () => compare("shapes", entry, { model: "coupled", modes: 5, points: 11, rotary: "off" }, 11 * 50));
  for (const kind of ["fan", "shapes"]) {
    test(`${name}: coupled drawing of ${kind}`, () => {
      const file = join(folder, `${name}-${kind}-coupled.svg`);
      const { status, stderr } = run(kind, name, "--model", "coupled", "--svg", file);
      assert.equal(status, 0, stderr);
      assert.ok(value(pkg.chart_svg(kind, blade, { model: "coupled" })).svg === readFileSync(file, "utf8"), "the two SVG texts differ");
    });
  }
  for (const kind of ["fan", "shapes", "converge"]) {
    for (const theme of ["light", "dark"]) {
      test(`${name}: drawing of ${kind}, ${theme}`, () => {
        const file = join(folder, `${name}-${kind}-${theme}.svg`);
        const { status, stderr } = run(kind, name, "--model", "uncoupled", "--svg", file, "--theme", theme);
        assert.equal(status, 0, stderr);
        const { svg, report } = value(pkg.chart_svg(kind, blade, { ...uncoupled, theme }));
        same(report, value(pkg[kind](blade, uncoupled)));
        assert.ok(svg === readFileSync(file, "utf8"), "the two SVG texts differ");
        assert.ok(svg.length > 5_000, "there is hardly anything in the drawing");
      });
    }
  }
}

test("measured points are compared alike", () => {
  const csv = "label,speed [rpm],frequency [Hz],source\n1F,660,11.5,test\n3T,330,470,test\n2F,0,0,test\n9L,10,5,other\n";
  const file = join(folder, "measured.csv");
  writeFileSync(file, csv);
  for (const { name, blade } of blades) {
    same(json("fan", name, "--model", "coupled", "--measured", file).measured, value(pkg.compare(blade, csv, { model: "coupled" })));
    for (const basis of ["piecewise", "classical"]) {
      const compared = value(pkg.compare(blade, csv, { ...uncoupled, basis }));
      same(json("fan", name, "--model", "uncoupled", "--measured", file, "--basis", basis).measured, compared);
      assert.deepEqual(
        compared.map((point) => point.computed_rad_s === null),
        [false, false, false, true],
      );
      assert.deepEqual(
        compared.map((point) => point.error_percent === null),
        [false, false, true, true],
      );
    }
  }
});

test("a blade in other units is the same blade", () => {
  const keys = ["length", "mass", "force", "angle", "speed"];
  const known = value(pkg.about()).units;
  for (const { blade } of blades) {
    const frequencies = (blade) => value(pkg.modes(blade)).modes.map((mode) => mode.frequency_rad_s);
    const own = frequencies(blade);
    for (const pick of [0, 1, 2]) {
      const units = Object.fromEntries(keys.map((key) => [key, known[key][pick % known[key].length]]));
      const converted = value(pkg.convert_blade(blade, units));
      frequencies(converted).forEach((found, i) => assert.ok(Math.abs(found - own[i]) <= 1e-12 * own[i], `${i}: ${found} is not ${own[i]}`));
    }
  }
});

test("a blade that is written reads back the same", () => {
  for (const { name, blade } of blades) {
    for (const format of ["toml", "json"]) {
      const written = value(pkg.write_blade(blade, format));
      same(value(pkg.parse_blade(written, format)), blade);
      const file = join(folder, `${name}.${format}`);
      writeFileSync(file, written);
      same(json("modes", file), json("modes", name));
    }
  }
});

test("a blade with point masses, and one without torsion, are solved alike", () => {
  const { blade } = blades.find(({ name }) => name === "uh60a");
  const { radius } = blade.rotor;
  const laden = {
    ...blade,
    point_mass: [
      { r: 0.75 * radius, mass: 3, offset: 0.01 },
      { r: radius, mass: 1 },
    ],
  };
  const bare = structuredClone(blade);
  delete bare.torsion;
  for (const key of ["torsion_stiffness", "polar_inertia", "flap_inertia", "lag_inertia"]) delete bare.distribution[key];
  for (const [name, changed] of Object.entries({ laden, bare })) {
    const file = join(folder, `${name}.json`);
    writeFileSync(file, value(pkg.write_blade(changed, "json")));
    for (const options of [{}, { propeller_moment: "full" }, { model: "coupled" }])
      compare("modes", { name: file, blade: changed }, options, 10 * 10);
    same(json("check", file), value(pkg.check(changed)));
  }
  assert.equal(pkg.modes(bare, { dof: "torsion" }).faults[0].path, "dof");
});

test("numbers, texts and lists of options mean the same", () => {
  const { blade } = blades[0];
  const modes = (options) => value(pkg.modes(blade, options));
  same(modes({ speed: 69.1 }), modes({ speed: "69.1" }));
  same(modes({ dof: ["lag", "flap"] }), modes({ dof: "lag,flap" }));
  same(value(pkg.fan(blade, { speeds: [0, "792rpm", 41], band: [0.8, 1.2] })), value(pkg.fan(blade, { speeds: "0:792rpm:41", band: "0.8:1.2" })));
  for (const speed of [0.1 + 0.2, 1e-9, 123456789.12345679, 5]) {
    assert.equal(modes({ speed }).speed_rad_s, speed);
  }
  const { faults } = pkg.modes(blade, { speed: 1e-300 });
  assert.equal(faults[0].message, "must be 0 or from 1e-9 to 1e9 rad/s (is 1e-300)");
});

// The package's TypeScript declarations against what its exports really give: every key, whether it may
// be null, and what lies in it.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { blades, pkg, value } from "./both.mjs";

const ts = createRequire(new URL("../../scripts/javascript/package.json", import.meta.url))("typescript");
const file = fileURLToPath(new URL("../../crates/wasm/src/types.ts", import.meta.url));
const program = ts.createProgram([file], { strict: true, exactOptionalPropertyTypes: true });
const checker = program.getTypeChecker();
const declared = new Map(
  checker
    .getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file)))
    .map((symbol) => [symbol.name, checker.getDeclaredTypeOfSymbol(symbol)]),
);

/** Where a null was seen, and where something else. */
const seen = { null: new Set(), other: new Set(), nullable: new Set() };

const has = (type, flag) => (type.flags & flag) !== 0;
function partsOf(type) {
  const known = type.isTypeParameter() ? checker.getBaseConstraintOfType(type) : type;
  return known.isUnion() ? known.types : [known];
}

/** Whether one part of a type fits a value, looked at from outside. */
function fits(part, given) {
  if (part.isStringLiteral()) return given === part.value;
  if (has(part, ts.TypeFlags.Boolean | ts.TypeFlags.BooleanLiteral)) return typeof given === "boolean";
  if (has(part, ts.TypeFlags.String)) return typeof given === "string";
  if (has(part, ts.TypeFlags.Number)) return typeof given === "number";
  if (!has(part, ts.TypeFlags.Object) || typeof given !== "object") return false;
  if (checker.isArrayType(part) || Array.isArray(given)) return checker.isArrayType(part) && Array.isArray(given);
  // Schema and kind of model tell reports apart.
  const schema = part.getProperty("schema");
  const model = part.getProperty("model");
  const kind = schema && model && checker.getTypeOfSymbol(model).getProperty("kind");
  if (kind && given.model !== undefined && !partsOf(checker.getTypeOfSymbol(kind)).some((known) => fits(known, given.model.kind))) return false;
  return schema === undefined || part.getProperties().every(({ name }) => name !== "schema") || fits(checker.getTypeOfSymbol(schema), given.schema);
}

/** The faults of a value held to a type; `place` is where it is declared. */
function faults(type, given, place) {
  const parts = partsOf(type);
  const nullable = parts.some((part) => has(part, ts.TypeFlags.Null));
  if (nullable) {
    seen.nullable.add(place);
    seen[given === null ? "null" : "other"].add(place);
  }
  if (given === null) return nullable ? [] : [`${place} is null`];
  const part = parts.find((part) => fits(part, given));
  if (part === undefined) return [`${place} is ${JSON.stringify(given).slice(0, 60)}, not ${checker.typeToString(type)}`];
  if (checker.isArrayType(part)) {
    const [element] = checker.getTypeArguments(part);
    return [...new Set(given.flatMap((inner) => faults(element, inner, `${place}[]`)))];
  }
  if (typeof given !== "object") return [];
  const here = part.aliasSymbol?.name ?? (part.symbol?.name.startsWith("__") ? place : part.symbol.name);
  const properties = part.getProperties();
  const names = new Set(properties.map(({ name }) => name));
  const extra = Object.keys(given)
    .filter((key) => !names.has(key))
    .map((key) => `${here}.${key} is not declared`);
  return [
    ...extra,
    ...properties.flatMap((property) => {
      const optional = has(property, ts.SymbolFlags.Optional);
      if (!Object.hasOwn(given, property.name)) return optional ? [] : [`${here}.${property.name} is not there`];
      return faults(checker.getTypeOfSymbol(property), given[property.name], `${here}.${property.name}`);
    }),
  ];
}

const agree = (name, given) => assert.deepEqual([...new Set(faults(declared.get(name), given, name))], [], name);
const agreeAll = (name, list) => list.forEach((given) => agree(name, given));

const [{ blade }] = blades;
// Free in pitch and turned by a right angle, a blade diverges.
const feathered = { ...blades.find(({ name }) => name === "uniform").blade, torsion: { root: "spring", spring: 0 } };
const diverging = { model: "coupled", pitch: "90deg", modes: 3 };
const csv = "label,speed [rpm],frequency [Hz],source\n1F,660,11.5,test\n2F,0,0,test\n9L,10,5,other\n";
const answers = {
  Blade: () => blades.map(({ blade }) => blade),
  ModesReport: () =>
    blades.flatMap(({ blade }) =>
      [{}, { speed: 0 }, { dof: "flap" }, { basis: "classical", functions: 2, modes: 2 }, { functions: 2 }].map((options) =>
        pkg.modes(blade, { model: "uncoupled", ...options }),
      ),
    ),
  CoupledModesReport: () => [
    ...blades.flatMap(({ blade }) => [{}, { speed: 0 }].map((options) => pkg.modes(blade, { model: "coupled", ...options }))),
    pkg.modes(feathered, diverging),
  ],
  CoupledShapesReport: () => [
    ...blades.map(({ blade }) => pkg.shapes(blade, { model: "coupled", modes: 2, points: 5 })),
    pkg.shapes(feathered, { ...diverging, points: 5 }),
  ],
  FanChart: () =>
    blades.flatMap(({ blade }) => [
      pkg.fan(blade, { model: "uncoupled" }),
      pkg.fan(blade, { model: "coupled", modes: 3 }),
      pkg.fan(feathered, diverging),
      pkg.fan({ ...blade, rotor: { ...blade.rotor, blades: undefined } }, { dof: "lag" }),
    ]),
  ShapesReport: () => blades.map(({ blade }) => pkg.shapes(blade, { model: "uncoupled", modes: 2, points: 5 })),
  ConvergeReport: () =>
    blades.flatMap(({ blade }) => [
      pkg.converge(blade, { model: "uncoupled", modes: 3 }),
      pkg.converge(blade, { model: "uncoupled", speed: 0, modes: 16 }),
      pkg.converge(blade, { model: "coupled", up_to: 5 }),
    ]),
  BladeSummary: () => blades.flatMap(({ blade }) => [pkg.check(blade), pkg.check({ ...blade, rotor: { ...blade.rotor, blades: undefined } })]),
  Drawing: () => ["fan", "shapes", "converge"].map((kind) => pkg.chart_svg(kind, blade)),
  About: () => [pkg.about()],
};

for (const [name, give] of Object.entries(answers)) {
  test(`${name} is as declared`, () => {
    const given = give();
    assert.ok(given.length > 0);
    agreeAll(
      name,
      given.map((answer) => (answer.status === undefined ? answer : value(answer))),
    );
  });
}

test("lists are as declared", () => {
  agreeAll("Margin", value(pkg.margins(blade)));
  agreeAll("MeasuredPoint", value(pkg.measured(csv)));
  agreeAll("ComparedPoint", value(pkg.compare(blade, csv)));
  agreeAll("BuiltInBlade", value(pkg.built_in_blades()));
});

test("faults and warnings are as declared", () => {
  const given = [pkg.parse_blade("radius ="), pkg.parse_blade("{}"), pkg.modes({ ...blade, rotor: { radius: -1 } }), pkg.modes(blade, { speed: -1 })];
  for (const { status, faults: found } of given) {
    assert.equal(status, "error");
    agreeAll("Fault", found);
  }
  const warned = pkg.modes({ ...blade, distribution: { ...blade.distribution, mass_offset: 0.1 } }, { model: "uncoupled" });
  assert.ok(warned.warnings.length > 0, "a blade with an offset of mass is warned of");
  agreeAll("Warning", warned.warnings);
});

test("what is declared as null or something is both", () => {
  assert.ok(seen.nullable.size >= 15, `${seen.nullable.size} places`);
  const never = (kind) => [...seen.nullable].filter((place) => !seen[kind].has(place)).sort();
  // Coupled modes are proven, also of a blade that diverges.
  const proven = ["lower_eigenvalue_s2", "upper_eigenvalue_s2", "separation_rad_s"].map((key) => `CoupledMode.${key}`);
  // Every built-in blade says what it is, and its modes are reached: bounds are not there for blades that
  // no mesh resolves, which core's tests have.
  const reached = ["ConvergeSeries", "Mode"].flatMap((name) => ["converged_rad_s", "lower_rad_s", "upper_rad_s"].map((key) => `${name}.${key}`));
  assert.deepEqual(
    never("null"),
    ["BuiltInBlade.citation", "BuiltInBlade.quality", "BuiltInBlade.title", "Mode.separation_rad_s", ...proven, ...reached].sort(),
  );
  // What is not proven is in core's tests.
  assert.deepEqual(never("other"), ["CoupledMode.bounds_missing", "CoupledMode.error_estimate_rad_s"]);
});

test("a key that is missing in either is found", () => {
  const [shape] = value(pkg.shapes(blade, { model: "uncoupled", modes: 1, points: 3 })).shapes;
  assert.deepEqual(faults(declared.get("ShapeReport"), { ...shape, more: 1 }, ""), ["ShapeReport.more is not declared"]);
  const { orthogonality, ...less } = shape;
  assert.equal(typeof orthogonality, "number");
  assert.deepEqual(faults(declared.get("ShapeReport"), less, ""), ["ShapeReport.orthogonality is not there"]);
  assert.deepEqual(faults(declared.get("ShapeReport"), { ...shape, label: null }, ""), ["ShapeReport.label is null"]);
});

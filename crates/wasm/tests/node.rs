//! The boundary: what JavaScript may hand in, and what it gets back. Run by
//! `wasm-pack test --node crates/wasm`; the numbers themselves are core's tests' business.

#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may stop")]
#![allow(clippy::float_cmp, reason = "whole numbers that must arrive as they are")]
#![allow(missing_docs, reason = "tests say it by their names")]

use bladefan_wasm::{
    about, at_speed, built_in_blades, change_blade, chart_svg, check, compare, converge, convert_blade, fan, margins,
    measured, modes, parse_blade, shapes, version, write_blade,
};
use js_sys::{Array, Function, JSON, Object, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

type Answer = Result<JsValue, JsError>;
type Solver = fn(&JsValue, &JsValue) -> Answer;

/// A value of JavaScript.
fn js(source: &str) -> JsValue {
    Function::new_no_args(&format!("return {source}")).call0(&JsValue::NULL).expect("the source is sound")
}

/// A value inside a value, by keys and indices.
fn get(value: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(value.clone(), |value, key| Reflect::get(&value, &key.into()).expect("an object"))
}

fn text(value: &JsValue, path: &str) -> String {
    get(value, path).as_string().unwrap_or_else(|| panic!("no text at {path}"))
}

fn number(value: &JsValue, path: &str) -> f64 {
    get(value, path).as_f64().unwrap_or_else(|| panic!("no number at {path}"))
}

fn length(value: &JsValue, path: &str) -> u32 {
    Array::from(&get(value, path)).length()
}

fn answer(answer: Answer) -> JsValue {
    answer.unwrap_or_else(|_| panic!("an export threw"))
}

/// The value of an answer that must be a result.
fn value(given: Answer) -> JsValue {
    let given = answer(given);
    assert_eq!(text(&given, "status"), "ok", "{:?}", JSON::stringify(&given));
    assert!(Array::is_array(&get(&given, "warnings")));
    get(&given, "value")
}

/// The faults of an answer that must have some, as `code path: message`.
fn faults(given: Answer) -> Vec<String> {
    let given = answer(given);
    assert_eq!(text(&given, "status"), "error", "{:?}", JSON::stringify(&given));
    let faults = Array::from(&get(&given, "faults"));
    assert!(faults.length() > 0, "an error without a fault");
    let line = |fault: JsValue| {
        let keys: Vec<_> =
            Object::keys(fault.unchecked_ref::<Object>()).iter().filter_map(|key| key.as_string()).collect();
        assert_eq!(keys, ["code", "path", "value", "rule", "message", "line", "column"]);
        format!("{} {}: {}", text(&fault, "code"), text(&fault, "path"), text(&fault, "message"))
    };
    faults.iter().map(line).collect()
}

fn blade_text(index: u32) -> JsValue {
    get(&Array::from(&value(built_in_blades())).get(index), "toml")
}

fn blade() -> JsValue {
    value(parse_blade(&blade_text(0), &JsValue::UNDEFINED))
}

/// A measured point.
const POINT: &str = "label,speed [rpm],frequency [Hz],source\n1F,660,11.5,test\n";

/// Every export that takes a blade and options.
const SOLVERS: [(&str, Solver); 9] = [
    ("modes", modes),
    ("margins", margins),
    ("fan", fan),
    ("shapes", shapes),
    ("converge", converge),
    ("chart_svg", |blade, options| chart_svg(&"fan".into(), blade, options)),
    ("compare", |blade, options| compare(blade, &POINT.into(), options)),
    ("check", |blade, _| check(blade)),
    ("write_blade", |blade, _| write_blade(blade, &"toml".into())),
];

/// Values that are no blade and no options object.
const STRANGE: [&str; 16] = [
    "5",
    "NaN",
    "'text'",
    "true",
    "[]",
    "[[1, 2], {}]",
    "() => 1",
    "class {}",
    "Symbol('s')",
    "10n",
    "(() => { const a = []; a.push(a); return a })()",
    "new Proxy({}, { ownKeys() { throw new Error('no') } })",
    "new Proxy({ rotor: 1 }, { get() { throw new Error('no') } })",
    "({ get speed() { throw new Error('no') }, get rotor() { throw new Error('no') } })",
    "(() => { const { proxy, revoke } = Proxy.revocable([], {}); revoke(); return proxy })()",
    "(() => { const { proxy, revoke } = Proxy.revocable([], {}); revoke(); return { rotor: proxy, speed: proxy } })()",
];

#[wasm_bindgen_test]
fn a_result_is_a_plain_object() {
    let report = value(modes(&blade(), &js("({ model: 'uncoupled' })")));
    assert_eq!(text(&report, "schema"), "bladefan-modes/1");
    assert_eq!(text(&report, "model.kind"), "uncoupled");
    assert_eq!(length(&report, "modes"), 15);
    assert_eq!(text(&report, "modes.0.label"), "1F");
    assert_eq!(text(&report, "modes.0.dof"), "flap");
    assert!(number(&report, "modes.0.frequency_rad_s") > 70.0);
    // Absent values are null, not undefined, and lists of pairs are objects, not maps.
    let at_rest = value(modes(&blade(), &js("({ model: 'uncoupled', speed: 0 })")));
    assert!(get(&at_rest, "modes.0.per_rev").is_null());
    assert!(get(&at_rest, "modes.0.nearest_harmonic").is_null());
    assert_eq!(number(&report, "modes.0.nearest_harmonic"), 1.0);
    let again = JSON::parse(&String::from(JSON::stringify(&report).unwrap())).unwrap();
    assert_eq!(JSON::stringify(&again).unwrap(), JSON::stringify(&report).unwrap());
}

#[wasm_bindgen_test]
fn every_export_answers() {
    let blade = blade();
    let none = JsValue::UNDEFINED;
    assert_eq!(length(&value(fan(&blade, &none)), "speeds_rad_s"), 101);
    let apart = js("({ model: 'uncoupled' })");
    assert_eq!(length(&value(shapes(&blade, &apart)), "shapes.0.displacement"), 101);
    assert_eq!(length(&value(shapes(&blade, &none)), "shapes.0.components.flap.displacement"), 101);
    assert_eq!(length(&value(converge(&blade, &none)), "functions"), 16);
    assert!(get(&value(converge(&blade, &apart)), "series.1.classical_rad_s.0").is_null());
    assert_eq!(number(&value(margins(&blade, &none)), "0.nearest_harmonic"), 1.0);
    assert_eq!(text(&value(check(&blade)), "schema"), "bladefan-check/1");
    assert_eq!(text(&value(about()), "version"), version());
    assert_eq!(number(&value(about()), "speed_units.0.rad_s"), 1.0);
    let points = value(measured(&POINT.into()));
    assert_eq!(text(&points, "0.source"), "test");
    let compared = value(compare(&blade, &POINT.into(), &none));
    assert!(number(&compared, "0.error_percent").abs() < 5.0);
    assert_eq!(
        faults(compare(&blade, &POINT.into(), &js("({ speed: 5 })"))),
        ["option speed: is not an option of compare"]
    );
    let all = faults(compare(&js("({})"), &"x".into(), &js("({ modes: 0 })")));
    for path in ["rotor", "header[0]", "modes"] {
        assert!(all.iter().any(|fault| fault.contains(&format!(" {path}: "))), "{path}: {all:?}");
    }
    assert_eq!(text(&value(about()), "units.length.3"), "in");
}

#[wasm_bindgen_test]
fn the_built_in_blades_say_what_they_are() {
    let blades = value(built_in_blades());
    let blades = Array::from(&blades);
    assert!(blades.length() >= 5);
    for (index, entry) in blades.iter().enumerate() {
        for key in ["name", "title", "quality", "citation", "toml"] {
            assert!(!text(&entry, key).is_empty(), "{key} of blade {index}");
        }
    }
}

#[wasm_bindgen_test]
fn a_drawing_has_text_size_and_plot_areas() {
    for (kind, plots) in [("fan", 1), ("shapes", 3), ("converge", 2)] {
        let options = js("({ theme: 'dark', width: 640, frequency_unit: 'Hz' })");
        let drawing = value(chart_svg(&kind.into(), &blade(), &options));
        assert!(text(&drawing, "svg").starts_with("<svg"), "{kind}");
        assert_eq!(number(&drawing, "width"), 640.0);
        assert_eq!(length(&drawing, "plots"), plots, "{kind}");
        assert!(number(&drawing, "plots.0.x.to") > number(&drawing, "plots.0.x.from"));
        assert_eq!(text(&drawing, "report.schema"), format!("bladefan-{kind}/1"));
    }
    let window = js("({ frequency_unit: 'per-rev', frequencies: [1, '6.5'], width: 600, height: 500 })");
    let drawing = value(chart_svg(&"fan".into(), &blade(), &window));
    assert_eq!((number(&drawing, "plots.0.y.from"), number(&drawing, "plots.0.y.to")), (1.0, 6.5));
    assert_eq!((number(&drawing, "width"), number(&drawing, "height")), (600.0, 500.0));
    assert_eq!(text(&drawing, "plots.0.y.unit"), "/rev");
    let points = js("({ measured: 'label,speed [rpm],frequency [Hz],source\\n1F,660,11.5,wind tunnel\\n' })");
    assert!(text(&value(chart_svg(&"fan".into(), &blade(), &points)), "svg").contains("wind tunnel"));
}

#[wasm_bindgen_test]
fn warnings_come_with_every_answer() {
    // The inertia of coupled motion comes first.
    let parsed = answer(parse_blade(&blade_text(0), &JsValue::UNDEFINED));
    assert_eq!(text(&parsed, "warnings.1.path"), "distribution.mass_offset");
    let solved = answer(modes(&blade(), &js("({ model: 'uncoupled' })")));
    assert_eq!(text(&solved, "warnings.1.path"), "distribution.mass_offset");
}

#[wasm_bindgen_test]
fn a_blade_goes_in_as_it_came_out() {
    let blade = blade();
    let copy = JSON::parse(&String::from(JSON::stringify(&blade).unwrap())).unwrap();
    let both = [&blade, &copy].map(|blade| value(modes(blade, &JsValue::UNDEFINED)));
    assert_eq!(JSON::stringify(&both[0]).unwrap(), JSON::stringify(&both[1]).unwrap());
    let text = JSON::stringify(&blade).unwrap();
    let read = value(parse_blade(&text, &"json".into()));
    assert_eq!(JSON::stringify(&read).unwrap(), text);
}

#[wasm_bindgen_test]
fn a_blade_is_converted_whole_or_in_part_and_unchecked() {
    let si = js("({ length: 'm', mass: 'kg', force: 'N', angle: 'rad', speed: 'rad/s' })");
    let si = value(convert_blade(&blade(), &si));
    assert!(get(&si, "units").is_undefined(), "SI is not written");
    let partial = value(convert_blade(&si, &js("({ length: 'in', speed: 'rpm' })")));
    assert_eq!((number(&partial, "rotor.radius"), number(&partial, "rotor.nominal_speed")), (55.0, 660.0));
    assert_eq!(text(&partial, "units.length"), "in");
    let same = value(convert_blade(&partial, &js("({})")));
    assert_eq!(JSON::stringify(&same).unwrap(), JSON::stringify(&partial).unwrap());
    let unfinished = js("({ schema: 'bladefan-blade/1', rotor: { radius: -55 }, units: { length: 'in' } })");
    let converted = value(convert_blade(&unfinished, &js("({ length: 'm' })")));
    assert_eq!(number(&converted, "rotor.radius"), -1.397);
    for (units, fault) in [
        ("({ length: 'furlong' })", "unknown-unit units.length: "),
        ("({ lenght: 'm' })", "unknown-key units.lenght: "),
        ("({ speed: 5 })", "wrong-type units.speed: "),
        ("5", "wrong-type units: "),
        ("undefined", "wrong-type units: "),
    ] {
        let given = faults(convert_blade(&blade(), &js(units)));
        assert!(given[0].starts_with(fault), "{given:?}");
    }
    for source in STRANGE {
        faults(convert_blade(&js(source), &js("({})")));
        faults(convert_blade(&blade(), &js(&format!("({{ length: {source} }})"))));
    }
}

#[wasm_bindgen_test]
fn no_blade_and_strange_blades_are_faults() {
    for (name, call) in SOLVERS {
        for source in ["undefined", "null"].iter().chain(&STRANGE) {
            assert!(!faults(call(&js(source), &JsValue::UNDEFINED)).is_empty(), "{name} of {source}");
        }
        assert!(faults(call(&js("({})"), &JsValue::UNDEFINED)).len() >= 5, "{name}: everything is missing");
    }
}

#[wasm_bindgen_test]
fn strange_options_are_faults() {
    let blade = blade();
    for (name, call) in SOLVERS.into_iter().filter(|(name, _)| !["check", "write_blade"].contains(name)) {
        for source in STRANGE {
            assert!(!faults(call(&blade, &js(source))).is_empty(), "{name} with {source}");
        }
        for source in ["undefined", "null", "({})", "({ modes: undefined, dof: null })"] {
            value(call(&blade, &js(source)));
        }
    }
}

#[wasm_bindgen_test]
fn strange_values_of_options_are_faults() {
    for strange in STRANGE.iter().filter(|source| !["5", "'text'"].contains(source)) {
        let options = js(&format!("({{ speed: {strange} }})"));
        let given = faults(modes(&blade(), &options));
        assert!(given[0].starts_with("option speed: ") || given[0].starts_with("wrong-type speed: "), "{given:?}");
    }
}

#[wasm_bindgen_test]
fn an_object_that_holds_itself_ends() {
    for source in [
        "(() => { const a = {}; a.rotor = a; a.flap = a; return a })()",
        "(() => { const a = { rotor: {} }; for (let i = 0; i < 50; i++) a.rotor[i] = a; return a })()",
        "({ notes: 'x', distribution: { r: new Array(1e9) } })",
        "({ distribution: { r: Object.assign([], { length: 4294967295 }) } })",
    ] {
        faults(modes(&js(source), &JsValue::UNDEFINED));
    }
}

#[wasm_bindgen_test]
fn numbers_in_a_blade_must_be_finite() {
    for (strange, code) in [
        ("NaN", "not-finite"),
        ("Infinity", "not-finite"),
        ("'2'", "wrong-type"),
        ("null", "missing"),
        ("-1", "out-of-range"),
    ] {
        let blade = blade();
        Reflect::set(&get(&blade, "rotor"), &"radius".into(), &js(strange)).unwrap();
        let given = faults(modes(&blade, &JsValue::UNDEFINED));
        assert!(given[0].starts_with(&format!("{code} rotor.radius: ")), "{strange}: {given:?}");
    }
}

#[wasm_bindgen_test]
fn faults_of_blade_and_options_come_together() {
    let given = faults(modes(&js("({})"), &js("({ speed: 'fast', sped: 1, functions: 0.5 })")));
    for name in ["speed", "sped", "functions", "rotor"] {
        assert!(given.iter().any(|fault| fault.contains(&format!(" {name}: "))), "{name}: {given:?}");
    }
}

#[wasm_bindgen_test]
fn an_option_of_another_call_is_a_fault() {
    let blade = blade();
    assert_eq!(faults(modes(&blade, &js("({ harmonics: 5 })"))), ["option harmonics: is not an option of modes"]);
    assert_eq!(faults(fan(&blade, &js("({ theme: 'dark' })"))), ["option theme: is not an option of fan"]);
    let shapes = chart_svg(&"shapes".into(), &blade, &js("({ measured: '' })"));
    assert_eq!(faults(shapes), ["option measured: is not an option of shapes"]);
    let shapes = chart_svg(&"shapes".into(), &blade, &js("({ frequencies: [0, 1] })"));
    assert_eq!(faults(shapes), ["option frequencies: is not an option of shapes"]);
}

#[wasm_bindgen_test]
fn looks_that_do_not_exist_are_faults() {
    for (options, name) in [
        ("({ theme: 'sepia' })", "theme"),
        ("({ width: 12.5 })", "width"),
        ("({ width: -1 })", "width"),
        ("({ speed_unit: 'mph' })", "speed_unit"),
        ("({ frequency_unit: '/rev' })", "frequency_unit"),
        ("({ height: 12.5 })", "height"),
        ("({ frequencies: [5, 5] })", "frequencies"),
        ("({ frequencies: [-1, 5] })", "frequencies"),
        ("({ frequencies: [0, Infinity] })", "frequencies"),
        ("({ frequencies: '5' })", "frequencies"),
    ] {
        let given = faults(chart_svg(&"fan".into(), &blade(), &js(options)));
        assert!(given[0].starts_with(&format!("option {name}: ")), "{given:?}");
    }
    assert!(faults(chart_svg(&"fan".into(), &blade(), &js("({ measured: 'x' })")))[0].contains("header"));
    for kind in ["undefined", "'pie'", "1", "({})"] {
        assert!(faults(chart_svg(&js(kind), &blade(), &JsValue::UNDEFINED))[0].starts_with("unknown-choice kind: "));
    }
}

#[wasm_bindgen_test]
fn text_that_is_no_text_is_a_fault() {
    for source in ["undefined", "null"].iter().chain(&STRANGE).filter(|source| **source != "'text'") {
        assert_eq!(faults(parse_blade(&js(source), &JsValue::UNDEFINED)), ["wrong-type text: must be text"]);
        assert_eq!(faults(measured(&js(source))), ["wrong-type text: must be text"]);
    }
    for source in ["'yaml'", "5", "({})"] {
        let given = faults(parse_blade(&blade_text(0), &js(source)));
        assert!(given[0].starts_with("unknown-choice format: "), "{given:?}");
    }
    for source in ["'yaml'", "5", "undefined"] {
        let given = faults(write_blade(&blade(), &js(source)));
        assert_eq!(given, ["unknown-choice format: must be toml or json"]);
    }
    assert!(faults(write_blade(&js("({})"), &js("'yaml'"))).len() > 5, "faults of both come together");
}

#[wasm_bindgen_test]
fn faults_of_a_text_have_their_place() {
    let bad = blade_text(0).as_string().unwrap().replacen("radius = ", "radius = -", 1);
    let given = answer(parse_blade(&bad.as_str().into(), &"toml".into()));
    let line = bad.lines().position(|line| line.starts_with("radius")).unwrap() + 1;
    assert_eq!(number(&given, "faults.0.line"), line as f64);
    assert!(number(&given, "faults.0.column") > 1.0);
}

#[wasm_bindgen_test]
fn a_blade_is_changed_and_what_goes_along_is_said() {
    let changes = js(
        "[{ what: 'distribution.mass', scale: 2, from: null }, { what: 'flap.offset', set: 50, units: { length: 'mm' } }]",
    );
    let changed = value(change_blade(&blade(), &changes));
    assert_eq!(text(&changed, "notes.0.path"), "distribution.polar_inertia");
    let alone = js("[{ what: 'distribution.mass', scale: 2, mass_alone: true }]");
    assert_eq!(length(&value(change_blade(&blade(), &alone)), "notes"), 0);
    let same = value(change_blade(&blade(), &js("[]")));
    assert_eq!(JSON::stringify(&get(&same, "blade")).unwrap(), JSON::stringify(&blade()).unwrap());
    let bad = js(
        "[{ what: 'mass', scale: 2 }, { what: 'flap.spring', set: 1, add: 1 }, { what: 'lag.spring', scale: '2' }, 4]",
    );
    let expected = [
        "unknown-choice changes[0].what: what is changed must be rotor.nominal_speed, flap.offset, flap.spring, \
         lag.offset, lag.spring, torsion.offset, torsion.spring, distribution.mass, distribution.flap_stiffness, \
         distribution.lag_stiffness, distribution.torsion_stiffness, distribution.polar_inertia, \
         distribution.flap_inertia, distribution.lag_inertia, distribution.mass_offset, distribution.twist, \
         distribution.tension_offset, distribution.axial_stiffness or distribution.trapeze_radius (is mass)",
        "conflict changes[1]: a change must have one of scale, set and add",
        "wrong-type changes[2].scale: scale must be a number (is \"2\")",
        "wrong-type changes[3]: changes [3] must be a table (is 4)",
    ];
    assert_eq!(faults(change_blade(&blade(), &bad)), expected);
    assert_eq!(
        faults(change_blade(&blade(), &js("1"))),
        ["wrong-type changes: changes must be a list of changes (is 1)"]
    );
}

#[wasm_bindgen_test]
fn a_fan_chart_is_read_off_between_its_speeds() {
    let chart = value(fan(&blade(), &js("({ model: 'uncoupled', modes: 2 })")));
    let speed = number(&chart, "speeds_rad_s.50");
    let there = value(at_speed(&chart, &speed.into()));
    assert_eq!(Array::from(&there).length(), 6);
    assert_eq!(text(&there, "0.label"), "1F");
    assert!(
        (number(&there, "0.frequency_rad_s") / number(&chart, "branches.0.frequency_rad_s.50") - 1.0).abs() < 1e-14
    );
    assert!(get(&value(at_speed(&chart, &0.0.into())), "0.per_rev").is_null());
    let bad = js("({ speeds_rad_s: [0, 1, 2], branches: [{ label: 'first', frequency_rad_s: [1, 1, 1] }] })");
    let expected = ["unknown-choice chart.branches[0].label: a label must be a number and F, L or T, like 1F"];
    assert_eq!(faults(at_speed(&bad, &1.0.into())), expected);
    assert_eq!(faults(at_speed(&chart, &js("-1"))), ["wrong-type speed: must be a number of at least 0"]);
}

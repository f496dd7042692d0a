//! Fig. 4 and 5: relative frequency errors of a uniform blade at rest. Its modes are themselves the
//! assumed functions, so only quadrature and rounding can err.

use super::plot::{Axes, COLOURS, Curve, GREY, Stroke, chart};
use super::table::{cells, labelled, list, number, table};
use super::{Cli, Output};
use core::f64::consts::PI;
use core::fmt::Write as _;
use libm::{cos, cosh, sin, tanh};

const MODES: usize = 10;
const MOST: usize = 60;
/// Errors of 0 are drawn here.
const FLOOR: f64 = 1e-17;

/// EI, GJ, length and springs of the two blade files.
const EI: f64 = 50.0;
const GJ: f64 = 7.0;
const LENGTH: f64 = 2.0;
const HINGE_SPRING: f64 = 30.0;
const CONTROL_SPRING: f64 = 3.0;

struct Panel {
    name: &'static str,
    what: &'static str,
    blade: &'static str,
    dof: &'static str,
    letter: char,
    /// The paper's largest error: stated in its text for Fig. 4, the end of the axis for Fig. 5.
    paper: f64,
    /// What z = βl or γl of a mode makes zero; mode i lies between i − 1 and i times π.
    condition: fn(f64) -> f64,
    /// The frequency of z [rad/s].
    frequency: fn(f64) -> f64,
}

fn bending(z: f64) -> f64 {
    (z / LENGTH) * (z / LENGTH) * EI.sqrt()
}

fn torsion(z: f64) -> f64 {
    z / LENGTH * GJ.sqrt()
}

/// The characteristic equations, divided by cosh z where they hold it (paper Eq. 15, 22–25 and those of torsion).
const PANELS: [Panel; 4] = [
    Panel {
        name: "fig-4a",
        what: "hingeless",
        blade: "rigid-at-rest",
        dof: "flap",
        letter: 'F',
        paper: 7.6e-5,
        condition: |z| cos(z) + 1.0 / cosh(z),
        frequency: bending,
    },
    Panel {
        name: "fig-4b",
        what: "spring-hinged",
        blade: "sprung-at-rest",
        dof: "flap",
        letter: 'F',
        paper: 3e-5,
        condition: |z| HINGE_SPRING * (1.0 / cosh(z) + cos(z)) + EI * z / LENGTH * (cos(z) * tanh(z) - sin(z)),
        frequency: bending,
    },
    Panel {
        name: "fig-5a",
        what: "rigid pitch control",
        blade: "rigid-at-rest",
        dof: "torsion",
        letter: 'T',
        paper: 4.87e-5,
        condition: cos,
        frequency: torsion,
    },
    Panel {
        name: "fig-5b",
        what: "springy pitch control",
        blade: "sprung-at-rest",
        dof: "torsion",
        letter: 'T',
        paper: 9e-5,
        condition: |z| CONTROL_SPRING * cos(z) - GJ * z / LENGTH * sin(z),
        frequency: torsion,
    },
];

/// The only root between `low` and `high`, to the last bit that bisection gives.
fn root(condition: fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let rising = condition(low) < 0.0;
    assert!(rising != (condition(high) < 0.0), "no root between {low} and {high}");
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if (condition(middle) < 0.0) == rising { low = middle } else { high = middle }
    }
}

pub(super) fn figures_4_and_5(cli: &Cli, output: &mut Output) {
    let mut rows = Vec::new();
    let mut images = String::new();
    for panel in PANELS {
        let command = format!(
            "converge tests/cases/blades/{}.toml --speed 0 --basis classical --dof {} --modes {MODES} --up-to {MOST}",
            panel.blade, panel.dof
        );
        let report = cli.json(&command);
        let mut csv = String::from("mode,functions,frequency [rad/s],closed form [rad/s],relative error\n");
        let (mut points, mut largest) = (Vec::new(), 0.0_f64);
        for mode in 1..=MODES {
            // Not from 0, where the bending conditions vanish or nearly do.
            let z = root(panel.condition, (mode as f64 - 1.0) * PI + 1e-3, mode as f64 * PI + 1e-3);
            let exact = (panel.frequency)(z);
            let label = format!("{mode}{}", panel.letter);
            let series = labelled(&report["series"], &label);
            for (functions, value) in list(&report["functions"]).iter().zip(list(&series["classical_rad_s"])) {
                let Some(found) = value.as_f64() else { continue };
                let error = (found / exact - 1.0).abs();
                writeln!(csv, "{label},{functions},{found},{exact},{error:e}").unwrap();
                points.push((number(functions), error.max(FLOOR)));
                largest = largest.max(error);
            }
        }
        assert!(largest < 1e-12, "{}: {largest:e}", panel.name);
        let paper = Curve {
            label: format!("the paper: at most {:e}", panel.paper),
            colour: GREY,
            stroke: Stroke::Dashed,
            points: vec![(0.0, panel.paper), (MOST as f64, panel.paper)],
        };
        let ours = Curve {
            label: "bladefan, ten modes".into(),
            colour: COLOURS[usize::from(panel.letter == 'T') * 2],
            stroke: Stroke::Dots,
            points,
        };
        let axes = Axes {
            title: panel.what.into(),
            x: "assumed functions N",
            y: "relative frequency error",
            across: 0.0..MOST as f64,
            up: FLOOR / 2.0..1e-3,
            powers: true,
        };
        let alternative =
            format!("Relative frequency errors of ten modes against the number of functions, {}", panel.what);
        images += &output.image(panel.name, &alternative, chart(&axes, &[paper, ours]));
        let link = output.csv(panel.name, csv);
        let figure = panel.name.replace("fig-", "Fig. ");
        rows.push(vec![figure, panel.what.into(), format!("{:e}", panel.paper), format!("{largest:.0e}"), link]);
    }
    let head = cells(&["figure", "root", "the paper: at most, N to 12", "largest here, N to 60", "numbers"]);
    output.part("figures 4 and 5", table(&head, &rows) + "\n" + &images);
}

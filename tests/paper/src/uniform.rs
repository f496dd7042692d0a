//! Fig. 4 and 5: relative frequency errors of a uniform blade at rest. Its modes are themselves the
//! assumed functions, so only quadrature and rounding can err.

use super::plot::{Axes, COLOURS, Curve, GREY, Stroke, chart};
use super::table::{cells, labelled, list, number, table};
use super::{Cli, Output};
use bladefan_tests::closed_forms::{CLAMPED, CONTROL_SPRING, SPRING_HINGED};
use core::f64::consts::PI;
use core::fmt::Write as _;

const MODES: usize = 10;
const MOST: usize = 60;
/// Errors of 0 are drawn here.
const FLOOR: f64 = 1e-17;

struct Panel {
    name: &'static str,
    what: &'static str,
    blade: &'static str,
    dof: &'static str,
    letter: char,
    /// The paper's largest error: stated in its text for Fig. 4, the end of the axis for Fig. 5.
    paper: f64,
    /// The closed form of a mode, from 1 [rad/s].
    exact: fn(usize) -> f64,
}

/// The two blade files have the length 2, EI = 50, GJ = 7, and springs of 30 (hinge) and 3 (pitch control).
const PANELS: [Panel; 4] = [
    Panel {
        name: "fig-4a",
        what: "hingeless",
        blade: "rigid-at-rest",
        dof: "flap",
        letter: 'F',
        paper: 7.6e-5,
        exact: |mode| CLAMPED[mode - 1] / 4.0 * 50_f64.sqrt(),
    },
    Panel {
        name: "fig-4b",
        what: "spring-hinged",
        blade: "sprung-at-rest",
        dof: "flap",
        letter: 'F',
        paper: 3e-5,
        exact: |mode| SPRING_HINGED[mode - 1],
    },
    Panel {
        name: "fig-5a",
        what: "rigid pitch control",
        blade: "rigid-at-rest",
        dof: "torsion",
        letter: 'T',
        paper: 4.87e-5,
        exact: |mode| (mode as f64 - 0.5) * PI / 2.0 * 7_f64.sqrt(),
    },
    Panel {
        name: "fig-5b",
        what: "springy pitch control",
        blade: "sprung-at-rest",
        dof: "torsion",
        letter: 'T',
        paper: 9e-5,
        exact: |mode| CONTROL_SPRING[mode - 1],
    },
];

pub(super) fn figures_4_and_5(cli: &Cli, output: &mut Output) {
    let mut rows = Vec::new();
    let mut images = String::new();
    for panel in PANELS {
        let command = format!(
            "converge tests/cases/blades/{}.toml --model uncoupled --speed 0 --basis classical --dof {} --modes {MODES} --up-to {MOST}",
            panel.blade, panel.dof
        );
        let report = cli.json(&command);
        let mut csv = String::from("mode,functions,frequency [rad/s],closed form [rad/s],relative error\n");
        let (mut points, mut largest) = (Vec::new(), 0.0_f64);
        for mode in 1..=MODES {
            let exact = (panel.exact)(mode);
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

//! Fig. 10 and 12 to 15: mode shapes, and how orthogonal they are (Eq. 84–85).

use super::table::{cells, list, number, percent, table, text};
use super::{Cli, Output};
use serde_json::Value;

/// Figures, blade, speed.
const FIGURES: [(&str, &str, &str); 3] =
    [("10", "tm4760", "660rpm"), ("12-13", "hingeless-1000", "0"), ("14-15", "hingeless-1000", "105")];
/// Shapes further from orthogonal would be wrong, not rounded.
const ROUNDING: f64 = 1e-12;

pub(super) fn figures(cli: &Cli, output: &mut Output) {
    let mut rows = Vec::new();
    for (figure, blade, speed) in FIGURES {
        let command = format!("shapes {blade} --model uncoupled --speed {speed} --modes 4");
        let name = format!("fig-{figure}");
        let image = output.draw(cli, &name, &format!("Mode shapes of {blade} at {speed}"), &command);
        let link = output.csv(&name, cli.csv(&command));
        output.part(&format!("figure {figure}"), format!("{image}\n`bladefan {command}`, {link}\n"));
        for basis in ["piecewise", "classical"] {
            let report = cli.json(&format!("{command} --basis {basis} --points 2"));
            let largest = |dof: &str| {
                let of_dof = list(&report["shapes"]).iter().filter(|shape| shape["dof"] == dof);
                of_dof.map(|shape| number(&shape["orthogonality"])).fold(0.0, f64::max)
            };
            let all = ["flap", "lag", "torsion"].map(largest);
            assert!(all.iter().all(|&value| value < ROUNDING), "{blade} at {speed}: {all:?}");
            let mut row =
                vec![format!("Fig. {}", figure.replace('-', "–")), format!("{blade} at {speed}"), basis.into()];
            row.extend(all.map(|value| format!("{value:.0e}")));
            rows.push(row);
        }
    }
    let head = cells(&["figure", "blade", "functions", "flap", "lag", "torsion"]);
    output.part("orthogonality", table(&head, &rows));
    output.part("change of shape", change(cli));
}

/// How much the hingeless blade's flap shapes change from rest to 105 rad/s.
fn change(cli: &Cli) -> String {
    let changes = |basis: &str| -> Vec<(String, f64)> {
        let [rest, turning] = ["0", "105"].map(|speed| {
            cli.json(&format!(
                "shapes hingeless-1000 --model uncoupled --speed {speed} --dof flap --modes 3 --points 201 --basis {basis}"
            ))
        });
        let displacement = |shape: &Value| list(&shape["displacement"]).iter().map(number).collect::<Vec<f64>>();
        let pairs = list(&rest["shapes"]).iter().zip(list(&turning["shapes"]));
        pairs
            .map(|(a, b)| {
                let differences = displacement(a).into_iter().zip(displacement(b)).map(|(a, b)| (a - b).abs());
                (text(&a["label"]).into(), differences.fold(0.0, f64::max))
            })
            .collect()
    };
    let row = |(converged, fifteen): (&(String, f64), &(String, f64))| {
        let words = |part: f64| percent(part).replace('+', "");
        vec![converged.0.clone(), words(converged.1), words(fifteen.1)]
    };
    let rows: Vec<Vec<String>> = changes("piecewise").iter().zip(&changes("classical")).map(row).collect();
    table(
        &cells(&["mode", "largest change of the shape, in per cent of the tip's displacement", "with 15 functions"]),
        &rows,
    )
}

//! Fig. 8: computational time, from the record that `scripts/reproduce-paper --times` writes.

use super::Output;
use super::plot::{Axes, COLOURS, Curve, GREY, Stroke, chart};
use super::table::{cells, digits, table};
use std::fs;
use std::path::Path;

const RECORD: &str = "docs/paper/fig-8.csv";
/// What the paper reports for 15 functions, all degrees of freedom, on its 2 GHz computer [ms].
const PAPER: f64 = 600.0;
const DOFS: [&str; 3] = ["flap", "lag", "torsion"];

/// One line of the record; times in ms.
struct Line {
    blade: String,
    dof: String,
    functions: f64,
    assembly: f64,
    solve: f64,
    march: f64,
}

fn read(text: &str) -> Vec<Line> {
    let line = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |at: usize| fields[at].parse().unwrap_or_else(|_| panic!("{RECORD}: {line}"));
        assert_eq!(fields.len(), 6, "{RECORD}: {line}");
        Line {
            blade: fields[0].into(),
            dof: fields[1].into(),
            functions: number(2),
            assembly: number(3),
            solve: number(4),
            march: number(5),
        }
    };
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(line).collect()
}

pub(super) fn figure_8(root: &Path, output: &mut Output) {
    let text = fs::read_to_string(root.join(RECORD)).unwrap_or_else(|error| panic!("{RECORD}: {error}"));
    let lines = read(&text);
    let mut part = String::new();
    for (panel, blade) in [("a", "tm4760"), ("b", "hingeless-1000")] {
        let of = |dof: &str| lines.iter().filter(|line| line.blade == blade && line.dof == dof).collect::<Vec<_>>();
        let mut curves = vec![Curve {
            label: "the paper, all three, N = 15".into(),
            colour: GREY,
            stroke: Stroke::Dots,
            points: vec![(15.0, PAPER)],
        }];
        for (who, stroke, time) in [
            ("the paper's march", Stroke::Dashed, (|line| line.assembly + line.march) as fn(&Line) -> f64),
            ("bladefan", Stroke::Solid, |line| line.assembly + line.solve),
        ] {
            let mut three: Vec<Curve> = DOFS
                .into_iter()
                .zip(COLOURS)
                .map(|(dof, colour)| {
                    let points = of(dof).iter().map(|line| (line.functions, time(line))).collect();
                    Curve { label: format!("{dof}, {who}"), colour, stroke, points }
                })
                .collect();
            // Labels are placed downwards.
            three.sort_by(|a, b| b.points.last().unwrap().1.total_cmp(&a.points.last().unwrap().1));
            curves.extend(three);
        }
        let title =
            if panel == "a" { "TM 4760 research blade, 660 rpm" } else { "Hingeless model (estimated), 105 rad/s" };
        let axes = Axes {
            title: title.into(),
            x: "assumed functions N",
            y: "time [ms]",
            across: 5.0..40.0,
            up: 0.01..2000.0,
            powers: true,
        };
        part += &output.image(
            &format!("fig-8{panel}"),
            &format!("Computational time against the number of functions, {blade}"),
            chart(&axes, &curves),
        );
        let mut counts: Vec<f64> = of("flap").iter().map(|line| line.functions).collect();
        counts.dedup();
        let sum = |functions: f64, time: &dyn Fn(&Line) -> f64| -> f64 {
            lines.iter().filter(|line| line.blade == blade && (line.functions - functions).abs() < 0.5).map(time).sum()
        };
        let rows: Vec<Vec<String>> = counts
            .iter()
            .map(|&functions| {
                let assembly = sum(functions, &|line| line.assembly);
                let (solve, march) = (sum(functions, &|line| line.solve), sum(functions, &|line| line.march));
                vec![
                    functions.to_string(),
                    digits(assembly, 2),
                    digits(solve, 2),
                    digits(march, 2),
                    format!("{:.0}", march / solve),
                    digits(assembly + solve, 2),
                    format!("{:.0}", (assembly + march) / (assembly + solve)),
                    if (functions - 15.0).abs() < 0.5 { format!("{PAPER}") } else { String::new() },
                ]
            })
            .collect();
        let head = cells(&[
            "N, all three",
            "assembly [ms]",
            "solve",
            "the paper's march",
            "ratio",
            "assembly and solve",
            "ratio with assembly",
            "the paper's Fig. 8",
        ]);
        part += &format!("\n{}\n", table(&head, &rows));
        // The power of N by which a time grows from 20 functions to 40.
        let growth = |time: &dyn Fn(&Line) -> f64| (sum(40.0, time) / sum(20.0, time)).log2();
        part += &format!(
            "All three with 15 functions: the paper {PAPER} ms, its march with our assembly {} ms, bladefan {} ms. From 20 to \
             40 functions the time grows as N to the power {:.1}, by the march {:.1}.\n\n",
            digits(sum(15.0, &|line| line.assembly + line.march), 2),
            digits(sum(15.0, &|line| line.assembly + line.solve), 2),
            growth(&|line| line.assembly + line.solve),
            growth(&|line| line.assembly + line.march)
        );
    }
    output.part(
        "figure 8",
        format!(
            "{}\n\n[fig-8.csv](paper/fig-8.csv): {}\n",
            part.trim_end(),
            text.lines().next().unwrap_or_default().trim_start_matches("# ")
        ),
    );
}

/// What else `scripts/reproduce-paper --times` recorded.
pub(super) fn speed(root: &Path, output: &mut Output) {
    let record = "docs/paper/speed.txt";
    let text = fs::read_to_string(root.join(record)).unwrap_or_else(|error| panic!("{record}: {error}"));
    output.part("speed", format!("```\n{}\n```\n", text.trim_end()));
}

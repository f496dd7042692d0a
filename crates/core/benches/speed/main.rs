//! Speed of the solver, and of the paper's own algorithm on the same matrices.
//!
//! `cargo bench -p bladefan-core` measures everything and ends with the ratios. With
//! `-- --chart-time` only three times are printed, in milliseconds: of one converged fan chart, of
//! one with the paper's functions, and of one speed with bounds; with `-- --figure-8` the times of
//! the paper's Fig. 8 as CSV, with `-- --ratios` only the ratios.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark prints, and stops on a fault")]

mod converged;
mod coupled;
mod figure_8;
mod march;

use bladefan_core::BasisFamily;
use bladefan_core::Blade;
use bladefan_core::Dof;
use bladefan_core::formats::{Format, read};
use bladefan_core::internals::GaussRules;
use bladefan_core::internals::solve;
use bladefan_core::internals::{Energies, Fields, Grid, SystemMatrices, assemble, classical_functions};
use bladefan_core::library;
use bladefan_core::{ModelKind, Settings, fan, modes};
use core::hint::black_box;
use core::time::Duration;
use criterion::{BenchmarkId, Criterion};
use std::time::Instant;

/// What the paper reports for one speed, all degrees of freedom, five modes each, 15 functions,
/// "on a low-end personal computer" of 2 GHz (its Fig. 8 and the text beside it) [s].
const REPORTED: f64 = 0.6;
/// Modes per degree of freedom.
const MODES: usize = 5;
/// Assumed functions, as many as the paper calls converged.
const FUNCTIONS: usize = 15;

fn built_in(name: &str) -> Blade {
    read(library::find(name).unwrap().toml, Format::Toml).unwrap().blade
}

fn matrices_of(blade: &Blade, dof: Dof, functions: usize) -> SystemMatrices {
    let rules = GaussRules::new();
    let functions = classical_functions(blade, dof, functions);
    let grid = Grid::for_functions(blade, dof, functions.as_ref(), &rules, 0, &[]);
    let fields = Fields::sample(&grid, functions.as_ref());
    assemble(&grid, Energies::new(&grid, &fields), functions.has_rigid_motion())
}

fn matrices(blade: &Blade, functions: usize) -> Vec<SystemMatrices> {
    Dof::ALL.iter().map(|&dof| matrices_of(blade, dof, functions)).collect()
}

/// Frequencies of all degrees of freedom at one speed by this solver.
fn one_speed(matrices: &[SystemMatrices], speed: f64) -> Vec<f64> {
    let of_dof = |matrices| solve(matrices, speed * speed, MODES).unwrap();
    matrices.iter().flat_map(of_dof).map(|mode| mode.frequency).collect()
}

/// The same by the paper's algorithm.
fn one_speed_marched(matrices: &[SystemMatrices], speed: f64) -> Vec<f64> {
    matrices.iter().flat_map(|matrices| march::frequencies(matrices, speed, MODES)).collect()
}

/// The chart of the built-in default: 3 × 5 modes, 0 to 1.2 × nominal, 101 speeds.
fn chart_settings(basis: BasisFamily) -> Settings {
    Settings { modes: MODES, functions: FUNCTIONS, basis, ..Settings::of(ModelKind::Uncoupled) }
}

/// Least time of `runs` runs [s]: the one that other work on the machine disturbed least.
fn best(runs: usize, mut f: impl FnMut()) -> f64 {
    (0..runs).fold(f64::INFINITY, |least, _| {
        let start = Instant::now();
        f();
        least.min(start.elapsed().as_secs_f64())
    })
}

fn chart_time(blade: &Blade, basis: BasisFamily) -> f64 {
    let settings = chart_settings(basis);
    best(101, || drop(black_box(fan(black_box(blade), &settings).unwrap())))
}

/// One speed with bounds and the paper's values beside.
fn modes_time(blade: &Blade) -> f64 {
    let settings = chart_settings(BasisFamily::Piecewise);
    best(101, || drop(black_box(modes(black_box(blade), &settings).unwrap())))
}

fn parts(criterion: &mut Criterion, blade: &Blade) {
    let mut group = criterion.benchmark_group("parts");
    let speed = blade.nominal_speed();
    let assembled = matrices(blade, FUNCTIONS);
    group.bench_function("assembly, 3 degrees of freedom, 15 functions", |b| {
        b.iter(|| matrices(black_box(blade), FUNCTIONS));
    });
    group.bench_function("one speed from assembled matrices", |b| b.iter(|| one_speed(black_box(&assembled), speed)));
    let settings = chart_settings(BasisFamily::Piecewise);
    group.bench_function("one speed with bounds and the paper's values", |b| {
        b.iter(|| modes(black_box(blade), &settings).unwrap());
    });
    group.finish();
}

fn chart(criterion: &mut Criterion, blade: &Blade) {
    let mut group = criterion.benchmark_group("fan chart, 3 x 5 modes, 101 speeds, 15 functions");
    for basis in [BasisFamily::Piecewise, BasisFamily::Classical] {
        let settings = chart_settings(basis);
        group.bench_function(format!("{}, from the checked blade", basis.name()), |b| {
            b.iter(|| fan(black_box(blade), &settings).unwrap());
        });
    }
    let assembled = matrices(blade, FUNCTIONS);
    let speed = blade.nominal_speed();
    group.bench_function("paper's algorithm, one of the 101 speeds", |b| {
        b.iter(|| one_speed_marched(black_box(&assembled), speed));
    });
    group.finish();
}

/// The paper's Fig. 8: a complete analysis (assembly, one speed) against the number of functions.
fn functions(criterion: &mut Criterion, blade: &Blade) {
    let mut group = criterion.benchmark_group("Fig. 8, one speed with assembly");
    let speed = blade.nominal_speed();
    for count in (5..=40).step_by(5) {
        group.bench_with_input(BenchmarkId::new("this solver", count), &count, |b, &count| {
            b.iter(|| one_speed(&matrices(black_box(blade), count), speed));
        });
    }
    group.finish();
}

fn ratios(blade: &Blade) {
    let speed = blade.nominal_speed();
    println!("TM 4760 at 660 rpm, one core, best of several runs; ratios are within this run.");
    let assembled = matrices(blade, FUNCTIONS);
    let worst = one_speed(&assembled, speed)
        .iter()
        .zip(one_speed_marched(&assembled, speed))
        .map(|(ours, theirs)| (ours / theirs - 1.0).abs())
        .fold(0.0, f64::max);
    println!(
        "This solver and the paper's march find the same 15 frequencies; largest relative difference {worst:.1e}."
    );

    let chart = chart_time(blade, BasisFamily::Classical);
    let settings = chart_settings(BasisFamily::Classical);
    let speeds = settings.speeds_or(speed).speeds();
    let marched = best(11, || {
        let assembled = matrices(blade, FUNCTIONS);
        for &speed in &speeds {
            black_box(one_speed_marched(&assembled, speed));
        }
    });
    println!(
        "Fan chart, 3 x 5 modes, 101 speeds, 15 functions: {:.2} ms; by marching {marched:.2} s: ratio {:.0}.",
        1e3 * chart,
        marched / chart
    );
    let one_by_one = best(11, || {
        let assembled = matrices(blade, FUNCTIONS);
        for &speed in &speeds {
            drop(black_box(one_speed(&assembled, speed)));
        }
    });
    println!(
        "The {} dense problems of that chart one by one: {:.2} ms, ratio {:.1}.",
        3 * speeds.len(),
        1e3 * one_by_one,
        one_by_one / chart
    );
    println!(
        "For scale: the paper reports {REPORTED} s for ONE speed (Fig. 8, 2 GHz computer, 2014); our whole chart takes {:.2} % of that.",
        100.0 * chart / REPORTED
    );
}

fn main() {
    if std::env::args().any(|argument| argument == "--figure-8") {
        figure_8::print();
        return;
    }
    let blade = built_in("tm4760");
    if std::env::args().any(|argument| argument == "--ratios") {
        ratios(&blade);
        converged::ratios(&blade);
        return;
    }
    if std::env::args().any(|argument| argument == "--chart-time") {
        for basis in [BasisFamily::Piecewise, BasisFamily::Classical] {
            println!("{:.4}", 1e3 * chart_time(&blade, basis));
        }
        println!("{:.4}", 1e3 * modes_time(&blade));
        return;
    }
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(1200))
        .sample_size(20)
        .configure_from_args();
    parts(&mut criterion, &blade);
    chart(&mut criterion, &blade);
    functions(&mut criterion, &blade);
    for name in ["tm4760", "bo105", "uh60a"] {
        coupled::measure(&mut criterion, name, &built_in(name));
    }
    coupled::floor(&mut criterion);
    coupled::stations(&mut criterion);
    criterion.final_summary();
    // `cargo test` runs each measurement once, as a test, and has no use for ratios.
    if std::env::args().any(|argument| argument == "--bench") {
        figure_8::print();
        ratios(&blade);
        converged::ratios(&blade);
    }
}

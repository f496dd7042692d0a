//! Times of coupled motion: 12 modes of the whole blade.

use crate::converged::many_stations;
use bladefan_core::internals::{ascending_values, lowest_of_plain};
use bladefan_core::{Blade, ModelKind, Settings, coupled_modes, fan};
use core::hint::black_box;
use criterion::{BenchmarkId, Criterion};
use nalgebra::DMatrix;

/// Functions of a chart of 12 modes: those and three more at three speeds.
const FUNCTIONS: usize = 45;
/// Dense problems of a chart: with vectors at its 101 speeds, at the 39 nodes of its branches and at 8 more to check
/// and to begin with; values alone where branches veer and where they meet rays, about four for each.
const WITH_VECTORS: usize = 148;
const VALUES_ALONE: usize = 130;

fn settings() -> Settings {
    Settings::of(ModelKind::Coupled)
}

/// One speed with proven bounds, and the chart of 101 speeds with bounds at each.
pub fn measure(criterion: &mut Criterion, name: &str, blade: &Blade) {
    let settings = settings();
    let mut group = criterion.benchmark_group("coupled");
    group.sample_size(20);
    group.bench_function(BenchmarkId::new("one speed, 12 modes, bounds", name), |bencher| {
        bencher.iter(|| black_box(coupled_modes(black_box(blade), &settings)));
    });
    group.bench_function(BenchmarkId::new("chart, 12 modes × 101 speeds, bounds", name), |bencher| {
        bencher.iter(|| black_box(fan(black_box(blade), &settings)));
    });
    group.finish();
}

/// What no chart can be quicker than with these dense problems: they alone, without their matrices and bounds.
pub fn floor(criterion: &mut Criterion) {
    // Eigenvalues that are spread, and no two alike.
    let matrix = DMatrix::from_fn(FUNCTIONS, FUNCTIONS, |i, j| {
        if i == j { ((i + 1) * (i + 1)) as f64 } else { 20.0 / (1 + i.abs_diff(j)) as f64 }
    });
    criterion.benchmark_group("coupled").sample_size(20).bench_function("floor", |bencher| {
        bencher.iter(|| {
            for _ in 0..WITH_VECTORS {
                black_box(lowest_of_plain(black_box(&matrix).clone(), 15).unwrap());
            }
            for _ in 0..VALUES_ALONE {
                black_box(ascending_values(black_box(&matrix).clone()).unwrap());
            }
        });
    });
}

/// Time against the number of stations: no more than in proportion.
pub fn stations(criterion: &mut Criterion) {
    let settings = settings();
    let mut group = criterion.benchmark_group("coupled stations");
    group.sample_size(10);
    for stations in [30, 100, 300] {
        let blade = many_stations(stations);
        group.bench_function(BenchmarkId::new("one speed", stations), |bencher| {
            bencher.iter(|| black_box(coupled_modes(black_box(&blade), &settings)));
        });
        group.bench_function(BenchmarkId::new("chart", stations), |bencher| {
            bencher.iter(|| black_box(fan(black_box(&blade), &settings)));
        });
    }
    group.finish();
}

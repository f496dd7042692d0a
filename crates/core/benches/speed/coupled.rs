//! Times of coupled motion: 12 modes of the whole blade.

use bladefan_core::{Blade, ModelKind, Settings, coupled_modes, fan};
use core::hint::black_box;
use criterion::{BenchmarkId, Criterion};

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

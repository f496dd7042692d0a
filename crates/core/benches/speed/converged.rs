//! What the converged answer costs: one chart, one speed with bounds, many stations.

use crate::{MODES, best, chart_settings, chart_time, modes_time};
use bladefan_core::BasisFamily;
use bladefan_core::Blade;
use bladefan_core::Dof;
use bladefan_core::formats::{Format, read};
use bladefan_core::internals::GaussRules;
use bladefan_core::internals::{Converged, Wanted, Work};
use bladefan_core::{ModelKind, Settings, fan, modes};
use core::fmt::Write;
use core::hint::black_box;

/// A blade with `stations` stations on which every property changes.
pub(crate) fn many_stations(stations: usize) -> Blade {
    let list = |f: &dyn Fn(f64) -> f64| {
        let mut text = String::from("[");
        for i in 0..stations {
            let x = i as f64 / (stations - 1) as f64;
            write!(text, "{},", f(x)).unwrap();
        }
        text + "]"
    };
    // A taper with a swell: no two neighbours alike, the same blade for every number of stations.
    let swell = |x: f64| 1.0 - 0.5 * x + 0.8 * x * (1.0 - x) * (0.6 - x);
    let text = format!(
        "schema = \"bladefan-blade/1\"\nname = \"many stations\"\n[rotor]\nradius = 5.0\nnominal_speed = 40.0\n\
         [flap]\nroot = \"hinged\"\noffset = 0.2\n[lag]\nroot = \"hinged\"\noffset = 0.2\n[torsion]\nroot = \"rigid\"\noffset = 0.2\n\
         [distribution]\nr = {}\nmass = {}\nflap_stiffness = {}\nlag_stiffness = {}\ntorsion_stiffness = {}\npolar_inertia = {}\n",
        list(&|x| 0.2 + 4.8 * x),
        list(&|x| 6.0 * swell(x)),
        list(&|x| 1.5e4 * swell(x)),
        list(&|x| 3e5 * swell(x)),
        list(&|x| 1e4 * swell(x)),
        list(&|x| 0.03 * swell(x)),
    );
    read(&text, Format::Toml).unwrap().blade
}

/// Prints the times and ratios of the converged answer.
pub(crate) fn ratios(blade: &Blade) {
    println!("Converged, 3 x {MODES} modes:");
    let chart = chart_time(blade, BasisFamily::Piecewise);
    let speeds = chart_settings(BasisFamily::Piecewise).speeds_or(blade.nominal_speed()).speeds();
    let rules = GaussRules::new();
    let one_by_one = best(3, || {
        for dof in Dof::ALL {
            for speed in &speeds {
                let square = speed * speed;
                drop(black_box(
                    Converged::new(blade, dof, &Wanted::at(square, MODES), &rules, &Work::default()).unwrap(),
                ));
            }
        }
    });
    println!(
        "Fan chart, 101 speeds: {:.2} ms; each of the {} problems from the start: {:.1} ms, ratio {:.0}.",
        1e3 * chart,
        3 * speeds.len(),
        1e3 * one_by_one,
        one_by_one / chart
    );
    println!("One speed with bounds and the paper's values beside: {:.2} ms.", 1e3 * modes_time(blade));
    let settings = Settings { modes: MODES, ..Settings::of(ModelKind::Uncoupled) };
    let time = |stations: usize| {
        let blade = many_stations(stations);
        (
            best(21, || drop(black_box(fan(&blade, &settings).unwrap()))),
            best(21, || drop(black_box(modes(&blade, &settings).unwrap()))),
        )
    };
    let (few, many) = (time(30), time(200));
    println!(
        "A blade with 200 stations against one with 30: chart {:.2} and {:.2} ms, ratio {:.1}; one speed {:.2} and {:.2} ms, ratio {:.1}.",
        1e3 * many.0,
        1e3 * few.0,
        many.0 / few.0,
        1e3 * many.1,
        1e3 * few.1,
        many.1 / few.1
    );
}

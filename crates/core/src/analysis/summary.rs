//! Mass, inertia and static moments.

use super::{Model, warnings};
use crate::blade::{Blade, PointMass, Property, RootCondition, moments};
use crate::dof::Dof;
use crate::report::{BladeSummary, DofSummary};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Mass, inertia and static moments of a blade.
pub fn summary(blade: &Blade) -> BladeSummary {
    let dofs = blade.dofs().iter().map(|&dof| {
        let root = blade.root(dof);
        let [mass, first, second] = moments(blade.mass(), root.offset, blade.radius());
        let torsion = dof == Dof::Torsion;
        let [polar, _, _] = moments(blade.polar_inertia(), root.offset, blade.radius());
        // Those that act in this degree of freedom.
        let masses = blade.point_masses().iter().filter(|mass| mass.r > root.offset);
        let sum = |of: &dyn Fn(&PointMass) -> f64| masses.clone().map(of).sum::<f64>();
        let (mass, polar) = (mass + sum(&|m| m.mass), polar + sum(&|m| m.flap_inertia + m.lag_inertia));
        let first = first + sum(&|m| m.mass * (m.r - root.offset));
        let second = second + sum(&|m| m.mass * (m.r - root.offset) * (m.r - root.offset));
        DofSummary {
            dof,
            root: match (root.condition, torsion) {
                (RootCondition::Clamped, false) => "hingeless",
                (RootCondition::Free, false) => "hinged",
                (RootCondition::Spring(_), false) => "spring-hinged",
                (RootCondition::Clamped, true) => "rigid",
                (RootCondition::Free, true) => "free",
                (RootCondition::Spring(_), true) => "spring",
            },
            offset_m: root.offset,
            spring_n_m: match root.condition {
                RootCondition::Spring(spring) => Some(spring),
                RootCondition::Clamped | RootCondition::Free => None,
            },
            mass_kg: mass,
            static_moment_kg_m: (!torsion).then_some(first),
            inertia_kg_m2: if torsion { polar } else { second },
        }
    });
    let used = Property::ALL.into_iter().filter(|property| Model::UNCOUPLED.uses(*property));
    let stations = used.flat_map(|property| blade.property(property).stations().iter().copied());
    let mut stations: Vec<f64> = stations.collect();
    stations.sort_by(f64::total_cmp);
    stations.dedup();
    BladeSummary {
        schema: "bladefan-check/1",
        blade: blade.name().to_string(),
        radius_m: blade.radius(),
        nominal_speed_rad_s: blade.nominal_speed(),
        blades: blade.blades(),
        stations: stations.len(),
        dofs: dofs.collect(),
        warnings: warnings(blade),
    }
}

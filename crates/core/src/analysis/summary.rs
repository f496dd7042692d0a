//! Mass, inertia and static moments.

use super::{Model, warnings};
use crate::blade::{Blade, Property, RootCondition, moments};
use crate::dof::Dof;
use crate::order::ascending;
use crate::report::{BladeSummary, DofSummary};
use alloc::string::ToString;
use alloc::vec::Vec;

/// Mass, inertia and static moments of a blade.
pub fn summary(blade: &Blade) -> BladeSummary {
    let dofs = Dof::ALL.into_iter().map(|dof| {
        let root = blade.root(dof);
        let [mass, first, second] = moments(blade.mass(), root.offset, blade.radius());
        let torsion = dof == Dof::Torsion;
        let [polar, _, _] = moments(blade.polar_inertia(), root.offset, blade.radius());
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
    let stations: Vec<f64> = used.flat_map(|property| blade.property(property).stations().iter().copied()).collect();
    let mut stations = ascending(&stations);
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

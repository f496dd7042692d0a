//! A blade section: every property at one radius, which is what the weight of a term sees.

use super::model::{Blade, PointMass};
use super::tension::tension_inside;
use crate::dof::Dof;
use crate::numerics::{Linear, PiecewiseLinear};
use alloc::vec::Vec;

/// All properties of a blade at one radius, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Radius r [m].
    pub r: f64,
    /// Mass per length m [kg/m].
    pub mass: f64,
    /// Bending and torsional stiffness by degree of freedom: `EI_flap`, `EI_lag`, GJ [N·m²].
    pub stiffness: [f64; 3],
    /// Polar mass moment of inertia per length ρI_p [kg·m].
    pub polar_inertia: f64,
    /// I₂ − I₁ about the elastic axis, in and out of the chord plane [kg·m].
    pub racket: f64,
    /// Mass centre ahead of the elastic axis Y [m].
    pub mass_offset: f64,
    /// Tension per Ω², T = ∫ m ρ dρ from r to R, with the point masses there [kg·m].
    pub tension: f64,
}

impl Section {
    /// A point mass as a section without stiffness and tension: its terms are those of a section, with mass [kg]
    /// and inertia [kg·m²] in place of those per length.
    pub fn of(mass: &PointMass) -> Self {
        Self {
            r: mass.r,
            mass: mass.mass,
            stiffness: [0.0; 3],
            polar_inertia: mass.flap_inertia + mass.lag_inertia,
            racket: mass.lag_inertia - mass.flap_inertia,
            mass_offset: mass.offset,
            tension: 0.0,
        }
    }
}

/// A part of the span within which every property is linear.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Inner end [m].
    pub from: f64,
    /// Outer end [m].
    pub to: f64,
    mass: Linear,
    stiffness: [Linear; 3],
    polar_inertia: Linear,
    inertias: [Linear; 2],
    mass_offset: Linear,
    /// The mass between the stretch's own ends, which its tension is summed from.
    own_mass: Linear,
    /// Tension per Ω² at the outer end [kg·m].
    outboard: f64,
}

/// Where a stretch lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Its ends [m].
    pub ends: (f64, f64),
    /// Ends of the segment between stations that it is a part of, from whose limits every property is
    /// interpolated.
    pub segment: (f64, f64),
}

impl Place {
    /// A whole segment.
    pub const fn whole(from: f64, to: f64) -> Self {
        Self { ends: (from, to), segment: (from, to) }
    }
}

impl Stretch {
    fn new(blade: &Blade, place: Place, outboard: f64) -> Self {
        let linear = |property: &PiecewiseLinear| property.between(place.segment.0, place.segment.1);
        let (from, to) = place.ends;
        Self {
            from,
            to,
            own_mass: blade.mass().between(from, to),
            mass: linear(blade.mass()),
            stiffness: Dof::ALL.map(|dof| linear(blade.stiffness(dof))),
            polar_inertia: linear(blade.polar_inertia()),
            inertias: blade.inertias().map(linear),
            mass_offset: linear(blade.mass_offset()),
            outboard,
        }
    }

    /// The section at `r` inside the stretch, from the limits of every property at both ends. The
    /// tension is summed from the stretch's own outer end: a difference of primitives in r would
    /// lose (r/length)² of its digits on a short stretch.
    pub fn section(&self, r: f64) -> Section {
        Section {
            r,
            mass: self.mass.at(r),
            stiffness: self.stiffness.map(|stiffness| stiffness.at(r)),
            polar_inertia: self.polar_inertia.at(r),
            racket: self.inertias[1].at(r) - self.inertias[0].at(r),
            mass_offset: self.mass_offset.at(r),
            tension: self.outboard + tension_inside(self.own_mass.at(r), self.own_mass.at(self.to), r, self.to),
        }
    }

    /// Tension per Ω² at the inner end [kg·m].
    fn inboard(&self) -> f64 {
        let (inner, outer) = (self.own_mass.at(self.from), self.own_mass.at(self.to));
        self.outboard + tension_inside(inner, outer, self.from, self.to)
    }
}

/// The stretches at `places`, from the root to the tip without gaps; none may straddle a station or a point mass.
pub fn stretches(blade: &Blade, places: &[Place]) -> Vec<Stretch> {
    // A point mass pulls at all that lies inboard of it.
    let hung = |from: f64, to: f64| -> f64 {
        let hung = blade.point_masses().iter().filter(|mass| mass.r >= from && mass.r < to);
        hung.map(|mass| mass.mass * mass.r).sum()
    };
    let mut outboard = places.last().map_or(0.0, |last| hung(last.ends.1, f64::INFINITY));
    let mut found: Vec<Stretch> = places
        .iter()
        .rev()
        .map(|&place| {
            let stretch = Stretch::new(blade, place, outboard);
            outboard = stretch.inboard() + hung(place.ends.0, place.ends.1);
            stretch
        })
        .collect();
    found.reverse();
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::{BladeDefinition, Property, RootDefinition, check};

    /// m = 2 up to r = 1, then 3 − r up to 2.
    fn tapered() -> Blade {
        let blade = BladeDefinition::new("tapered", 2.0, 1.0)
            .with_flap(RootDefinition::hingeless(0.0))
            .with_lag(RootDefinition::hingeless(0.0))
            .with_torsion(RootDefinition::rigid(0.0))
            .with(Property::Mass, [(0.0, 2.0), (1.0, 2.0), (1.0, 2.0), (2.0, 1.0)])
            .with(Property::FlapStiffness, 1.0)
            .with(Property::LagStiffness, 1.0)
            .with(Property::TorsionStiffness, 1.0)
            .with(Property::PolarInertia, 1.0)
            .with(Property::MassOffset, [(0.0, 0.0), (2.0, 0.2)]);
        check(&blade).unwrap()
    }

    #[test]
    fn tension_of_a_stepped_tapered_mass_is_exact() {
        // T(1) = ∫(3r − r²) from 1 to 2 = 4.5 − 7/3, T(0) = T(1) + 1.
        let blade = tapered();
        let found = stretches(
            &blade,
            &[Place::whole(0.0, 1.0), Place { ends: (1.0, 1.5), segment: (1.0, 2.0) }, Place::whole(1.5, 2.0)],
        );
        let outer = 4.5 - 7.0 / 3.0;
        let exact = 1.5 * (4.0 - 2.25) - (8.0 - 3.375) / 3.0;
        for (stretch, r, tension) in
            [(0, 1.0, outer), (1, 1.0, outer), (0, 0.0, outer + 1.0), (1, 1.5, exact), (2, 1.5, exact), (2, 2.0, 0.0)]
        {
            let section = found[stretch].section(r);
            assert!((section.tension - tension).abs() < 1e-15, "{r}: {} {tension}", section.tension);
        }
    }

    /// A point mass pulls at what lies inboard of it, and not at itself.
    #[test]
    fn tension_steps_at_point_masses() {
        let mut blade = tapered();
        let mass = |r: f64, mass: f64| PointMass { r, mass, offset: 0.0, flap_inertia: 0.0, lag_inertia: 0.0 };
        let places = [Place::whole(0.0, 1.0), Place::whole(1.0, 2.0)];
        let at = |blade: &Blade| {
            let found = stretches(blade, &places);
            [(0, 0.0), (0, 1.0), (1, 1.0), (1, 2.0)].map(|(i, r): (usize, f64)| found[i].section(r).tension)
        };
        let bare = at(&blade);
        blade.point_masses = alloc::vec![mass(1.0, 3.0), mass(2.0, 0.5)];
        assert_eq!(at(&blade), [bare[0] + 4.0, bare[1] + 4.0, bare[2] + 1.0, 1.0]);
    }

    #[test]
    fn a_section_has_the_limits_of_its_own_stretch() {
        let found = stretches(&tapered(), &[Place::whole(0.0, 1.0), Place::whole(1.0, 2.0)]);
        assert_eq!(found[0].section(1.0).mass, 2.0);
        assert_eq!(found[1].section(1.5).mass, 1.5);
        assert!((found[1].section(1.5).mass_offset - 0.15).abs() < 1e-16);
        assert_eq!(found[1].section(1.5).stiffness, [1.0; 3]);
    }
}

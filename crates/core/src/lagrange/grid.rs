//! Quadrature points along the span, with the weights of a system's terms there.

use super::segments::{segments, taper_cuts};
use super::terms::{Energy, Field, Quantity, System};
use super::uncoupled;
use crate::blade::{Blade, Place, RootCondition, Section, stretches};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, Deformation};
use crate::numerics::quadrature::GaussRules;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// A panel: a part of the span with one Gauss rule, inside which every property is linear.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Inner end [m].
    pub from: f64,
    /// Outer end [m].
    pub to: f64,
    /// Its points among all of the grid.
    pub points: Range<usize>,
    /// The point of the point masses at its outer end, where there are any.
    pub lump: Option<usize>,
}

impl Panel {
    /// Half the length: dr/dξ of the rule on [−1, 1] [m].
    pub fn half(&self) -> f64 {
        0.5 * (self.to - self.from)
    }
}

/// Quadrature points of a system of one degree of freedom from root to tip. Flap, lag and torsion
/// have one form here: the potential energy is ½ ∫ D e² dr + ½ Ω² ∫ P t² dr and the kinetic one
/// ½ ω² ∫ J u² dr with
///
/// | | displacement u | rotation t | strain e | D | P | J |
/// |---|---|---|---|---|---|---|
/// | bending | w | w′ | w″ | EI | T | m |
/// | torsion | φ | φ | φ′ | GJ | m Y² | ρI_p |
///
/// so that the rotation is the integral of the strain in both. A centrifugal term on the
/// displacement shifts every eigenvalue and no shape ([`System::shift`]).
///
/// Point masses have a point of their own at the outer end of a panel, of weight 1 and without strain: what is per
/// length elsewhere is there the whole.
#[derive(Clone, Debug)]
pub struct Grid {
    system: System,
    root: f64,
    condition: RootCondition,
    panels: Vec<Panel>,
    radius: Vec<f64>,
    weight: Vec<f64>,
    length: Vec<f64>,
    inertia: Vec<f64>,
    elastic: Vec<f64>,
    centrifugal: Vec<f64>,
}

impl Grid {
    /// For assumed functions: points enough to integrate any product of two of them times a
    /// cubic. With `more` points in each panel, and panels cut where the stiffness tapers, such
    /// products may also be divided by the stiffness. Panels end at the radii `ends`, too.
    pub fn for_functions(
        blade: &Blade,
        dof: Dof,
        functions: &dyn AssumedFunctions,
        rules: &GaussRules,
        more: usize,
        ends: &[f64],
    ) -> Self {
        let root = blade.root(dof).offset;
        let mut extra: Vec<f64> = functions.joints().iter().map(|x| root + x).chain(ends.iter().copied()).collect();
        if more > 0 {
            extra.extend(taper_cuts(blade, dof));
        }
        let mut panels = Vec::new();
        for segment in segments(blade, dof, &extra) {
            let whole = (segment.from, segment.to);
            segment.panels(functions, rules, |from, to, rule| {
                panels.push((Place { ends: (from, to), segment: whole }, rule.len() + more));
            });
        }
        Self::for_panels(blade, dof, panels.into_iter(), rules)
    }

    /// With given panels and their numbers of points, ascending from root to tip; none may straddle a
    /// station or a point mass.
    pub fn for_panels(
        blade: &Blade,
        dof: Dof,
        panels: impl Iterator<Item = (Place, usize)>,
        rules: &GaussRules,
    ) -> Self {
        let root = blade.root(dof);
        let mut grid = Self {
            system: uncoupled::system(blade, dof),
            root: root.offset,
            condition: root.condition,
            panels: Vec::new(),
            radius: Vec::new(),
            weight: Vec::new(),
            length: Vec::new(),
            inertia: Vec::new(),
            elastic: Vec::new(),
            centrifugal: Vec::new(),
        };
        let (places, points): (Vec<Place>, Vec<usize>) = panels.unzip();
        let weight = |energy, quantity| grid.system.weight(energy, Field { dof, quantity });
        let inertia = weight(Energy::Inertia, Quantity::Displacement);
        let elastic = weight(Energy::Elastic, Quantity::Strain);
        let centrifugal = weight(Energy::Centrifugal, Quantity::Rotation);
        for (stretch, points) in stretches(blade, &places).iter().zip(points) {
            let (from, to) = (stretch.from, stretch.to);
            let first = grid.radius.len();
            let (half, middle) = (0.5 * (to - from), 0.5 * (from + to));
            for &(node, weight) in rules.with_points(points) {
                let section = stretch.section(middle + half * node);
                grid.radius.push(section.r);
                grid.weight.push(half * weight);
                grid.length.push(half * weight);
                grid.elastic.push(elastic(&section));
                grid.centrifugal.push(centrifugal(&section));
                grid.inertia.push(inertia(&section));
            }
            let points = first..grid.radius.len();
            let hung = blade.point_masses().iter().filter(|mass| mass.r > from && mass.r <= to);
            let hung: Vec<Section> = hung.map(Section::of).collect();
            let lump = (!hung.is_empty()).then_some(points.end);
            if lump.is_some() {
                grid.radius.push(to);
                grid.weight.push(1.0);
                grid.length.push(0.0);
                grid.elastic.push(1.0);
                grid.centrifugal.push(hung.iter().map(centrifugal).sum());
                grid.inertia.push(hung.iter().map(inertia).sum());
            }
            grid.panels.push(Panel { from, to, points, lump });
        }
        grid
    }

    /// The system of the blade that the points serve.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// How its displacement follows from its strain.
    pub fn deformation(&self) -> Deformation {
        Deformation::of(self.system.dofs[0])
    }

    /// Radius of the root [m].
    pub fn root(&self) -> f64 {
        self.root
    }

    /// How the root is held.
    pub fn condition(&self) -> RootCondition {
        self.condition
    }

    /// The panels, root to tip.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// Number of points, which is not 0.
    #[allow(clippy::len_without_is_empty, reason = "a blade has a span")]
    pub fn len(&self) -> usize {
        self.radius.len()
    }

    /// Radii of the points [m].
    pub fn radius(&self) -> &[f64] {
        &self.radius
    }

    /// Distance of each point from the root [m].
    pub fn x(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        self.radius.iter().map(|r| r - self.root)
    }

    /// The displacement of a unit rigid rotation about the root: x in bending, 1 in torsion.
    pub fn rigid_displacement(&self) -> Vec<f64> {
        match self.deformation() {
            Deformation::Torsion => vec![1.0; self.len()],
            Deformation::Bending => self.x().collect(),
        }
    }

    /// Quadrature weights [m]; 1 for point masses.
    pub fn weight(&self) -> &[f64] {
        &self.weight
    }

    /// Quadrature weights of integrals along the span [m]; 0 for point masses.
    pub fn length(&self) -> &[f64] {
        &self.length
    }

    /// The points of point masses.
    pub fn lumps(&self) -> impl Iterator<Item = usize> + '_ {
        self.panels.iter().filter_map(|panel| panel.lump)
    }

    /// J: m [kg/m] or ρI_p [kg·m]; of point masses [kg] or [kg·m²].
    pub fn inertia(&self) -> &[f64] {
        &self.inertia
    }

    /// D: EI or GJ [N·m²]; of no account for point masses, which have no strain.
    pub fn elastic(&self) -> &[f64] {
        &self.elastic
    }

    /// P: T or m Y² [kg·m]; of point masses 0 or [kg·m²].
    pub fn centrifugal(&self) -> &[f64] {
        &self.centrifugal
    }

    /// Weights times a property.
    pub fn weighted<'a>(&'a self, property: &'a [f64]) -> impl ExactSizeIterator<Item = f64> + 'a {
        self.weight.iter().zip(property).map(|(weight, value)| weight * value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blade::Section;
    use crate::lagrange::classical_functions;
    use crate::lagrange::tests::tapered;

    fn whole(dof: Dof) -> Grid {
        let panels = [(0.5, 1.0), (1.0, 2.0)].into_iter().map(|(from, to)| (Place::whole(from, to), 4));
        Grid::for_panels(&tapered(), dof, panels, &GaussRules::new())
    }

    /// The blade has 2 kg and 2 kg·m about the hub; both are sums of eight terms of size 1, so of a
    /// few roundings.
    #[test]
    fn points_integrate_the_mass_exactly() {
        let grid = whole(Dof::Flap);
        let mass: f64 = grid.weighted(grid.inertia()).sum();
        let moment: f64 = grid.weighted(grid.inertia()).zip(grid.radius()).map(|(m, r)| m * r).sum();
        assert!((mass - 2.0).abs() < 2e-15, "{mass}");
        assert!((moment - 2.0).abs() < 2e-15, "{moment}");
    }

    /// ∫ m ρ dρ from r to the tip of the two linear parts, by hand.
    fn tension(r: f64) -> f64 {
        if r > 1.0 {
            0.75 * (4.0 - r * r) - (8.0 - r.powi(3)) / 6.0
        } else {
            13.0 / 12.0 + 2.0 * (1.0 - r * r) - (1.0 - r.powi(3)) * 2.0 / 3.0
        }
    }

    /// Of numbers of size up to 100 and of a tension that is a difference of numbers of size 3.
    #[test]
    fn weights_at_the_points_are_those_of_the_table() {
        let blade = tapered();
        for dof in Dof::ALL {
            let grid = whole(dof);
            for (k, &r) in grid.radius().iter().enumerate() {
                let section = Section {
                    r,
                    mass: blade.mass().at(r),
                    stiffness: Dof::ALL.map(|dof| blade.stiffness(dof).at(r)),
                    polar_inertia: blade.polar_inertia().at(r),
                    racket: blade.polar_inertia().at(r),
                    mass_offset: blade.mass_offset().at(r),
                    tension: tension(r),
                };
                for (energy, quantity, found) in [
                    (Energy::Inertia, Quantity::Displacement, grid.inertia()[k]),
                    (Energy::Elastic, Quantity::Strain, grid.elastic()[k]),
                    (Energy::Centrifugal, Quantity::Rotation, grid.centrifugal()[k]),
                ] {
                    let known = uncoupled::system(&blade, dof).weight(energy, Field { dof, quantity })(&section);
                    assert!((found - known).abs() < 1e-15 * (1.0 + 10.0 * known), "{dof} at {r}: {found} {known}");
                }
            }
        }
    }

    #[test]
    fn panels_end_at_stations_and_at_asked_radii() {
        let (blade, rules) = (tapered(), GaussRules::new());
        for dof in Dof::ALL {
            let functions = classical_functions(&blade, dof, 9);
            let grid = Grid::for_functions(&blade, dof, functions.as_ref(), &rules, 2, &[0.7, 1.3, 5.0, 0.1]);
            let panels = grid.panels();
            let ends: Vec<f64> = panels.iter().map(|panel| panel.to).collect();
            assert_eq!((panels[0].from, *ends.last().unwrap()), (0.5, 2.0), "from root to tip");
            assert!(panels.windows(2).all(|pair| pair[0].to == pair[1].from), "{dof}: a gap");
            for asked in [0.7, 1.0, 1.3] {
                assert!(ends.contains(&asked), "{dof}: no panel ends at {asked}");
            }
            for panel in panels {
                assert!(grid.radius()[panel.points.clone()].iter().all(|r| *r > panel.from && *r < panel.to));
            }
            // Fifteen weights or more to a panel of less than 1 m.
            assert!((grid.weight().iter().sum::<f64>() - 1.5).abs() < 1e-14, "{dof}: the span");
        }
    }

    #[test]
    fn a_rigid_rotation_displaces_by_its_lever() {
        assert!(whole(Dof::Torsion).rigid_displacement().iter().all(|u| *u == 1.0));
        let grid = whole(Dof::Lag);
        assert!(grid.rigid_displacement().iter().zip(grid.radius()).all(|(u, r)| *u == r - 0.5));
    }
}

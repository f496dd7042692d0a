//! Mass, elastic, spring and centrifugal matrices (paper Eq. 42–47, 75–77), once per blade.

use super::panels::segments;
use crate::blade::{Blade, RootCondition, Tension};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, BendingRoot, ClassicalBending, ClassicalTorsion, Sample, TorsionRoot};
use crate::numerics::quadrature::GaussRules;
use alloc::boxed::Box;
use alloc::vec;
use nalgebra::DMatrix;

/// The matrices of one degree of freedom; (K + F + Ω² C − ω² M) q = 0 (Eq. 79–80). All symmetric,
/// n × n for n assumed functions.
#[derive(Clone, Debug)]
pub struct SystemMatrices {
    dof: Dof,
    mass: DMatrix<f64>,
    stiffness: DMatrix<f64>,
    centrifugal: DMatrix<f64>,
    rigid: bool,
}

impl SystemMatrices {
    /// The degree of freedom.
    pub fn dof(&self) -> Dof {
        self.dof
    }

    /// Number of assumed functions n.
    pub fn count(&self) -> usize {
        self.mass.nrows()
    }

    /// M, ∫ m φ φ dr [kg] or ∫ ρI_p φ φ dr [kg·m²] (Eq. 42, 45).
    pub fn mass(&self) -> &DMatrix<f64> {
        &self.mass
    }

    /// K + F: strain energy of the blade, ∫ EI φ″ φ″ dr or ∫ GJ φ′ φ′ dr (Eq. 43, 46), and of the
    /// root spring, K_s φ′ φ′ or K_s φ φ at the root (Eq. 44, 47).
    pub fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// C per Ω²: flap ∫ T φ′ φ′ dr, lag the same less M, torsion ∫ m Y² φ φ dr (Eq. 75–77).
    pub fn centrifugal(&self) -> &DMatrix<f64> {
        &self.centrifugal
    }

    /// Whether the first function is a rigid motion without strain energy: a free root.
    pub fn has_rigid_motion(&self) -> bool {
        self.rigid
    }

    /// The matrices of the first `count` functions alone.
    #[must_use]
    pub fn leading(&self, count: usize) -> Self {
        let n = count.min(self.count());
        let lead = |matrix: &DMatrix<f64>| matrix.view((0, 0), (n, n)).into_owned();
        Self {
            dof: self.dof,
            mass: lead(&self.mass),
            stiffness: lead(&self.stiffness),
            centrifugal: lead(&self.centrifugal),
            rigid: self.rigid,
        }
    }
}

/// The paper's assumed functions for one degree of freedom of a blade: `count` modes of the
/// uniform, non-rotating blade with the properties at mid-span (Eq. 17–28).
pub fn classical_functions(blade: &Blade, dof: Dof, count: usize) -> Box<dyn AssumedFunctions> {
    let root = blade.root(dof);
    let length = blade.radius() - root.offset;
    let middle = root.offset + 0.5 * length;
    let stiffness = blade.stiffness(dof).at(middle);
    if dof == Dof::Torsion {
        let condition = match root.condition {
            RootCondition::Clamped => TorsionRoot::Clamped,
            RootCondition::Free => TorsionRoot::Free,
            RootCondition::Spring(spring) => TorsionRoot::Spring(spring * length / stiffness),
        };
        return Box::new(ClassicalTorsion::new(condition, count, length));
    }
    let condition = match root.condition {
        RootCondition::Clamped => BendingRoot::Clamped,
        RootCondition::Free => BendingRoot::Free,
        RootCondition::Spring(spring) => BendingRoot::Spring(spring * length / stiffness),
    };
    Box::new(ClassicalBending::new(condition, count, length, blade.mass().at(middle)))
}

/// Assembles the matrices of one degree of freedom.
pub fn assemble(blade: &Blade, dof: Dof, functions: &dyn AssumedFunctions) -> SystemMatrices {
    let n = functions.count();
    let mut mass = DMatrix::zeros(n, n);
    let mut stiffness = DMatrix::zeros(n, n);
    let mut centrifugal = DMatrix::zeros(n, n);
    let rules = GaussRules::new();
    let root = blade.root(dof).offset;
    let tension = Tension::new(blade.mass(), root, blade.radius());
    let mut samples = vec![Sample::default(); n];
    let mut rigid_row = vec![0.0; n];
    for segment in segments(blade, dof, &[]) {
        let of_mass = segment.linear(blade.mass());
        let of_stiffness = segment.linear(blade.stiffness(dof));
        let inertia = segment.linear(blade.polar_inertia());
        let offset = segment.linear(blade.mass_offset());
        segment.panels(functions.wave_number(), |a, b, phase| {
            rules.each_point(a, b, phase, |r, weight| {
                functions.sample(r - root, &mut samples);
                let (m, s) = (weight * of_mass.at(r), weight * of_stiffness.at(r));
                if dof == Dof::Torsion {
                    let y = offset.at(r);
                    add(&mut mass, &samples, weight * inertia.at(r), |f| f.value);
                    add(&mut stiffness, &samples, s, |f| f.slope);
                    add(&mut centrifugal, &samples, m * y * y, |f| f.value);
                } else {
                    add(&mut mass, &samples, m, |f| f.value);
                    add(&mut stiffness, &samples, s, |f| f.curvature);
                    add(&mut centrifugal, &samples, weight * tension.at(r), |f| f.slope);
                    for (row, f) in rigid_row.iter_mut().zip(&samples) {
                        *row += m * f.value;
                    }
                }
            });
        });
    }
    if dof == Dof::Lag {
        centrifugal -= &mass;
        if functions.has_rigid_motion() {
            // φ₁ = s x: the tension's work is ∫ T s φ_j′ dr = s ∫ m r φ_j dr (by parts), the mass's
            // s ∫ m x φ_j dr; the difference is exactly the offset times s ∫ m φ_j dr. Written so
            // nothing cancels, and a central hinge is exactly free at every speed.
            functions.sample(0.0, &mut samples);
            let slope = samples.first().map_or(0.0, |f| f.slope);
            for (j, row) in rigid_row.iter().enumerate() {
                centrifugal[(j, 0)] = root * slope * row;
            }
        }
    }
    if let RootCondition::Spring(spring) = blade.root(dof).condition {
        functions.sample(0.0, &mut samples);
        add(&mut stiffness, &samples, spring, |f| if dof == Dof::Torsion { f.value } else { f.slope });
    }
    for matrix in [&mut mass, &mut stiffness, &mut centrifugal] {
        matrix.fill_upper_triangle_with_lower_triangle();
    }
    SystemMatrices { dof, mass, stiffness, centrifugal, rigid: functions.has_rigid_motion() }
}

/// (2/l) ∫ φ φ dr (n × n) of torsion: a mode with qᵀ N q = 1 has ∫ X² dr = l/2 (Eq. 87).
pub fn torsion_norm(blade: &Blade, functions: &dyn AssumedFunctions) -> DMatrix<f64> {
    let n = functions.count();
    let rules = GaussRules::new();
    let root = blade.root(Dof::Torsion).offset;
    let per_half_length = 2.0 / (blade.radius() - root);
    let mut samples = vec![Sample::default(); n];
    let mut norm = DMatrix::zeros(n, n);
    for segment in segments(blade, Dof::Torsion, &[]) {
        segment.panels(functions.wave_number(), |a, b, phase| {
            rules.each_point(a, b, phase, |r, weight| {
                functions.sample(r - root, &mut samples);
                add(&mut norm, &samples, per_half_length * weight, |f| f.value);
            });
        });
    }
    norm.fill_upper_triangle_with_lower_triangle();
    norm
}

/// Adds weight · f_i f_j to the lower triangle.
fn add(matrix: &mut DMatrix<f64>, samples: &[Sample], weight: f64, part: impl Fn(&Sample) -> f64) {
    if weight == 0.0 {
        return;
    }
    for (j, column) in matrix.as_mut_slice().chunks_exact_mut(samples.len()).enumerate() {
        let factor = weight * part(&samples[j]);
        for (entry, sample) in column[j..].iter_mut().zip(&samples[j..]) {
            *entry += factor * part(sample);
        }
    }
}

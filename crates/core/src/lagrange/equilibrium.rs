//! Shapes and internal moments along the span, prepared so that a mode is only a weighted sum.

use super::panels::segments;
use crate::blade::{Blade, Tension};
use crate::dof::Dof;
use crate::functions::{AssumedFunctions, Sample};
use crate::numerics::quadrature::{GaussRules, each_point};
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// What every assumed function does at sampled radii. A mode Σ q_i φ_i with frequency ω at speed Ω
/// has, row for row, displacement = value · q, slope = slope · q, and the moment that keeps its
/// inertia and centrifugal forces in equilibrium,
/// (ω² · inertial − Ω² · centrifugal) q with the free tip as the start (docs/THEORY.md). That is
/// the moment to use: EI X″ and GJ θ′ of smooth functions jump where the stiffness steps.
#[derive(Clone, Debug)]
pub struct ShapeTables {
    /// Radii [m], ascending, p of them.
    pub radii: Vec<f64>,
    /// φ (p × n); 0 inboard of the root.
    pub value: DMatrix<f64>,
    /// φ′ (p × n) [1/m].
    pub slope: DMatrix<f64>,
    /// Moment per ω² (p × n).
    pub inertial: DMatrix<f64>,
    /// Moment per Ω², to be subtracted (p × n).
    pub centrifugal: DMatrix<f64>,
}

/// Tabulates the functions of one degree of freedom at ascending `radii` [m].
pub fn tabulate(
    blade: &Blade,
    dof: Dof,
    functions: &dyn AssumedFunctions,
    radii: &[f64],
    rules: &GaussRules,
) -> ShapeTables {
    let (n, p) = (functions.count(), radii.len());
    let root = blade.root(dof).offset;
    let mut tables = ShapeTables {
        radii: radii.to_vec(),
        value: DMatrix::zeros(p, n),
        slope: DMatrix::zeros(p, n),
        inertial: DMatrix::zeros(p, n),
        centrifugal: DMatrix::zeros(p, n),
    };
    let mut samples = vec![Sample::default(); n];
    for (row, &r) in radii.iter().enumerate().filter(|(_, r)| **r >= root) {
        functions.sample(r - root, &mut samples);
        for (column, sample) in samples.iter().enumerate() {
            tables.value[(row, column)] = sample.value;
            tables.slope[(row, column)] = sample.slope;
        }
    }
    integrate_from_tip(blade, dof, functions, rules, &mut tables);
    tables
}

/// Forces and moments of every function outboard of the point reached.
struct Outboard {
    /// ∫ m φ dr: shear per ω² (bending only).
    shear: Vec<f64>,
    /// Moment per ω².
    inertial: Vec<f64>,
    /// Moment per Ω².
    centrifugal: Vec<f64>,
}

/// Walks from the tip inwards, adding up loads; sampled radii are ends of segments.
///
/// Bending: M(r) = ∫ [ω² ∫ m X dξ − Ω² T X′] ds from r to R; in lag the centrifugal force's
/// component in the disc adds Ω² m X to the load. Torsion: M_t(r) = ∫ (ω² ρI_p − Ω² m Y²) X ds.
fn integrate_from_tip(
    blade: &Blade,
    dof: Dof,
    functions: &dyn AssumedFunctions,
    rules: &GaussRules,
    tables: &mut ShapeTables,
) {
    let n = functions.count();
    let root = blade.root(dof).offset;
    let tension = Tension::new(blade.mass(), root, blade.radius());
    let mut at = Outboard { shear: vec![0.0; n], inertial: vec![0.0; n], centrifugal: vec![0.0; n] };
    let mut samples = vec![Sample::default(); n];
    let mut next = tables.radii.len();
    let store = |tables: &mut ShapeTables, row: usize, at: &Outboard| {
        for column in 0..n {
            // Lag: the load is (ω² + Ω²) m X, the second part counted with the centrifugal moment.
            let in_disc = if dof == Dof::Lag { at.inertial[column] } else { 0.0 };
            tables.inertial[(row, column)] = at.inertial[column];
            tables.centrifugal[(row, column)] = at.centrifugal[column] - in_disc;
        }
    };
    let joints = functions.joints().iter().map(|x| root + x);
    let ends: Vec<f64> = tables.radii.iter().copied().chain(joints).collect();
    for segment in segments(blade, dof, &ends).iter().rev() {
        while next > 0 && tables.radii[next - 1] >= segment.to {
            next -= 1;
            store(tables, next, &at);
        }
        let mass = segment.linear(blade.mass());
        let inertia = segment.linear(blade.polar_inertia());
        let offset = segment.linear(blade.mass_offset());
        if dof != Dof::Torsion {
            // The shear outboard of this segment acts over its whole length.
            for (moment, shear) in at.inertial.iter_mut().zip(&at.shear) {
                *moment += shear * (segment.to - segment.from);
            }
        }
        segment.panels(functions, rules, |a, b, rule| {
            each_point(rule, a, b, |r, weight| {
                functions.sample(r - root, &mut samples);
                let m = weight * mass.at(r);
                let (load, lever, pull) = if dof == Dof::Torsion {
                    (weight * inertia.at(r), 1.0, m * offset.at(r) * offset.at(r))
                } else {
                    (m, r - segment.from, weight * tension.at(r))
                };
                for (i, f) in samples.iter().enumerate() {
                    at.shear[i] += load * f.value;
                    at.inertial[i] += load * lever * f.value;
                    at.centrifugal[i] += pull * if dof == Dof::Torsion { f.value } else { f.slope };
                }
            });
        });
    }
    while next > 0 && tables.radii[next - 1] >= root {
        next -= 1;
        store(tables, next, &at);
    }
}

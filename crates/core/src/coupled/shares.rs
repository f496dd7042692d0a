//! How much of a mode is flap, lag and torsion: shares of its kinetic energy about the mass centre, which are
//! not negative and sum to 1 whatever the axes.

use super::assembly::Assembly;
use super::blade::Motions;
use super::equilibrium::ModeFields;
use alloc::vec::Vec;
use nalgebra::{DMatrix, DVector};

/// Kinetic energies of flap, lag and torsion about the mass centre of modes with one another.
pub fn kinetic(assembly: &Assembly, fields: &ModeFields) -> [DMatrix<f64>; 3] {
    let n = fields.count();
    let mut parts = [0, 1, 2].map(|_| DMatrix::<f64>::zeros(n, n));
    for (index, element) in assembly.elements.iter().enumerate() {
        for (k, (section, weight)) in element.sections.iter().zip(&element.weight).enumerate() {
            let motions: Vec<Motions> = (0..n)
                .map(|mode| {
                    let at = |field: usize| fields.at[mode][index][field][k];
                    section.motions([at(0), at(1), at(3), at(4), at(6)])
                })
                .collect();
            add(&mut parts, &motions, *weight);
        }
        for section in &element.lumps {
            let motions: Vec<Motions> = (0..n).map(|mode| section.motions(fields.outer_state(mode, index))).collect();
            add(&mut parts, &motions, 1.0);
        }
    }
    parts
}

/// Shares in sum 1 of a sum of modes.
pub fn shares(kinetic: &[DMatrix<f64>; 3], vector: &DVector<f64>) -> [f64; 3] {
    in_sum_1(energies(kinetic, vector))
}

/// Kinetic energies of a sum of modes.
pub fn energies(kinetic: &[DMatrix<f64>; 3], vector: &DVector<f64>) -> [f64; 3] {
    kinetic.each_ref().map(|part| vector.dot(&(part * vector)))
}

/// Energies as shares in sum 1.
pub fn in_sum_1(parts: [f64; 3]) -> [f64; 3] {
    let total: f64 = parts.iter().sum();
    if total > 0.0 { parts.map(|part| part / total) } else { [0.0; 3] }
}

fn add(parts: &mut [DMatrix<f64>; 3], motions: &[Motions], weight: f64) {
    for (part, of) in parts.iter_mut().zip(0..3) {
        for (j, own) in motions.iter().enumerate() {
            let own = &own[of];
            for (i, other) in motions.iter().enumerate() {
                part[(i, j)] +=
                    weight * own.iter().zip(&other[of]).map(|((load, _), (_, motion))| load * motion).sum::<f64>();
            }
        }
    }
}

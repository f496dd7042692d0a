//! How much of a mode is flap, lag and torsion: shares of its kinetic energy about the mass centre, which are
//! not negative and sum to 1 whatever the axes.

use super::assembly::Assembly;
use super::equilibrium::ModeFields;
use crate::numerics::vector::long_dot;
use alloc::vec::Vec;
use nalgebra::DMatrix;

/// What the inertia makes of one motion of a mode about the mass centre, and the motion, along the blade.
#[derive(Clone, Debug, Default)]
struct Moved {
    loads: Vec<f64>,
    motions: Vec<f64>,
}

impl Moved {
    /// Flap, lag and torsion of a mode.
    fn new(assembly: &Assembly, fields: &ModeFields, mode: usize) -> [Self; 3] {
        let mut all: [Self; 3] = Default::default();
        let at = &fields.at[mode];
        for (index, element) in assembly.elements.iter().enumerate() {
            let points = assembly.along.part(index).zip(element.sections.iter().zip(&element.weight));
            let inside =
                points.map(|(k, (section, weight))| (section, *weight, [0, 1, 3, 4, 6].map(|field| at[field][k])));
            let state = fields.outer_state(mode, index);
            let hung = element.lumps.iter().map(|section| (section, 1.0, state));
            for (section, weight, states) in inside.chain(hung) {
                for (moved, pairs) in all.iter_mut().zip(section.motions(states)) {
                    // The second of each pair is rotary inertia.
                    for (load, motion) in pairs.into_iter().take(if section.rotary == 0.0 { 1 } else { 2 }) {
                        moved.loads.push(weight * load);
                        moved.motions.push(motion);
                    }
                }
            }
        }
        all
    }
}

/// Kinetic energies of flap, lag and torsion about the mass centre of modes with one another.
pub fn kinetic(assembly: &Assembly, fields: &ModeFields) -> [DMatrix<f64>; 3] {
    let n = fields.count();
    let moved: Vec<[Moved; 3]> = (0..n).map(|mode| Moved::new(assembly, fields, mode)).collect();
    [0, 1, 2].map(|of| DMatrix::from_fn(n, n, |i, j| long_dot(&moved[i][of].motions, &moved[j][of].loads)))
}

/// Shares in sum 1 of one mode.
pub fn own_shares(assembly: &Assembly, fields: &ModeFields, mode: usize) -> [f64; 3] {
    in_sum_one(own(assembly, fields, mode))
}

/// Kinetic energies of one mode.
pub fn own(assembly: &Assembly, fields: &ModeFields, mode: usize) -> [f64; 3] {
    Moved::new(assembly, fields, mode).map(|moved| long_dot(&moved.motions, &moved.loads))
}

/// Parts as shares in sum 1.
pub fn in_sum_one(parts: [f64; 3]) -> [f64; 3] {
    let total: f64 = parts.iter().sum();
    if total > 0.0 { parts.map(|part| part / total) } else { [0.0; 3] }
}

//! The motions that leave the tip free, carried inward, and the count of eigenvalues on their way.

use super::blade::CoupledBlade;
use super::crossing::Crossing;
use super::panels::Piece;
use super::small::{Small, kernel, negative, solve};
use crate::blades::Hold;

/// The motions that a root may leave free: w′, v′, φ.
const TURNS: [usize; 3] = [1, 3, 4];

/// What one passage from tip to root found.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage {
    /// Eigenvalues below λ.
    pub count: usize,
    /// What the roots leave, zero at an eigenvalue.
    pub left: f64,
}

/// States that span what the tip allows, in units of `scale`: as many as there are displacements.
struct Frame {
    columns: Vec<[f64; 10]>,
    active: Vec<usize>,
    scale: [f64; 10],
}

/// Goes through the pieces from the tip inward. Nothing where numbers get too large or too small.
pub(super) fn pass(blade: &CoupledBlade, pieces: &[Piece], square: f64) -> Option<Passage> {
    let springs = blade.springs();
    let mut frame = Frame { columns: Vec::new(), active: Vec::new(), scale: [1.0; 10] };
    for i in 0..5 {
        let mut column = [0.0; 10];
        column[i] = 1.0;
        frame.columns.push(column);
        frame.active.push(i);
    }
    let mut passage = Passage { count: 0, left: 1.0 };
    for piece in pieces {
        match piece {
            Piece::Panel(crossing) => passage.count += frame.cross(crossing, square)?,
            Piece::Mass(loads) => frame.add_mass(loads, square),
            Piece::Roots(here) => {
                let free = [0, 1, 2].map(|i| here[i] && blade.roots[i].hold != Hold::Clamped);
                let (count, left) = frame.take_roots(*here, free, &springs)?;
                passage.count += count;
                passage.left *= left;
            }
        }
    }
    assert!(frame.active.is_empty(), "a root lies beyond the tip");
    Some(passage)
}

impl Frame {
    fn change_units(&mut self, scale: [f64; 10]) {
        for column in &mut self.columns {
            for i in 0..10 {
                column[i] *= self.scale[i] / scale[i];
            }
        }
        self.scale = scale;
    }

    /// Gram–Schmidt, twice.
    fn orthonormalise(&mut self) {
        let dot = |a: &[f64; 10], b: &[f64; 10]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        for k in 0..self.columns.len() {
            let (before, rest) = self.columns.split_at_mut(k);
            let column = &mut rest[0];
            for _ in 0..2 {
                let size = 1.0 / dot(column, column).sqrt();
                *column = column.map(|x| x * size);
                for other in &*before {
                    let along = dot(other, column);
                    column.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
                }
            }
            let size = 1.0 / dot(column, column).sqrt();
            *column = column.map(|x| x * size);
        }
    }

    /// Displacements, or forces, of the columns; rows as in `active`.
    fn rows(&self, first: usize) -> Small {
        let mut out = [[0.0; 5]; 5];
        for (row, &i) in out.iter_mut().zip(&self.active) {
            for (x, column) in row.iter_mut().zip(&self.columns) {
                *x = column[first + i];
            }
        }
        out
    }

    /// Crosses a panel and counts the negative pivots of the node at its outboard end. With U the
    /// displacements before and after, and b those at the inboard end for unit forces at the outboard
    /// one, U₀ᵀ D U₀ = −U₀ᵀ b⁻¹ U₁ for the pivot D. A panel shorter than its first eigenvalue allows has
    /// a regular b, and no U is inverted: each may be singular, as the blade outboard has eigenvalues, too.
    fn cross(&mut self, panel: &Crossing, square: f64) -> Option<usize> {
        self.change_units(panel.scale);
        self.orthonormalise();
        let transfer = panel.transfer(square)?;
        let (n, before) = (self.active.len(), self.rows(0));
        for column in &mut self.columns {
            let state = *column;
            for (x, row) in column.iter_mut().zip(&transfer) {
                *x = row.iter().zip(&state).map(|(t, x)| t * x).sum();
            }
        }
        let mut yielding = [[0.0; 5]; 5];
        for (row, &i) in yielding.iter_mut().zip(&self.active) {
            for (x, &j) in row.iter_mut().zip(&self.active) {
                *x = transfer[i][5 + j];
            }
        }
        let forces = solve(n, yielding, self.rows(0));
        negative(n, symmetric(n, |i, j| -(0..n).map(|k| before[k][i] * forces[k][j]).sum::<f64>()))
    }

    fn add_mass(&mut self, loads: &[(usize, usize, f64, f64)], square: f64) {
        let scale = self.scale;
        for column in &mut self.columns {
            let state = *column;
            for &(i, j, fixed, inertial) in loads {
                if !self.active.contains(&i) || !self.active.contains(&j) {
                    continue;
                }
                let load = fixed - square * inertial;
                column[5 + i] -= load * scale[j] / scale[5 + i] * state[j];
                if i != j {
                    column[5 + j] -= load * scale[i] / scale[5 + j] * state[i];
                }
            }
        }
    }

    /// The degrees of freedom that begin here end: counts the negative pivots of those motions that are
    /// `free` here and keeps what meets the root conditions.
    fn take_roots(&mut self, here: [bool; 3], free: [bool; 3], springs: &[[f64; 3]; 3]) -> Option<(usize, f64)> {
        self.orthonormalise();
        let n = self.active.len();
        let (displacements, forces) = (self.rows(0), self.rows(5));
        // Rows of the motions that turn freely or on springs; spring moments for unit turns.
        let row_of = |i: usize| self.active.iter().position(|&a| a == i);
        let turning: Vec<usize> = (0..3).filter(|&dof| free[dof]).collect();
        let rows = turning.iter().map(|&dof| row_of(TURNS[dof])).collect::<Option<Vec<usize>>>()?;
        let spring = |a: usize, b: usize| {
            let (a, b) = (turning[a], turning[b]);
            springs[a][b] * self.scale[TURNS[b]] / self.scale[5 + TURNS[a]]
        };

        // Pivot of the turning motions, in the motions that hold everything else.
        let mut held = [[0.0; 5]; 5];
        let others = (0..n).filter(|row| !rows.contains(row));
        others.zip(&mut held).for_each(|(row, to)| *to = displacements[row]);
        let (motions, _) = kernel(n, n - rows.len(), held)?;
        let of = |matrix: &Small, row: usize, motion: usize| {
            matrix[rows[row]].iter().zip(&motions[motion]).map(|(a, x)| a * x).sum::<f64>()
        };
        let resistance = |row: usize, motion: usize| {
            let sprung: f64 = (0..rows.len()).map(|k| spring(row, k) * of(&displacements, k, motion)).sum();
            sprung - of(&forces, row, motion)
        };
        let pivot = symmetric(rows.len(), |i, j| {
            (0..rows.len()).map(|row| of(&displacements, row, i) * resistance(row, j)).sum()
        });
        let count = negative(rows.len(), pivot)?;

        // Conditions: no displacement, and no moment but the springs'.
        let mut conditions = [[0.0; 5]; 5];
        let ending: Vec<usize> = (0..n).filter(|&row| here[self.active[row] / 2]).collect();
        for (to, row) in conditions.iter_mut().zip(&ending) {
            *to = displacements[*row];
            if let Some(turn) = rows.iter().position(|turn| turn == row) {
                let size = (0..rows.len()).fold(1.0_f64, |size, k| size.max(spring(turn, k).abs()));
                for (i, x) in to.iter_mut().enumerate().take(n) {
                    let sprung: f64 =
                        rows.iter().enumerate().map(|(k, &b)| spring(turn, k) * displacements[b][i]).sum();
                    *x = (sprung - forces[*row][i]) / size;
                }
            }
        }
        let (kept, left) = kernel(n, ending.len(), conditions)?;
        self.active.retain(|&i| !here[i / 2]);
        let combine = |weights: &[f64; 5]| -> [f64; 10] {
            let all = |row: usize| self.columns.iter().zip(weights).map(|(column, x)| x * column[row]).sum();
            core::array::from_fn(|row| if self.active.contains(&(row % 5)) { all(row) } else { 0.0 })
        };
        self.columns = kept.iter().map(combine).collect();
        // An eigenvalue may show at any root: at this one where nothing further in takes part.
        left.is_finite().then_some((count, left))
    }
}

/// The symmetric part of a matrix that is symmetric but for rounding.
#[allow(clippy::needless_range_loop, reason = "indices of a matrix")]
fn symmetric(n: usize, entry: impl Fn(usize, usize) -> f64) -> Small {
    let mut out = [[0.0; 5]; 5];
    for i in 0..n {
        for j in 0..n {
            let value = 0.5 * entry(i, j);
            out[i][j] += value;
            out[j][i] += value;
        }
    }
    out
}

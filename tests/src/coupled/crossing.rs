//! How a state crosses a panel: the ten first-order equations, integrated by Taylor series from the
//! middle of the panel to both its ends.
//!
//! The state holds the displacements q = (w, w′, v, v′, φ) and the internal forces that do work on
//! them, p. With R the flexibility, τ = Ω² T eA (cos β, −sin β) and P = Ω² C − λ M,
//!   (w″, v″) = R ((p_w′, p_v′) + τ φ),   φ′ = p_φ/(GJ + Ω² T kA²),
//!   p_w, p_v: p′ = (P q),   p_w′, p_v′: p′ = (P q) − p_w, − p_v,   p_φ′ = (P q)_φ − τ·(w″, v″).
//! They are Hamiltonian: what crosses the panel outward is known from what crosses it inward.

use super::series::{LENGTH, Series};

/// Terms of each Taylor series, and how many of them are to spare at the largest λ: between, a sum may nearly vanish,
/// and more terms count beside it.
const TERMS: usize = 48;
const SPARE: usize = 8;
/// Terms in a row that must be negligible, as a uniform beam has one term in four.
const QUIET: usize = 4;
/// What a term may be of the sum of those before it: below all roundings.
const NEGLIGIBLE: f64 = 1e-18;

/// A matrix on states.
pub(super) type Transfer = [[f64; 10]; 10];

/// The equations of a panel, in physical units, with their coefficients as series.
#[derive(Debug)]
pub(super) struct Parts {
    pub loads: Vec<super::loads::Load>,
    /// Of bending: ww, wv, vv.
    pub flexibility: [Series; 3],
    /// 1/(GJ + Ω² T kA²).
    pub twist: Series,
    /// τ.
    pub moments: [Series; 2],
}

/// A coefficient of the equations.
#[derive(Clone, Debug)]
struct Entry {
    row: usize,
    column: usize,
    /// What does not depend on λ, and what λ multiplies.
    fixed: Series,
    inertial: Option<Series>,
    length: usize,
}

/// A panel ready to be crossed.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    entries: Vec<Entry>,
    /// Units of a state in which nothing grows much on the way.
    pub scale: [f64; 10],
}

impl Crossing {
    /// The equations in the panel's own units; nothing where a coefficient varies too much. `stiff` are
    /// typical stiffnesses in bending and torsion.
    pub fn new(length: f64, active: [bool; 3], [bending, torsion]: [f64; 2], parts: &Parts) -> Option<Self> {
        let active: Vec<usize> = (0..5).filter(|&i| active[i / 2]).collect();
        // Bending by `unit` takes as much energy as a twist of 1.
        let (unit, energy) = (length * (torsion / bending).sqrt(), torsion / length);
        let shapes = [unit, unit / length, unit, unit / length, 1.0];
        let scale = core::array::from_fn(|i| if i < 5 { shapes[i] } else { energy / shapes[i - 5] });
        let none = Series::constant(0.0);
        let one = Series::constant(1.0);
        let [ww, wv, vv] = parts.flexibility;
        let [a, b] = parts.moments;
        // Curvatures that a unit twist brings.
        let [w, v] = [ww * a + wv * b, wv * a + vv * b];
        let mut terms = vec![
            (0, 1, one, none),
            (2, 3, one, none),
            (1, 6, ww, none),
            (1, 8, wv, none),
            (3, 6, wv, none),
            (3, 8, vv, none),
            (1, 4, w, none),
            (3, 4, v, none),
            (4, 9, parts.twist, none),
            (6, 5, one.times(-1.0), none),
            (8, 7, one.times(-1.0), none),
            (9, 6, w.times(-1.0), none),
            (9, 8, v.times(-1.0), none),
            (9, 4, (a * w + b * v).times(-1.0), none),
        ];
        for &(i, j, fixed, inertial) in &parts.loads {
            terms.push((5 + i, j, fixed, inertial));
            if i != j {
                terms.push((5 + j, i, fixed, inertial));
            }
        }
        let mut entries: Vec<Entry> = Vec::new();
        for (row, column, fixed, inertial) in terms {
            if !active.contains(&(row % 5)) || !active.contains(&(column % 5)) {
                continue;
            }
            // Inward: r falls as the coordinate grows.
            let factor = -length * scale[column] / scale[row];
            let (fixed, inertial) = (fixed.times(factor), inertial.times(factor));
            let terms = fixed.length()?.max(inertial.length()?);
            let inertial = (inertial.length()? > 0).then_some(inertial);
            if terms > 0 {
                entries.push(Entry { row, column, fixed, inertial, length: terms });
            }
        }
        Some(Self { entries, scale })
    }

    /// Whether the series converge for λ of this size, a panel `share` shorter than one that just does.
    pub fn converges(&self, highest: f64, share: f64) -> bool {
        let more = highest / share.powi(4);
        [more, -more].into_iter().all(|square| self.series(square, TERMS - SPARE).is_some())
    }

    /// The states at the outboard and the inboard end, for each unit state in the middle, of so many terms at most.
    #[allow(clippy::needless_range_loop, clippy::large_stack_arrays, reason = "a recurrence on 38 KB")]
    fn series(&self, square: f64, most: usize) -> Option<[Transfer; 2]> {
        let coefficients: Vec<[f64; LENGTH]> = self
            .entries
            .iter()
            .map(|entry| entry.inertial.map_or(entry.fixed, |inertial| entry.fixed - inertial.times(square)).0)
            .collect();
        let mut terms = [[[0.0; 10]; 10]; TERMS];
        for i in 0..10 {
            terms[0][i][i] = 1.0;
        }
        let mut sizes = terms[0];
        let [mut outer, mut inner] = [terms[0]; 2];
        let (mut power, mut quiet) = (1.0, 0);
        for k in 0..most - 1 {
            let mut next = [[0.0; 10]; 10];
            for (entry, coefficient) in self.entries.iter().zip(&coefficients) {
                let row = &mut next[entry.row];
                for j in 0..entry.length.min(k + 1) {
                    let (factor, from) = (coefficient[j], &terms[k - j][entry.column]);
                    row.iter_mut().zip(from).for_each(|(sum, x)| *sum += factor * x);
                }
            }
            power *= 0.5;
            let (sign, mut negligible) = (if k % 2 == 0 { -power } else { power }, true);
            for i in 0..10 {
                for j in 0..10 {
                    let term = next[i][j] / (k + 1) as f64;
                    terms[k + 1][i][j] = term;
                    inner[i][j] += power * term;
                    outer[i][j] += sign * term;
                    sizes[i][j] += power * term.abs();
                    negligible &= power * term.abs() <= NEGLIGIBLE * sizes[i][j];
                }
            }
            quiet = if negligible { quiet + 1 } else { 0 };
            if quiet == QUIET {
                return Some([outer, inner]);
            }
        }
        None
    }

    /// The way from the outboard to the inboard end, in the panel's units.
    pub fn transfer(&self, square: f64) -> Option<Transfer> {
        let [outer, inner] = self.series(square, TERMS)?;
        // The inverse of a Hamiltonian flow (a b; c d) is (dᵀ −bᵀ; −cᵀ aᵀ).
        let back = |i: usize, j: usize| {
            let value = outer[(j + 5) % 10][(i + 5) % 10];
            if (i < 5) == (j < 5) { value } else { -value }
        };
        let mut transfer = [[0.0; 10]; 10];
        for (i, row) in transfer.iter_mut().enumerate() {
            for (k, factor) in inner[i].iter().enumerate() {
                for (j, sum) in row.iter_mut().enumerate() {
                    *sum += factor * back(k, j);
                }
            }
        }
        Some(transfer)
    }
}

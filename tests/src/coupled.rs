//! Exact eigenvalues of coupled flap, lag and torsion by counting, for comparison. Shares no code and
//! no idea with the product: no assumed functions, no energies assembled into matrices. The ten
//! first-order equations of the strong form are integrated from the free tip to the roots by Taylor
//! series on short panels, and the eigenvalues below a number are counted on the way: no eigenvalue is
//! looked for, so none can be missed, however close two of them lie.
//!
//! Cut the blade into panels so short that none of them, held at both ends, has an eigenvalue below the
//! number (which is proven for each). Then the eigenvalues below it are as many as the negative pivots
//! of the dynamic stiffness of the nodes, eliminated from the tip inward (Wittrick & Williams,
//! Q. J. Mech. Appl. Math. 24, 1971).

mod blade;
mod changes;
mod count;
mod crossing;
pub mod extreme;
mod loads;
mod panels;
mod product;
pub mod random;
mod series;
mod small;

pub use blade::{CoupledBlade, PointMass, Trapeze};
use count::Passage;
use panels::Piece;

/// What rounding may do to an eigenvalue, of its own size and of the unit of the blade: ten times what
/// other panels were seen to change on 500 random blades.
const ROUNDING: [f64; 2] = [1e-12, 1e-13];

/// Width of the interval that an eigenvalue is found in, likewise: where counts begin to waver.
const WIDTH: [f64; 2] = [1e-14, 1e-16];

/// One blade at one speed. Eigenvalues λ = ω² [rad²/s²] may be negative.
#[derive(Clone, Debug)]
pub struct Exact {
    blade: CoupledBlade,
    speed: f64,
    share: f64,
    /// A typical low eigenvalue.
    unit: f64,
    /// Pieces for eigenvalues up to `unit` times a power of 4.
    levels: Vec<Option<Vec<Piece>>>,
}

impl Exact {
    /// The blade at `speed` [rad/s].
    pub fn new(blade: &CoupledBlade, speed: f64) -> Self {
        Self::with_shorter_panels(blade, speed, 1.0)
    }

    /// The same with panels of at most `share` of the length that is proven to be short enough: another
    /// computation of the same numbers.
    pub fn with_shorter_panels(blade: &CoupledBlade, speed: f64, share: f64) -> Self {
        let least = |y: &[f64]| y.iter().copied().fold(f64::INFINITY, f64::min);
        let stiffness = least(&blade.bending[0].y).min(least(&blade.bending[1].y));
        let mass = blade.mass.y.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let unit = stiffness / (mass * blade.radius.powi(4)) + speed * speed;
        Self { blade: blade.clone(), speed, share, unit, levels: Vec::new() }
    }

    /// Number of eigenvalues below `square` [rad²/s²].
    pub fn count_below(&mut self, square: f64) -> usize {
        let level = self.level(square.abs());
        self.pass(level, square).count
    }

    /// The eigenvalue of this number, from 1: isolated by counting, then refined.
    pub fn eigenvalue(&mut self, number: usize) -> f64 {
        let (mut low, mut high) = (0.0, self.unit);
        if self.count_below(low) >= number {
            (low, high) = (-self.unit, 0.0);
            while self.count_below(low) >= number {
                (low, high) = (4.0 * low, low);
            }
        } else {
            while self.count_below(high) < number {
                (low, high) = (high, 4.0 * high);
            }
        }
        let level = self.level(high.abs().max(low.abs()));
        self.refine(level, number, low, high)
    }

    /// The first eigenvalues.
    pub fn eigenvalues(&mut self, count: usize) -> Vec<f64> {
        (1..=count).map(|number| self.eigenvalue(number)).collect()
    }

    /// What the computation may be wrong by near `square`.
    pub fn rounding(&self, square: f64) -> f64 {
        ROUNDING[0] * square.abs() + ROUNDING[1] * self.unit
    }

    /// Says why [low, up] cannot hold the eigenvalue of this number, from 1; nothing where it may.
    pub fn contradiction(&mut self, number: usize, low: f64, up: f64) -> Option<String> {
        if !low.is_finite() || !up.is_finite() {
            return Some(format!("eigenvalue {number} in [{low:e}, {up:e}]"));
        }
        let (below, above) = (low - self.rounding(low), up + self.rounding(up));
        let counts = [below, above].map(|square| self.count_below(square));
        let held = low <= up && counts[0] < number && counts[1] >= number;
        (!held).then(|| format!("eigenvalue {number} in [{low:e}, {up:e}]: {counts:?} lie below the ends"))
    }

    fn level(&mut self, size: f64) -> usize {
        let mut level = 0;
        while self.highest(level) < size {
            level += 1;
        }
        if self.levels.len() <= level {
            self.levels.resize(level + 1, None);
        }
        if self.levels[level].is_none() {
            self.levels[level] = Some(panels::of(&self.blade, self.speed, self.highest(level), self.share));
        }
        level
    }

    fn highest(&self, level: usize) -> f64 {
        self.unit * 4_f64.powf(level as f64)
    }

    /// One passage along the blade. It ends early at an exact eigenvalue, as 0 often is, which does not
    /// lie below itself: then a little lower.
    fn pass(&self, level: usize, square: f64) -> Passage {
        let pieces = self.levels[level].as_deref().unwrap();
        let lower = [0.0, 1e-15, 1e-14, 1e-13].into_iter().map(|part| square - part * (square.abs() + self.unit));
        lower.into_iter().find_map(|square| count::pass(&self.blade, pieces, square)).unwrap()
    }

    /// Bisects until the eigenvalue is alone, then follows what the roots leave, which changes its sign
    /// with the count: false position with halved weights (Illinois), every fourth step bisects.
    fn refine(&self, level: usize, number: usize, mut low: f64, mut high: f64) -> f64 {
        let signed = |square: f64| {
            let Passage { count, left } = self.pass(level, square);
            (count, if count < number { -left } else { left })
        };
        let (mut at_low, mut at_high) = (signed(low), signed(high));
        let (mut step, mut stayed) = (0, None);
        loop {
            let width = WIDTH[0] * (low.abs() + high.abs()) + WIDTH[1] * self.unit;
            let middle = 0.5 * (low + high);
            if high - low <= width {
                return middle;
            }
            let alone = at_low.0 + 1 == number && at_high.0 == number;
            step += 1;
            let mut next = middle;
            if alone && step % 4 != 0 {
                let chord = low - at_low.1 * (high - low) / (at_high.1 - at_low.1);
                // From an end that is already near, the step that would close the interval.
                next = chord.max(low + 0.4 * width).min(high - 0.4 * width);
            }
            let found = signed(next);
            let below = found.0 < number;
            // An end that stays for a second time loses half its weight.
            if stayed == Some(below) && alone {
                *(if below { &mut at_high.1 } else { &mut at_low.1 }) *= 0.5;
            }
            if below {
                (low, at_low) = (next, found);
            } else {
                (high, at_high) = (next, found);
            }
            stayed = Some(below);
        }
    }
}

#[cfg(test)]
mod tests;

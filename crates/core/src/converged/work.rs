//! The bound on the time of a solve: every step of it takes off what it costs.

use core::cell::Cell;

/// Most multiplications of one solve at one speed, about: where they are used up, what was found is the
/// answer, and its error says how good it is. Ordinary blades need a hundredth.
const AT_ONE_SPEED: f64 = 3e8;
/// The same over a range of speeds.
const OVER_A_RANGE: f64 = 5.5e8;

/// What is left to spend on one degree of freedom, in multiplications.
#[derive(Clone, Debug)]
pub struct Work {
    left: Cell<f64>,
}

impl Default for Work {
    fn default() -> Self {
        Self { left: Cell::new(AT_ONE_SPEED) }
    }
}

impl Work {
    /// For a range of rotor speeds.
    pub const fn for_range() -> Self {
        Self { left: Cell::new(OVER_A_RANGE) }
    }

    /// Takes off what was done.
    pub fn spend(&self, multiplications: f64) {
        self.left.set(self.left.get() - multiplications);
    }

    /// What is left; not above 0 where all is spent.
    pub fn left(&self) -> f64 {
        self.left.get()
    }
}

/// What the steps of a solve cost on a mesh, in multiplications, about.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    unknowns: f64,
    /// Points of the fine grid.
    points: f64,
    /// The energies of all polynomials.
    pub(super) setup: f64,
    /// A factor of the system.
    pub(super) factor: f64,
    /// A count of eigenvalues.
    pub(super) count: f64,
    /// The displacement of a function at the points of the grid.
    displacement: f64,
    /// The fields of a function at the points of the fine grid, and their moments.
    fields: f64,
}

impl Effort {
    /// On elements of these orders.
    pub(super) fn new(orders: &[usize]) -> Self {
        let sum = |of: &dyn Fn(f64) -> f64| orders.iter().map(|&order| of(order as f64)).sum();
        Self {
            unknowns: sum(&|b| b),
            points: sum(&|b| b + 5.0),
            setup: sum(&|b| 2.0 * b * b * (b + 5.0)),
            factor: sum(&|b| b * b * (b + 10.0)),
            count: sum(&|b| (b + 2.0) * (b + 2.0) * (2.0 * b + 5.0)),
            displacement: sum(&|b| b * (b + 2.0)),
            fields: sum(&|b| (b + 5.0) * (7.0 * b + 10.0)),
        }
    }

    /// One more function beside so many; what is read from memory costs more than what is multiplied.
    pub(super) fn function(&self, beside: usize) -> f64 {
        (10 * beside + 20) as f64 * self.unknowns + 7.0 * self.displacement
    }

    /// The modes of so many speeds, each found by itself, as functions for all.
    pub(super) fn at_each(&self, speeds: usize, modes: usize) -> f64 {
        let functions = |count: usize| count as f64 * self.function(count / 2);
        let each = functions(4 * modes + 2) + self.factor + 3.0 * Self::modes(3 * modes);
        speeds as f64 * each + functions(speeds * modes)
    }

    /// The modes within so many functions.
    pub(super) fn modes(functions: usize) -> f64 {
        let n = functions as f64;
        15.0 * n * n * n
    }

    /// Few functions of many.
    pub(super) fn reduction(&self, many: usize, few: usize) -> f64 {
        (many * few) as f64 * (self.unknowns + 3.0 * many as f64)
    }

    /// The residual moments of so many modes, as sums of functions.
    pub(super) fn moments(&self, functions: usize, modes: usize) -> f64 {
        let (n, m) = (functions as f64, modes as f64);
        m * (2.0 * n * self.unknowns + self.fields + m * self.points)
    }
}

#[cfg(test)]
impl Work {
    /// So many multiplications.
    pub(super) fn of(multiplications: f64) -> Self {
        Self { left: Cell::new(multiplications) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_spent() {
        let work = Work::of(10.0);
        work.spend(7.0);
        assert_eq!(work.left(), 3.0);
        work.spend(7.0);
        assert_eq!(work.left(), -4.0);
        assert!(Work::for_range().left() > Work::default().left());
    }
}

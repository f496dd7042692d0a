//! The paper's way to the frequencies (its §4.3, Eq. 81): march through ω in steps of 2.5 rad/s
//! until det(G − ω²M) changes sign, then bisect. Only here, as something to compare with.

use bladefan_core::internals::SystemMatrices;
use nalgebra::DMatrix;

/// Step of the march [rad/s].
const STEP: f64 = 2.5;
/// Relative width at which the bisection ends.
const TOLERANCE: f64 = 1e-15;
/// Where a march without enough roots is given up [rad/s].
const LAST: f64 = 1e6;

/// The `count` lowest frequencies [rad/s] at a rotor speed [rad/s].
pub(crate) fn frequencies(matrices: &SystemMatrices, speed: f64, count: usize) -> Vec<f64> {
    let g = matrices.stiffness() + matrices.centrifugal() * (speed * speed);
    let mut work = g.clone();
    let mut negative = |frequency: f64| {
        work.copy_from(&g);
        work.zip_apply(matrices.mass(), |g, m| *g -= frequency * frequency * m);
        determinant_is_negative(&mut work)
    };
    let mut found = Vec::with_capacity(count);
    let (mut low, mut sign) = (0.0, negative(0.0));
    while found.len() < count && low < LAST {
        let high = low + STEP;
        let next = negative(high);
        if next != sign {
            let (mut a, mut b) = (low, high);
            while b - a > TOLERANCE * b {
                let middle = 0.5 * (a + b);
                if middle <= a || middle >= b {
                    break;
                }
                if negative(middle) == sign {
                    a = middle;
                } else {
                    b = middle;
                }
            }
            found.push(0.5 * (a + b));
        }
        (low, sign) = (high, next);
    }
    found
}

/// The sign of the determinant by Gaussian elimination with row exchanges; the determinant itself
/// would overflow from some 30 functions on.
fn determinant_is_negative(a: &mut DMatrix<f64>) -> bool {
    let n = a.nrows();
    let mut negative = false;
    for k in 0..n {
        let pivot = (k..n).fold(k, |best, i| if a[(i, k)].abs() > a[(best, k)].abs() { i } else { best });
        if pivot != k {
            a.swap_rows(k, pivot);
            negative = !negative;
        }
        negative ^= a[(k, k)] < 0.0;
        if a[(k, k)] == 0.0 {
            return negative;
        }
        for j in k + 1..n {
            let factor = a[(k, j)] / a[(k, k)];
            for i in k + 1..n {
                a[(i, j)] -= factor * a[(i, k)];
            }
        }
    }
    negative
}

//! Sums over plain lists of numbers, each in one place and in one order.

/// Σ aᵢ bᵢ, in four lanes that vector instructions can carry: the order of the sum is fixed, so the
/// bits are those of every target. Both lists have one length.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (chunks_a, chunks_b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = chunks_a.remainder().iter().zip(chunks_b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in chunks_a.zip(chunks_b) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}

/// Σ aᵢ bᵢ of long lists, in eight lanes: those of [`dot`] wait for one another. Both lists have one length.
pub fn long_dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (chunks_a, chunks_b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = chunks_a.remainder().iter().zip(chunks_b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in chunks_a.zip(chunks_b) {
        for lane in 0..8 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let halves = [0, 1, 2, 3].map(|lane| sums[lane] + sums[lane + 4]);
    (halves[0] + halves[2]) + (halves[1] + halves[3]) + rest
}

/// Σ aᵢ bᵢ of one list with four others, at less cost than one by one, each in four lanes. All have one length.
pub fn four_dots(a: &[f64], others: [&[f64]; 4]) -> [f64; 4] {
    let (chunks, rest) = a.as_chunks::<4>();
    let [b, c, d, e] = others.map(|other| other[..a.len()].as_chunks::<4>().0);
    let mut sums = [[0.0; 4]; 4];
    for ((((a, b), c), d), e) in chunks.iter().zip(b).zip(c).zip(d).zip(e) {
        for (sum, other) in sums.iter_mut().zip([b, c, d, e]) {
            for lane in 0..4 {
                sum[lane] += a[lane] * other[lane];
            }
        }
    }
    let last = a.len() - rest.len();
    core::array::from_fn(|i| {
        let end: f64 = rest.iter().zip(&others[i][last..]).map(|(a, b)| a * b).sum();
        of_lanes(&sums[i]) + end
    })
}

/// Apart, so that the compiler leaves the lanes of one sum beside one another.
#[inline(never)]
fn of_lanes(lanes: &[f64; 4]) -> f64 {
    (lanes[0] + lanes[2]) + (lanes[1] + lanes[3])
}

/// Adds `factor` times `x` to `y`.
pub fn axpy(y: &mut [f64], factor: f64, x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += factor * x);
}

/// Multiplies every number by `factor`.
pub fn scale(x: &mut [f64], factor: f64) {
    for x in x {
        *x *= factor;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_dot_product_is_the_sum_in_any_order(pairs in prop::collection::vec((-9_i32..10, -9_i32..10), 0..40)) {
            // Whole numbers: no order rounds.
            let (a, b): (Vec<f64>, Vec<f64>) = pairs.iter().map(|&(a, b)| (f64::from(a), f64::from(b))).unzip();
            let sum: i32 = pairs.iter().map(|(a, b)| a * b).sum();
            prop_assert_eq!(dot(&a, &b), f64::from(sum));
            prop_assert_eq!(long_dot(&a, &b), f64::from(sum));
            let twice: Vec<f64> = b.iter().map(|b| 2.0 * b).collect();
            let sum = f64::from(sum);
            prop_assert_eq!(four_dots(&a, [&b, &twice, &b, &twice]), [sum, 2.0 * sum, sum, 2.0 * sum]);
        }

        /// Taking off is adding the opposite, to the bit.
        #[test]
        fn minus_a_factor_takes_off(y in any::<f64>(), factor in any::<f64>(), x in any::<f64>()) {
            let mut sum = [y];
            axpy(&mut sum, -factor, &[x]);
            let expected = y - factor * x;
            prop_assert!(sum[0].to_bits() == expected.to_bits() || (sum[0].is_nan() && expected.is_nan()));
        }
    }

    #[test]
    fn the_order_of_a_dot_product_stays() {
        // Lanes 0 and 2, 1 and 3, then the rest: a plain sum from the left would give 3.5.
        let a = [1e16, 1.0, -1e16, 0.0, 0.5, 3.0];
        assert_eq!(dot(&a, &[1.0; 6]), 4.5);
        assert_eq!(dot(&[], &[]), 0.0);
    }

    #[test]
    fn lists_are_added_and_scaled() {
        let mut y = [1.0, 2.0, 3.0];
        axpy(&mut y, 2.0, &[10.0, 20.0, 30.0]);
        assert_eq!(y, [21.0, 42.0, 63.0]);
        scale(&mut y, -0.5);
        assert_eq!(y, [-10.5, -21.0, -31.5]);
    }
}

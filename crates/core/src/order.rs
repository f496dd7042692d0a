//! Ordering by numbers: one for all of core, as each sort of another type is a program of its own.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;

/// Indices of `keys`, those of lesser keys first ([`f64::total_cmp`]); of equal keys, in their order.
pub(crate) fn order(keys: &[f64]) -> Vec<usize> {
    let heap: BinaryHeap<(i64, usize)> = keys.iter().copied().map(rank).zip(0..).collect();
    heap.into_sorted_vec().into_iter().map(|(_, index)| index).collect()
}

/// `values`, the lesser first.
pub(crate) fn ascending(values: &[f64]) -> Vec<f64> {
    order(values).into_iter().map(|index| values[index]).collect()
}

/// A whole number that compares as `key` does: the bits, which count down where the sign is set.
fn rank(key: f64) -> i64 {
    let bits = key.to_bits().cast_signed();
    if bits < 0 { bits ^ i64::MAX } else { bits }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn numbers_stand_in_the_order_of_the_standard_sort(
            keys in prop::collection::vec(prop_oneof![any::<f64>(), (-2..3).prop_map(f64::from), Just(-0.0)], 0..50)
        ) {
            let mut sorted: Vec<usize> = (0..keys.len()).collect();
            sorted.sort_by(|&a, &b| keys[a].total_cmp(&keys[b]));
            prop_assert_eq!(order(&keys), sorted);
            prop_assert!(ascending(&keys).is_sorted_by(|a, b| a.total_cmp(b).is_le()));
        }
    }
}

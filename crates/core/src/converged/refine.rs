//! Which elements are given more polynomials.

use super::TOLERANCE;
use super::layout::{Layout, MOST_UNKNOWNS};
use crate::functions::MOST_ORDER;
use crate::numerics::scalar::{ceil, ln};

/// Raises the orders of the elements that are to blame; false where nothing is left to raise.
pub(super) fn raise(layout: &mut Layout, shares: &[f64]) -> bool {
    let fair = 0.1 * TOLERANCE / shares.len() as f64;
    let mut left = MOST_UNKNOWNS.saturating_sub(layout.unknowns());
    let mut raised = false;
    for (order, share) in layout.orders.iter_mut().zip(shares) {
        if *share > fair && *order < MOST_ORDER && left > 0 {
            // Each order more takes off a factor of ten or so, fewer where the strain turns fast.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to some tens")]
            let more = ceil(ln(*share / fair) / 4.0).clamp(1.0, 8.0) as usize;
            let more = more.min(MOST_ORDER - *order).min(left);
            *order += more;
            left -= more;
            raised = true;
        }
    }
    raised
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;
    use alloc::vec::Vec;

    fn layout(orders: Vec<usize>) -> Layout {
        Layout { radii: (0..=orders.len()).map(|i| i as f64).collect(), orders, resolved: true }
    }

    #[test]
    fn only_what_is_to_blame_is_raised() {
        let mut found = layout(vec![5, 6, 7, 8]);
        // A fair share of four is a fortieth of the tolerance, 2.5e-12.
        assert!(raise(&mut found, &[0.0, 2.4e-12, 2.6e-12, f64::INFINITY]));
        // A factor of e⁴ to an order, and never more than eight at a time.
        assert_eq!(found.orders, [5, 6, 8, 16]);
        assert!(!raise(&mut found, &[0.0, 1e-12, 2.4e-12, 0.0]), "nobody is to blame");
        assert_eq!(found.orders, [5, 6, 8, 16]);
    }

    #[test]
    fn a_larger_share_raises_by_more() {
        let mut found = layout(vec![3; 4]);
        assert!(raise(&mut found, &[3e-12, 1e-9, 1e-6, 1e-2]));
        // ln of the share over 2.5e-12 by 4, rounded up: 0.05, 1.5, 3.2, 5.5.
        assert_eq!(found.orders, [4, 5, 7, 9]);
    }

    #[test]
    fn orders_and_unknowns_have_their_limits() {
        let mut found = layout(vec![MOST_ORDER, MOST_ORDER - 1]);
        assert!(raise(&mut found, &[1.0, 1.0]));
        assert_eq!(found.orders, [MOST_ORDER, MOST_ORDER]);
        assert!(!raise(&mut found, &[1.0, 1.0]), "nothing is left to raise");
        let mut found = layout(vec![14; 2000]);
        let shares = vec![1.0; 2000];
        assert!(raise(&mut found, &shares));
        assert_eq!(found.unknowns(), MOST_UNKNOWNS);
        assert!(!raise(&mut found, &shares), "no unknown is left");
    }
}

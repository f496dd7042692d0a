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

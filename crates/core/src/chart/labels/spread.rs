//! Labels along one line: each as near its target as the others let it.

use alloc::vec;
use alloc::vec::Vec;

/// A label that wants to stand at `target`.
#[derive(Clone, Copy, Debug)]
pub(in crate::chart) struct Wish {
    pub target: f64,
    /// Length it takes on the line.
    pub size: f64,
    /// Furthest it may stand from its target.
    pub limit: f64,
    /// Where there is no room for all, the lowest goes first.
    pub rank: u32,
}

/// Places between `low` and `high`, none overlapping, their order that of the targets; `None` for
/// labels there is no room for. Of all such places these have the least sum of squared
/// displacements (pool adjacent violators).
pub(in crate::chart) fn spread(wishes: &[Wish], low: f64, high: f64) -> Vec<Option<f64>> {
    let mut order: Vec<usize> = (0..wishes.len()).filter(|&index| wishes[index].target.is_finite()).collect();
    order.sort_by(|&a, &b| wishes[a].target.total_cmp(&wishes[b].target));
    loop {
        let total: f64 = order.iter().map(|&index| wishes[index].size).sum();
        if total > high - low {
            if !drop_lowest(&mut order, 0, usize::MAX, wishes) {
                break;
            }
            continue;
        }
        let places = pool(&order, wishes, low, high - total);
        let strayed = (0..order.len()).find(|&at| {
            let wish = &wishes[order[at]];
            (places[at].0 - wish.target).abs() > wish.limit
        });
        let Some(strayed) = strayed else {
            let mut placed = vec![None; wishes.len()];
            for (&index, &(place, _)) in order.iter().zip(&places) {
                placed[index] = Some(place);
            }
            return placed;
        };
        // The crowd that pushed it aside: labels that touch each other.
        let crowd = places[strayed].1;
        let first = places.iter().position(|place| place.1 == crowd).unwrap_or(strayed);
        let last = places.iter().rposition(|place| place.1 == crowd).unwrap_or(strayed);
        if !drop_lowest(&mut order, first, last, wishes) {
            break;
        }
    }
    vec![None; wishes.len()]
}

fn drop_lowest(order: &mut Vec<usize>, first: usize, last: usize, wishes: &[Wish]) -> bool {
    let range = first..order.len().min(last.saturating_add(1));
    let lowest = range.min_by_key(|&at| (wishes[order[at]].rank, usize::MAX - at));
    lowest.map(|at| order.remove(at)).is_some()
}

/// Place and crowd of each label of `order`. With the room that labels before take away, the
/// places only have to ascend: then blocks that would descend share their mean.
fn pool(order: &[usize], wishes: &[Wish], low: f64, high: f64) -> Vec<(f64, usize)> {
    let mut before = 0.0;
    // Sum, count and first label of each block.
    let mut blocks: Vec<(f64, f64, usize)> = Vec::new();
    let mut offsets = Vec::with_capacity(order.len());
    for (at, &index) in order.iter().enumerate() {
        let wish = &wishes[index];
        let offset = before + 0.5 * wish.size;
        offsets.push(offset);
        before += wish.size;
        let mut block = (wish.target - offset, 1.0, at);
        while let Some(&last) = blocks.last() {
            if last.0 / last.1 < block.0 / block.1 {
                break;
            }
            blocks.pop();
            block = (last.0 + block.0, last.1 + block.1, last.2);
        }
        blocks.push(block);
    }
    let mut places: Vec<(f64, usize)> = Vec::with_capacity(order.len());
    let mut crowd = 0;
    let mut previous = None;
    for (number, block) in blocks.iter().enumerate() {
        let mean = (block.0 / block.1).clamp(low, high.max(low));
        // Blocks held at the same end touch each other too.
        if previous != Some(mean.to_bits()) {
            crowd = number;
        }
        previous = Some(mean.to_bits());
        let end = blocks.get(number + 1).map_or(order.len(), |next| next.2);
        places.extend(offsets[block.2..end].iter().map(|offset| (mean + offset, crowd)));
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn wish(target: f64, rank: u32) -> Wish {
        Wish { target, size: 10.0, limit: f64::INFINITY, rank }
    }

    #[test]
    fn labels_with_room_stay_where_they_are() {
        assert_eq!(spread(&[wish(50.0, 1), wish(20.0, 1)], 0.0, 100.0), [Some(50.0), Some(20.0)]);
    }

    #[test]
    fn touching_labels_part_evenly_and_keep_their_order() {
        assert_eq!(spread(&[wish(50.0, 1), wish(50.0, 1)], 0.0, 100.0), [Some(45.0), Some(55.0)]);
        assert_eq!(spread(&[wish(99.0, 1), wish(98.0, 1)], 0.0, 100.0), [Some(95.0), Some(85.0)]);
    }

    #[test]
    fn without_room_the_lowest_rank_goes() {
        assert_eq!(spread(&[wish(5.0, 1), wish(5.0, 2), wish(5.0, 3)], 0.0, 20.0), [None, Some(5.0), Some(15.0)]);
        let near = Wish { limit: 4.0, ..wish(50.0, 1) };
        assert_eq!(spread(&[near, wish(50.0, 2)], 0.0, 100.0), [None, Some(50.0)]);
    }

    proptest! {
        #[test]
        fn no_two_labels_overlap(
            wishes in prop::collection::vec((-50.0..550.0, 1.0..30.0, 0u32..4, 5.0..400.0), 0..40)
        ) {
            let wishes: Vec<Wish> =
                wishes.into_iter().map(|(target, size, rank, limit)| Wish { target, size, limit, rank }).collect();
            let placed = spread(&wishes, 0.0, 500.0);
            let mut boxes: Vec<(f64, f64)> = Vec::new();
            for (wish, place) in wishes.iter().zip(&placed) {
                let Some(place) = *place else { continue };
                prop_assert!((place - wish.target).abs() <= wish.limit);
                boxes.push((place - 0.5 * wish.size, place + 0.5 * wish.size));
            }
            boxes.sort_by(|a, b| a.0.total_cmp(&b.0));
            prop_assert!(boxes.iter().all(|b| b.0 >= -1e-9 && b.1 <= 500.0 + 1e-9));
            prop_assert!(boxes.windows(2).all(|pair| pair[0].1 <= pair[1].0 + 1e-9), "{boxes:?}");
        }
    }
}

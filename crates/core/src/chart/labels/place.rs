//! A label beside a point, where it hides as little as can be.

use super::super::line::Area;
use super::super::sheet::Point;
use alloc::vec::Vec;

/// What is in the way of labels.
#[derive(Clone, Debug)]
pub(in crate::chart) struct Obstacles {
    /// Labels stay inside.
    pub frame: Area,
    /// Never covered: labels, markers.
    pub boxes: Vec<Area>,
    /// Lines and how bad it is to cover a piece of one.
    pub lines: Vec<(Vec<Point>, f64)>,
    /// Lines to labels, never covered.
    pub leaders: Vec<[Point; 2]>,
}

/// Directions from the point, the best first: right, then up, then left, then down.
const DIRECTIONS: [(f64, f64); 8] =
    [(1.0, -0.5), (1.0, 0.5), (-1.0, -0.5), (-1.0, 0.5), (1.0, 0.0), (-1.0, 0.0), (0.0, -1.0), (0.0, 1.0)];

impl Obstacles {
    /// A frame with nothing in it.
    pub(in crate::chart) const fn within(frame: Area) -> Self {
        Self { frame, boxes: Vec::new(), lines: Vec::new(), leaders: Vec::new() }
    }

    /// The best box of `size` at one of `distances` from `point`, now an obstacle itself; none
    /// where all of them cover another label or leave the frame.
    pub(in crate::chart) fn place(&mut self, point: Point, size: (f64, f64), distances: &[f64]) -> Option<Area> {
        self.choose(around(point, size, distances), f64::INFINITY)
    }

    /// Of areas with costs of their own the one that covers least besides, now an obstacle itself;
    /// none where all of them cover another label or a leader, leave the frame or cost more than `most`.
    pub(in crate::chart) fn choose(&mut self, candidates: Vec<(Area, f64)>, most: f64) -> Option<Area> {
        let mut best: Option<(f64, Area)> = None;
        for (area, own) in candidates {
            let barred = self.boxes.iter().any(|other| other.overlaps(&area))
                || self.leaders.iter().any(|leader| area.crossed_by(leader) > 0);
            if barred || !self.frame.holds(&area) {
                continue;
            }
            let covered: f64 = self.lines.iter().map(|(line, weight)| weight * area.crossed_by(line) as f64).sum();
            let cost = covered + own;
            if cost <= most && best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, area));
            }
        }
        let (_, area) = best?;
        self.boxes.push(area);
        Some(area)
    }
}

/// Boxes around a point, and what each costs: the more, the further and the later in order it is.
pub(super) fn around(point: Point, size: (f64, f64), distances: &[f64]) -> Vec<(Area, f64)> {
    let at = |(far, &distance): (usize, &f64)| {
        DIRECTIONS.iter().enumerate().map(move |(late, &(right, down))| {
            (beside(point, size, distance, right, down), 0.6 * far as f64 + 0.05 * late as f64)
        })
    };
    distances.iter().enumerate().flat_map(at).collect()
}

fn beside((x, y): Point, (width, height): (f64, f64), distance: f64, right: f64, down: f64) -> Area {
    let left = x - 0.5 * width + right * (0.5 * width + distance);
    // Half a step up or down beside the point, a whole one above or below it.
    let top = y - 0.5 * height + down * (if right == 0.0 { 0.5 * height + distance } else { height + distance });
    Area { left, top, right: left + width, bottom: top + height }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FRAME: Area = Area { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };

    #[test]
    fn a_label_keeps_off_a_line_if_it_can() {
        let level = alloc::vec![(0.0, 90.0), (400.0, 90.0)];
        let mut obstacles = Obstacles { lines: alloc::vec![(level, 1.0)], ..Obstacles::within(FRAME) };
        let placed = obstacles.place((100.0, 100.0), (40.0, 12.0), &[4.0]);
        assert!(placed.is_some_and(|area| area.top > 90.0), "{placed:?}");
    }

    proptest! {
        #[test]
        fn no_two_labels_overlap(points in prop::collection::vec((0.0..400.0, 0.0..300.0), 0..60)) {
            let mut obstacles = Obstacles::within(FRAME);
            let placed: Vec<Area> =
                points.into_iter().filter_map(|point| obstacles.place(point, (50.0, 12.0), &[4.0, 9.0])).collect();
            for (at, area) in placed.iter().enumerate() {
                prop_assert!(FRAME.holds(area));
                prop_assert!(placed[..at].iter().all(|other| !other.overlaps(area)));
            }
        }
    }
}

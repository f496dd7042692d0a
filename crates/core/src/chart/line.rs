//! Polylines: as few points as the pixels need, cut at a frame.

use super::sheet::Point;
use crate::numerics::scalar::hypot;
use alloc::vec;
use alloc::vec::Vec;

/// A rectangle [px], y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Area {
    /// Whether both share more than an edge.
    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// Whether both share a point.
    pub(super) fn touches(&self, other: &Self) -> bool {
        self.left <= other.right && other.left <= self.right && self.top <= other.bottom && other.top <= self.bottom
    }

    /// Whether `other` lies inside.
    pub(super) fn holds(&self, other: &Self) -> bool {
        self.left <= other.left && other.right <= self.right && self.top <= other.top && other.bottom <= self.bottom
    }

    pub(super) fn holds_point(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// The point inside that is nearest to `point`.
    pub(super) fn nearest(&self, (x, y): Point) -> Point {
        (x.max(self.left).min(self.right), y.max(self.top).min(self.bottom))
    }

    /// How many segments of `points` come inside.
    pub(super) fn crossed_by(&self, points: &[Point]) -> usize {
        points.windows(2).filter(|pair| clip_segment(pair[0], pair[1], self).is_some()).count()
    }
}

/// Distance between two points.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    hypot(a.0 - b.0, a.1 - b.1)
}

/// Distance of `point` from the nearest point of a segment.
pub(super) fn distance_to_segment([from, to]: [Point; 2], point: Point) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let square = dx * dx + dy * dy;
    let along = (point.0 - from.0) * dx + (point.1 - from.1) * dy;
    let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    distance((from.0 + share * dx, from.1 + share * dy), point)
}

/// Whether two segments meet.
pub(super) fn meet(first: [Point; 2], second: [Point; 2]) -> bool {
    let side = |[from, to]: [Point; 2], point: Point| {
        (to.0 - from.0) * (point.1 - from.1) - (to.1 - from.1) * (point.0 - from.0)
    };
    let apart = |line, [a, b]: [Point; 2]| side(line, a) * side(line, b) > 0.0;
    // On one line both sides are 0: those count as meeting.
    !apart(first, second) && !apart(second, first)
}

/// Largest distance [px] between a line and its thinned form.
const TOLERANCE: f64 = 0.05;

/// `points` (x ascending) without those that do not show.
pub(super) fn thin(points: &[Point]) -> Vec<Point> {
    simplify(&by_column(points))
}

/// First, lowest, highest and last of each pixel column.
fn by_column(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut rest = points;
    while let Some(&first) = rest.first() {
        let column = first.0 as i64;
        let count = rest.iter().take_while(|point| point.0 as i64 == column).count().max(1);
        let (these, later) = rest.split_at(count);
        rest = later;
        if count <= 4 {
            kept.extend_from_slice(these);
            continue;
        }
        let lowest = (0..count).min_by(|&a, &b| these[a].1.total_cmp(&these[b].1)).unwrap_or(0);
        let highest = (0..count).max_by(|&a, &b| these[a].1.total_cmp(&these[b].1)).unwrap_or(0);
        let mut picked = [0, lowest, highest, count - 1];
        picked.sort_unstable();
        kept.extend((0..4).filter(|&at| at == 0 || picked[at] != picked[at - 1]).map(|at| these[picked[at]]));
    }
    kept
}

/// Drops points nearer than the tolerance to the line through those kept (Douglas and Peucker).
fn simplify(points: &[Point]) -> Vec<Point> {
    let Some(last) = points.len().checked_sub(1).filter(|&last| last > 1) else { return points.to_vec() };
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[last] = true;
    let mut spans = vec![(0, last)];
    while let Some((from, to)) = spans.pop() {
        let (a, b) = (points[from], points[to]);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let length = dx * dx + dy * dy;
        let mut worst = (TOLERANCE * TOLERANCE * length.max(1e-12), None);
        for (at, point) in points.iter().enumerate().take(to).skip(from + 1) {
            let across = (point.0 - a.0) * dy - (point.1 - a.1) * dx;
            // Squared distance to the line, times `length`; both ends at one point: to that point.
            let distance = if length > 1e-12 {
                across * across
            } else {
                let (px, py) = (point.0 - a.0, point.1 - a.1);
                (px * px + py * py) * 1e-12
            };
            if distance > worst.0 {
                worst = (distance, Some(at));
            }
        }
        if let Some(at) = worst.1 {
            keep[at] = true;
            spans.extend([(from, at), (at, to)]);
        }
    }
    points.iter().zip(keep).filter_map(|(&point, kept)| kept.then_some(point)).collect()
}

/// The parts of `points` inside `area`.
pub(super) fn clip(points: &[Point], area: &Area) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some((from, to)) = clip_segment(pair[0], pair[1], area) else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// The part of one segment inside `area` (Liang and Barsky).
fn clip_segment(from: Point, to: Point, area: &Area) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0, 1.0);
    let edges =
        [(-dx, from.0 - area.left), (dx, area.right - from.0), (-dy, from.1 - area.top), (dy, area.bottom - from.1)];
    for (towards, room) in edges {
        if towards == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enter = f64::max(enter, room / towards);
        } else {
            leave = f64::min(leave, room / towards);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
    // The segment's own ends exactly, so that neighbours join.
    Some((if enter > 0.0 { at(enter) } else { from }, if leave < 1.0 { at(leave) } else { to }))
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Area = Area { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };

    #[test]
    fn lines_are_cut_at_the_frame() {
        let parts = clip(&[(-5.0, 5.0), (5.0, 5.0), (5.0, 20.0), (8.0, 20.0), (8.0, 5.0)], &AREA);
        assert_eq!(parts, [vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)], vec![(8.0, 10.0), (8.0, 5.0)]]);
    }

    #[test]
    fn points_and_segments_are_as_far_apart_as_they_look() {
        assert_eq!(AREA.nearest((13.0, 4.0)), (10.0, 4.0));
        assert_eq!(AREA.nearest((3.0, 4.0)), (3.0, 4.0));
        let level = [(0.0, 0.0), (10.0, 0.0)];
        for (point, expected) in [((5.0, 2.0), 2.0), ((13.0, 4.0), 5.0), ((-3.0, 4.0), 5.0)] {
            assert!((distance_to_segment(level, point) - expected).abs() < 1e-12, "{point:?}");
        }
        assert!(meet(level, [(5.0, -1.0), (5.0, 1.0)]));
        assert!(!meet(level, [(5.0, 0.5), (5.0, 1.0)]));
        assert!(!meet(level, [(11.0, -1.0), (11.0, 1.0)]));
    }

    #[test]
    fn many_points_on_a_curve_become_few_and_stay_near() {
        let curve: Vec<Point> = (0..100_000).map(|i| f64::from(i) * 0.008).map(|x| (x, x * x / 1600.0)).collect();
        let few = thin(&curve);
        assert!(few.len() < 100, "{}", few.len());
        assert_eq!((few.first(), few.last()), (curve.first(), curve.last()));
        for &(x, y) in &curve {
            let after = few.iter().position(|point| point.0 >= x).unwrap_or(0).max(1);
            let (a, b) = (few[after - 1], few[after]);
            let on_line = a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0);
            assert!((y - on_line).abs() < 0.1, "{x}");
        }
    }

    #[test]
    fn spikes_survive_thinning() {
        let mut flat: Vec<Point> = (0..10_000).map(|i| (f64::from(i) * 0.01, 5.0)).collect();
        flat[5432].1 = 9.0;
        assert!(thin(&flat).contains(&(54.32, 9.0)), "spike lost");
        assert!(thin(&flat).len() < 8, "flat parts kept");
    }
}

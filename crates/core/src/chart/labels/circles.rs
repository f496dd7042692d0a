//! Labels of circles: each stands nearest to its own, or a leader tells whose it is.

use super::super::line::{Area, distance, distance_to_segment, meet};
use super::super::sheet::Point;
use super::place::{Obstacles, around};
use alloc::vec;
use alloc::vec::Vec;

/// Circles of one size.
#[derive(Clone, Copy, Debug)]
pub(in crate::chart) struct Circles<'a> {
    pub centres: &'a [Point],
    /// Radius [px].
    pub radius: f64,
    /// Width [px] of their lines.
    pub line: f64,
    /// Size of everything that is not data, 1 at 960 px.
    pub unit: f64,
}

/// Where a label stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::chart) struct Placed {
    pub area: Area,
    /// From the circle to the label, where another circle could be taken for its own.
    pub leader: Option<[Point; 2]>,
}

/// Without a leader every other circle is at least so many times as far from a label as its own. Less, and
/// the eye has to measure.
const CLEARLY_NEARER: f64 = 1.5;
/// Circles nearer to each other than this [px] look like one.
const ON_ONE_ANOTHER: f64 = 1.0;
/// Lengths of leaders, in units.
const LEADERS: [f64; 6] = [7.0, 11.0, 16.0, 22.0, 30.0, 40.0];
/// Directions of leaders to the right and down, those of a quarter turn.
const QUARTER: [Point; 4] = [(0.924, 0.383), (0.707, 0.707), (0.383, 0.924), (1.0, 0.0)];

impl Circles<'_> {
    /// Places for the labels of these sizes, one for each circle; none where there is no room. Circles and
    /// labels are obstacles afterwards.
    pub(in crate::chart) fn label(&self, sizes: &[(f64, f64)], obstacles: &mut Obstacles) -> Vec<Option<Placed>> {
        let others = obstacles.boxes.clone();
        obstacles.boxes.extend(self.centres.iter().map(|&centre| square(centre, self.radius + 1.0)));
        let near = self.radius + 2.0 * self.unit;
        let distances = [near, near + 5.0 * self.unit, near + 10.0 * self.unit];
        let mut placed = vec![None; self.centres.len()];
        for (own, (&centre, &size)) in self.centres.iter().zip(sizes).enumerate() {
            let mut areas = around(centre, size, &distances);
            areas.retain(|(area, _)| self.is_nearest(own, area));
            placed[own] = obstacles.choose(areas, f64::INFINITY).map(|area| Placed { area, leader: None });
        }
        // Those that stand by their circles first: they have less choice.
        for (own, &size) in sizes.iter().enumerate() {
            if placed[own].is_some() {
                continue;
            }
            let labels: Vec<Area> = placed.iter().flatten().map(|placed: &Placed| placed.area).collect();
            let mut areas = self.ahead(own, size);
            areas.retain(|(area, _)| {
                let leader = self.leader(own, area);
                self.is_clear(own, leader)
                    && !labels.iter().any(|label| label.crossed_by(&leader) > 0)
                    && !self.hides(own, leader, &others)
                    && !obstacles.leaders.iter().any(|&other| meet(leader, other))
            });
            let Some(area) = obstacles.choose(areas, f64::INFINITY) else { continue };
            let leader = self.leader(own, &area);
            obstacles.leaders.push(leader);
            placed[own] = Some(Placed { area, leader: Some(leader) });
        }
        placed
    }

    /// Whether a circle is clearly the nearest to a label.
    fn is_nearest(&self, own: usize, area: &Area) -> bool {
        let away = |centre: Point| distance(area.nearest(centre), centre);
        let least = CLEARLY_NEARER * away(self.centres[own]);
        self.others(own).all(|centre| away(centre) >= least)
    }

    fn others(&self, own: usize) -> impl Iterator<Item = Point> {
        self.centres.iter().enumerate().filter(move |(at, _)| *at != own).map(|(_, &centre)| centre)
    }

    /// Boxes at the ends of leaders, and what each costs.
    fn ahead(&self, own: usize, size: (f64, f64)) -> Vec<(Area, f64)> {
        let at = |(far, &length): (usize, &f64)| {
            let away = self.rim() + length * self.unit;
            let sides = [(1.0, -1.0), (1.0, 1.0), (-1.0, -1.0), (-1.0, 1.0)];
            let directions = sides.into_iter().flat_map(|(right, down)| {
                // Straight to the right and left, and up and down, once each.
                let straight = if right * down > 0.0 { (0.0, right) } else { (right, 0.0) };
                let slanted = QUARTER[..3].iter().map(move |&(x, y)| (right * x, down * y));
                slanted.chain([straight])
            });
            directions.enumerate().map(move |(late, direction)| {
                (at_the_end(self.centres[own], size, away, direction), 0.6 * far as f64 + 0.03 * late as f64)
            })
        };
        LEADERS.iter().enumerate().flat_map(at).collect()
    }

    /// Radius of the outer edge of their lines.
    fn rim(&self) -> f64 {
        self.radius + 0.5 * self.line
    }

    /// From the rim of a circle straight to the nearest point of its label.
    fn leader(&self, own: usize, area: &Area) -> [Point; 2] {
        let centre = self.centres[own];
        let end = area.nearest(centre);
        let share = self.rim() / distance(centre, end).max(self.rim());
        [(centre.0 + share * (end.0 - centre.0), centre.1 + share * (end.1 - centre.1)), end]
    }

    /// Whether a leader keeps off all other circles, and begins where its own is the nearest.
    fn is_clear(&self, own: usize, leader: [Point; 2]) -> bool {
        self.others(own).all(|centre| {
            let apart = distance(centre, self.centres[own]);
            // Circles on one another share what leads to them.
            let room = if apart < ON_ONE_ANOTHER { -apart } else { (0.5 * apart).min(2.0 * self.unit) };
            distance_to_segment(leader, centre) >= self.rim() + room - 1e-6
        })
    }

    /// Whether a leader runs over one of the boxes; those that the circle itself touches do not count.
    fn hides(&self, own: usize, leader: [Point; 2], boxes: &[Area]) -> bool {
        let circle = square(self.centres[own], self.rim());
        let [from, to] = leader;
        // There may be a hundred thousand boxes.
        let around =
            Area { left: from.0.min(to.0), top: from.1.min(to.1), right: from.0.max(to.0), bottom: from.1.max(to.1) };
        boxes.iter().any(|area| area.touches(&around) && !area.overlaps(&circle) && area.crossed_by(&leader) > 0)
    }
}

fn square((x, y): Point, half: f64) -> Area {
    Area { left: x - half, top: y - half, right: x + half, bottom: y + half }
}

/// The box whose point nearest to `point` lies so far `away` in a direction.
fn at_the_end((x, y): Point, (width, height): (f64, f64), away: f64, (right, down): Point) -> Area {
    let start = |from: f64, length: f64, towards: f64| {
        let side = if towards > 0.0 {
            0.0
        } else if towards < 0.0 {
            length
        } else {
            0.5 * length
        };
        from + away * towards - side
    };
    let (left, top) = (start(x, width, right), start(y, height, down));
    Area { left, top, right: left + width, bottom: top + height }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: (f64, f64) = (40.0, 12.0);

    fn label(centres: &[Point], frame: Area) -> Vec<Option<Placed>> {
        let circles = Circles { centres, radius: 4.0, line: 1.0, unit: 1.0 };
        circles.label(&vec![SIZE; centres.len()], &mut Obstacles::within(frame))
    }

    const FRAME: Area = Area { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };

    #[test]
    fn labels_turn_away_from_other_circles() {
        let [left, right] = [(200.0, 150.0), (220.0, 150.0)];
        let placed = label(&[left, right], FRAME);
        let areas: Vec<Area> = placed.iter().flatten().map(|placed| placed.area).collect();
        assert!(placed.iter().flatten().all(|placed| placed.leader.is_none()), "{placed:?}");
        for (area, own, other) in [(areas[0], left, right), (areas[1], right, left)] {
            let away = |centre| distance(area.nearest(centre), centre);
            assert!(1.5 * away(own) <= away(other), "{area:?}");
        }
    }

    #[test]
    fn leaders_run_from_the_rim_to_the_label_and_do_not_meet() {
        let centre = (200.0, 150.0);
        let placed = label(&[centre, centre, centre], FRAME);
        let leaders: Vec<[Point; 2]> = placed.iter().flatten().filter_map(|placed| placed.leader).collect();
        assert_eq!(leaders.len(), 3, "{placed:?}");
        for (at, (leader, placed)) in leaders.iter().zip(placed.iter().flatten()).enumerate() {
            assert!((distance(leader[0], centre) - 4.5).abs() < 1e-9, "{leader:?}");
            assert_eq!(leader[1], placed.area.nearest(centre));
            assert!(leaders[..at].iter().all(|&other| !meet(*leader, other)), "{leaders:?}");
        }
    }

    #[test]
    fn where_there_is_no_room_there_is_no_label() {
        let frame = Area { left: 190.0, top: 140.0, right: 210.0, bottom: 160.0 };
        assert_eq!(label(&[(200.0, 150.0)], frame), [None]);
        assert_eq!(label(&[], FRAME), []);
    }
}

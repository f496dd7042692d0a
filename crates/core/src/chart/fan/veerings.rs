//! Where two branches of a coupled blade turn away from one another.

use super::super::palette::Style;
use super::super::panel::Panel;
use super::super::sheet::Sheet;
use super::units::Units;
use crate::report::FanChart;

/// Half the length of the mark [units].
const HALF: f64 = 5.0;

/// Draws a short upright bar between the two branches of every veering in the frame.
pub(super) fn draw(sheet: &mut Sheet, style: &Style, chart: &FanChart, panel: &Panel, units: Units) {
    for veering in chart.veerings.iter().filter(|veering| veering.kind == "veering") {
        let middle = units.point(panel, veering.speed_rad_s, veering.frequency_rad_s);
        let Some(at) = middle.filter(|at| panel.area.holds_point(*at)) else { continue };
        sheet.layer(&[("class", "veering")], &|pen| {
            let half = HALF * style.unit;
            pen.line(&[(at.0, at.1 - half), (at.0, at.1 + half)], style.palette.text, 1.6 * style.unit);
        });
    }
}

//! Colours, dashes and sizes: what makes all drawings look alike.

use super::Theme;
use crate::dof::Dof;
use plotters::style::RGBColor;

/// Colours of one theme.
#[derive(Clone, Copy, Debug)]
pub(super) struct Palette {
    pub background: RGBColor,
    pub text: RGBColor,
    pub muted: RGBColor,
    pub grid: RGBColor,
    pub frame: RGBColor,
    pub ray: RGBColor,
    pub blade_ray: RGBColor,
    pub band: RGBColor,
    pub nominal: RGBColor,
    dofs: [RGBColor; 3],
}

impl Palette {
    /// Light: Wong's colour-blind safe blue, vermilion and green (Nature Methods 8, 441, 2011).
    /// Dark: the same hues, lightened until each stands 6:1 or more against its background.
    pub(super) const fn of(theme: Theme) -> Self {
        match theme {
            Theme::Light => Self {
                background: RGBColor(0xFF, 0xFF, 0xFF),
                text: RGBColor(0x1B, 0x1F, 0x24),
                muted: RGBColor(0x68, 0x6E, 0x76),
                grid: RGBColor(0xEC, 0xEE, 0xF0),
                frame: RGBColor(0x7A, 0x80, 0x88),
                ray: RGBColor(0xC3, 0xC7, 0xCC),
                blade_ray: RGBColor(0x80, 0x86, 0x8E),
                band: RGBColor(0xF6, 0xF1, 0xE4),
                nominal: RGBColor(0x4A, 0x4F, 0x57),
                dofs: [RGBColor(0x00, 0x72, 0xB2), RGBColor(0xD5, 0x5E, 0x00), RGBColor(0x00, 0x9E, 0x73)],
            },
            Theme::Dark => Self {
                background: RGBColor(0x14, 0x17, 0x1B),
                text: RGBColor(0xE7, 0xE9, 0xEC),
                muted: RGBColor(0x9A, 0xA1, 0xAA),
                grid: RGBColor(0x2A, 0x30, 0x37),
                frame: RGBColor(0x6B, 0x73, 0x7D),
                ray: RGBColor(0x45, 0x4C, 0x55),
                blade_ray: RGBColor(0x84, 0x8C, 0x96),
                band: RGBColor(0x20, 0x26, 0x2E),
                nominal: RGBColor(0xB4, 0xBA, 0xC2),
                dofs: [RGBColor(0x5A, 0xB4, 0xEE), RGBColor(0xF5, 0x94, 0x4E), RGBColor(0x3F, 0xCB, 0xA0)],
            },
        }
    }

    /// Colour of a degree of freedom.
    pub(super) const fn dof(&self, dof: Dof) -> RGBColor {
        self.dofs[dof.index()]
    }

    /// `share` of `colour` over the background, 0 to 1.
    pub(super) fn tone(&self, colour: RGBColor, share: f64) -> RGBColor {
        let mix = |over: u8, under: u8| (f64::from(over) * share + f64::from(under) * (1.0 - share) + 0.5) as u8;
        let back = self.background;
        RGBColor(mix(colour.0, back.0), mix(colour.1, back.1), mix(colour.2, back.2))
    }
}

/// Lengths of dashes and gaps [px] of a degree of freedom; empty: solid.
pub(super) const fn dashes(dof: Dof) -> &'static [f64] {
    match dof {
        Dof::Flap => &[],
        Dof::Lag => &[8.0, 4.0],
        Dof::Torsion => &[9.0, 3.5, 2.0, 3.5],
    }
}

/// Dashes of piecewise functions where the colour alone tells the degree of freedom; classical ones
/// are solid.
pub(super) const FAMILY_DASHES: [f64; 2] = [4.0, 3.0];

/// Palette, and sizes that grow slower than the drawing's width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    pub palette: Palette,
    /// Width of the drawing [px].
    pub width: f64,
    /// Size of everything that is not data, 1 at 960 px.
    pub unit: f64,
}

impl Style {
    pub(super) fn of(theme: Theme, width: u32) -> Self {
        let width = f64::from(width.clamp(320, 8000));
        // 10 px text stays 8 px or more at 600 px; a poster's text grows without end.
        Self { palette: Palette::of(theme), width, unit: (0.55 + 0.45 * width / 960.0).max(0.8) }
    }

    /// Text size of titles [px].
    pub(super) fn title(&self) -> f64 {
        17.0 * self.unit
    }

    /// Text size of labels and axis names.
    pub(super) fn label(&self) -> f64 {
        13.0 * self.unit
    }

    /// Text size of ticks and legends.
    pub(super) fn tick(&self) -> f64 {
        12.0 * self.unit
    }

    /// Text size of rays, crossings and notes.
    pub(super) fn small(&self) -> f64 {
        11.0 * self.unit
    }

    /// Space between the edge of the drawing and what stands in it.
    pub(super) fn margin(&self) -> f64 {
        14.0 * self.unit
    }
}

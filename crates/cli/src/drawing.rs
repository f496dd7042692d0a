//! Drawings as pixels, by resvg with fonts of our own: a bare machine has none.

use crate::args::DrawingArgs;
use crate::failure::Failure;
use bladefan_core::chart::ChartOptions;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Pixels per unit of the drawing: sharp in print and on dense screens.
const SCALE: f32 = 2.0;

/// Arimo: Latin, Greek, Cyrillic and the signs that charts need (see `assets/fonts`).
const FONTS: [&[u8]; 2] =
    [include_bytes!("../assets/fonts/Arimo-Regular.ttf"), include_bytes!("../assets/fonts/Arimo-Bold.ttf")];
const FAMILY: &str = "Arimo";

/// How a drawing looks.
pub(crate) fn options<'a>(args: &DrawingArgs) -> ChartOptions<'a> {
    let defaults = ChartOptions::default();
    ChartOptions {
        theme: args.theme,
        speed_unit: args.speed_unit,
        width: args.width.unwrap_or(defaults.width),
        height: args.height,
        ..defaults
    }
}

/// The drawing as a PNG file.
pub(crate) fn png(svg: &str) -> Result<Vec<u8>, Failure> {
    let mut options = Options { font_family: FAMILY.into(), ..Options::default() };
    let fonts = options.fontdb_mut();
    for font in FONTS {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_sans_serif_family(FAMILY);
    fonts.set_monospace_family(FAMILY);
    let failed = |why: String| Failure::Output(format!("PNG: cannot be drawn: {why}"));
    let tree = Tree::from_str(svg, &options).map_err(|error| failed(error.to_string()))?;
    let size = tree.size().scale_by(SCALE).map(|size| size.to_int_size());
    let mut pixels = size
        .and_then(|size| Pixmap::new(size.width(), size.height()))
        .ok_or_else(|| failed("the drawing has no size".into()))?;
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(error.to_string()))
}

//! Drawings as files: SVG as the core draws it, and PNG by resvg with fonts of our own, as a bare machine
//! has none.

use crate::args::DrawingArgs;
use crate::failure::Failure;
use bladefan_core::chart::{ChartOptions, Drawing};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::path::PathBuf;

/// Pixels per unit of the drawing: sharp in print and on dense screens.
const SCALE: f32 = 2.0;

/// Arimo: Latin, Greek, Cyrillic and the signs that charts need (see `assets/fonts`).
const FONTS: [&[u8]; 2] =
    [include_bytes!("../../assets/fonts/Arimo-Regular.ttf"), include_bytes!("../../assets/fonts/Arimo-Bold.ttf")];
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

/// The files asked for; `draw` is called only where there are any.
pub(crate) fn files(args: &DrawingArgs, draw: impl FnOnce() -> Drawing) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    if args.any() {
        let svg = draw().svg;
        if let Some(path) = &args.png {
            files.push((path.clone(), png(&svg)?));
        }
        if let Some(path) = &args.svg {
            files.push((path.clone(), svg.into_bytes()));
        }
    }
    Ok(files)
}

/// The drawing as a PNG file.
fn png(svg: &str) -> Result<Vec<u8>, Failure> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn size(png: &[u8]) -> [u32; 2] {
        let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        [number(16), number(20)]
    }

    #[test]
    fn a_png_has_two_pixels_per_unit() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20"><text y="9">Ω</text></svg>"#;
        assert_eq!(size(&png(svg).unwrap()), [60, 40]);
    }

    #[test]
    fn letters_are_drawn_without_fonts_of_the_machine() {
        let draw = |letter: &str| {
            let text = format!(r#"<text y="15" font-family="Nowhere, sans-serif">{letter}</text>"#);
            png(&format!(r#"<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20">{text}</svg>"#)).unwrap()
        };
        let [blank, one, other] = [" ", "Ω", "ж"].map(draw);
        assert!(blank != one && one != other && other != blank, "a letter is missing");
    }

    #[test]
    fn what_is_no_drawing_is_said_so() {
        let failure = png("<svg").unwrap_err();
        assert!(failure.lines()[0].starts_with("PNG: cannot be drawn: "), "{failure:?}");
    }
}

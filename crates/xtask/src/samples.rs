//! The drawings that the page offers, by kind, each with its colouring: OpenMoji's, copied out of the npm package, and our
//! own.

use crate::process::root;
use anyhow::{Context, Result};
use kurbo::Affine;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Document, Srgb8, Work, exact};
use scumble_io::{import_svg, read_scribbles};
use scumble_solve::{Picture, Scene, View, line_shapes, paint};
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};

/// OpenMoji's black line drawings, from the top of the repository.
pub(crate) const OPENMOJI_BLACK: &str = "node_modules/openmoji/black/svg";

/// Our own drawings, and the scribbles of all.
const OWN: &str = "web/samples";

/// Kind, file without its ending, and name, in the order to show.
const SAMPLES: [(&str, &str, &str); 18] = [
    ("fruit", "pear", "Pear"),
    ("fruit", "1F34E", "Apple"),
    ("fruit", "1F33B", "Sunflower"),
    ("animal", "goldfish", "Goldfish"),
    ("animal", "1F98B", "Butterfly"),
    ("animal", "1F422", "Turtle"),
    ("animal", "1F420", "Tropical fish"),
    ("animal", "1F438", "Frog"),
    ("object", "teapot-with-flowers", "Teapot with flowers"),
    ("object", "sphere", "Sphere"),
    ("object", "1F680", "Rocket"),
    ("object", "2602", "Umbrella"),
    ("object", "1F382", "Birthday cake"),
    ("object", "1F9F8", "Teddy bear"),
    ("portrait", "portrait", "Portrait"),
    ("portrait", "1F9D1", "Person"),
    ("scene", "mountain-lake", "Mountain lake"),
    ("scene", "1F3E1", "House with garden"),
];

const OPENMOJI_CREDIT: &str = "OpenMoji, CC BY-SA 4.0";

const OPENMOJI_NOTICE: &str = "\
The drawings named by a code point (such as 1F98B.svg) are from OpenMoji, the open-source emoji and icon project,
https://openmoji.org, unchanged. Their licence is CC BY-SA 4.0, https://creativecommons.org/licenses/by-sa/4.0/,
whose text follows. What Scumble made of them, with colours of its own, lies beside them under the same name and the
same licence. The other drawings here are part of Scumble and under its licence.

";

/// Longer side of the thumbnails: twice what the page shows them in.
const THUMBNAIL_PX: f64 = 280.0;

/// Largest distance of a drawn line from its true place, in du of a thumbnail.
const LINE_TOLERANCE_DU: f64 = 0.1 * LONGER_SIDE_DU / THUMBNAIL_PX;

/// Fills `folder`: of `pear.svg` there are its lines as `pear.work`, with scribbles as `pear.colored.work`, both of exact
/// bytes, which open without a reader of SVG, and the picture of these, `pear.png`; with them the licence of what is not
/// ours, and `index.json`: a list of `{kind, file, name, credit}` in the order to show.
pub(crate) fn collect(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    let mut entries = Vec::new();
    for (kind, stem, name) in SAMPLES {
        let (drawing, credit) = source(stem);
        write(&drawing, folder, stem).with_context(|| drawing.display().to_string())?;
        entries.push(json!({"kind": kind, "file": format!("{stem}.svg"), "name": name, "credit": credit}));
    }
    let licence = fs::read_to_string(root().join("node_modules/openmoji/LICENSE.txt"))?;
    fs::write(folder.join("LICENSE-OPENMOJI.txt"), format!("{OPENMOJI_NOTICE}{licence}"))?;
    Ok(fs::write(folder.join("index.json"), serde_json::to_string(&entries)?)?)
}

/// Where a drawing lies, and whose it is.
fn source(stem: &str) -> (PathBuf, &'static str) {
    let file = format!("{stem}.svg");
    let own = root().join(OWN).join(&file);
    if own.is_file() { (own, "Scumble") } else { (root().join(OPENMOJI_BLACK).join(file), OPENMOJI_CREDIT) }
}

fn write(drawing: &Path, folder: &Path, stem: &str) -> Result<()> {
    let svg = fs::read(drawing)?;
    let mut document = Document::new(import_svg(&svg)?.drawing);
    write_work(&document, folder, stem, "work")?;
    let scribbles = root().join(OWN).join(stem).with_extension("json");
    let json = fs::read(&scribbles).with_context(|| scribbles.display().to_string())?;
    document.scribbles = read_scribbles(&json, &document.drawing)?.scribbles;
    write_work(&document, folder, stem, "colored.work")?;
    fs::write(folder.join(stem).with_extension("png"), thumbnail(&document)?)?;
    Ok(fs::write(folder.join(stem).with_extension("svg"), svg)?)
}

fn write_work(document: &Document, folder: &Path, stem: &str, ending: &str) -> Result<()> {
    let work = Work { sample: Some(format!("{stem}.svg")), ..Work::new(document.clone()) };
    Ok(fs::write(folder.join(stem).with_extension(ending), exact::write(&work))?)
}

/// What Scumble makes of a document, as PNG.
fn thumbnail(document: &Document) -> Result<Vec<u8>> {
    let mut picture = Picture::new(&document.drawing)?;
    let shapes = &line_shapes(&document.drawing, Some(picture.map()), LINE_TOLERANCE_DU);
    let scale = THUMBNAIL_PX / LONGER_SIDE_DU;
    let size = document.drawing.size_du() * scale;
    let [width_px, height_px] = [size.width, size.height].map(|side| side.round() as u32);
    let view = View { px_from_du: Affine::scale(scale), width_px, height_px };
    let paper = Some(Srgb8([255; 3]));
    let painted = paint(&Scene { paper, field: picture.update(document)?, shapes }, &view);
    Ok(scumble_io::write_png(width_px, height_px, &painted.rgba)?)
}

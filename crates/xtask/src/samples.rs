//! The drawings that the page offers: a dozen of OpenMoji's, copied out of the npm package, and our own.

use crate::process::root;
use anyhow::{Context, Result};
use scumble_core::{Document, Work, exact};
use scumble_io::{import_svg, read_scribbles};
use std::fs;
use std::path::Path;

/// OpenMoji's black line drawings, from the top of the repository.
pub(crate) const OPENMOJI_BLACK: &str = "node_modules/openmoji/black/svg";

const OPENMOJI: [(&str, &str); 12] = [
    ("1F98B", "Butterfly"),
    ("1F34E", "Apple"),
    ("1F422", "Turtle"),
    ("1F33B", "Sunflower"),
    ("1F420", "Tropical fish"),
    ("1F9F8", "Teddy bear"),
    ("1F438", "Frog"),
    ("1F9D1", "Person"),
    ("1F382", "Birthday cake"),
    ("2602", "Umbrella"),
    ("1F680", "Rocket"),
    ("1F3E1", "House with garden"),
];

const OPENMOJI_CREDIT: &str = "OpenMoji, CC BY-SA 4.0";

const OPENMOJI_NOTICE: &str = "\
The drawings named by a code point (such as 1F98B.svg) are from OpenMoji, the open-source emoji and icon project,
https://openmoji.org, unchanged. Their licence is CC BY-SA 4.0, https://creativecommons.org/licenses/by-sa/4.0/,
whose text follows. The other drawings here are part of Scumble and under its licence.

";

/// Fills `folder` with the drawings, each also as a `.work` of exact bytes, which opens without a reader of SVG; the
/// licence of those that are not ours; and `index.json`: a list of `{file, name, credit}` in the order to show.
pub(crate) fn collect(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    let mut entries = collect_own(folder)?;
    for (code, name) in OPENMOJI {
        let file = format!("{code}.svg");
        let drawing = root().join(OPENMOJI_BLACK).join(&file);
        write(&drawing, &folder.join(&file))?;
        entries.push(entry(&file, name, OPENMOJI_CREDIT));
    }
    let licence = fs::read_to_string(root().join("node_modules/openmoji/LICENSE.txt"))?;
    fs::write(folder.join("LICENSE-OPENMOJI.txt"), format!("{OPENMOJI_NOTICE}{licence}"))?;
    Ok(fs::write(folder.join("index.json"), format!("[\n{}\n]\n", entries.join(",\n")))?)
}

/// Our own: `web/samples/two-words.svg` is shown as "Two words".
fn collect_own(folder: &Path) -> Result<Vec<String>> {
    let mut entries = Vec::new();
    for path in crate::dist::files_in(&root().join("web/samples"))? {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        if let Some(stem) = file.strip_suffix(".svg") {
            write(&path, &folder.join(&*file))?;
            entries.push(entry(&file, &capitalised(&stem.replace('-', " ")), "Scumble"));
        }
    }
    Ok(entries)
}

/// Copies a drawing, and writes it as work, with the scribbles of a `.json` of the same name if there is one.
fn write(drawing: &Path, to: &Path) -> Result<()> {
    let svg = fs::read(drawing).with_context(|| drawing.display().to_string())?;
    let mut document = Document::new(import_svg(&svg)?.drawing);
    if let Ok(json) = fs::read(drawing.with_extension("json")) {
        document.scribbles = read_scribbles(&json, &document.drawing)?.scribbles;
    }
    let sample = to.file_name().map(|name| name.to_string_lossy().into_owned());
    let work = Work { sample, ..Work::new(document) };
    fs::write(to.with_extension("work"), exact::write(&work))?;
    Ok(fs::write(to, svg)?)
}

fn entry(file: &str, name: &str, credit: &str) -> String {
    format!(r#"  {{"file": "{file}", "name": "{name}", "credit": "{credit}"}}"#)
}

fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

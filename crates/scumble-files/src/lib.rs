//! The page's second module: files, links and pictures for other programs, which most visits never need.
//!
//! Work goes in and out as its exact bytes ([`scumble_core::exact`]), so that the module with the editor knows no other
//! form of it. What is opened is in [`opening`], what is exported in [`exporting`], codes for cameras in [`qr`]; this is what
//! JavaScript calls.

pub mod exporting;
pub mod opening;
pub mod qr;

use std::mem::take;

use exporting::Wanted;
use js_sys::Uint8Array;
use opening::Content;
use scumble_core::{Swatch, Work, exact};
use scumble_io::{LinkError, MAX_FILE_BYTES, PageSize, PaletteKind, write_link, write_palette};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// Work that was opened, or a palette, or a picture to trace.
#[wasm_bindgen]
#[derive(Clone, Debug, Default)]
pub struct Opened {
    /// Its exact bytes; none for what is no work.
    #[wasm_bindgen(getter_with_clone)]
    pub work: Vec<u8>,
    /// What was left out of it, in words; empty where nothing was.
    #[wasm_bindgen(getter_with_clone)]
    pub notes: String,
    /// The name of the sample whose lines are to be put into it ([`on_sample`]), where it came without lines.
    #[wasm_bindgen(getter_with_clone)]
    pub lacks: Option<String>,
    /// The swatches of a palette: the colour as #rrggbb and the name of each, in turn.
    #[wasm_bindgen(getter_with_clone)]
    pub palette: Option<Vec<String>>,
    /// The file of the picture under the work's lines, which the work knows as number [`scumble_io::FILE_IMAGE`]; or,
    /// without work, a picture to trace.
    #[wasm_bindgen(getter_with_clone)]
    pub image: Option<Vec<u8>>,
}

impl Opened {
    fn work(mut work: Work, notes: String) -> Self {
        let image = Some(take(&mut work.image)).filter(|image| !image.is_empty());
        let lacks = opening::lacking_sample(&work);
        Self { work: exact::write(&work), notes, lacks, image, ..Self::default() }
    }

    fn palette(swatches: Vec<Swatch>, notes: String) -> Self {
        let palette =
            swatches.into_iter().flat_map(|swatch| [swatch.color.to_string(), swatch.name]).collect();
        Self { palette: Some(palette), notes, ..Self::default() }
    }

    fn image(image: Vec<u8>) -> Self {
        Self { image: Some(image), ..Self::default() }
    }
}

/// Opens a file: a `.scumble`, a palette, a picture to trace, or else a drawing of another program.
///
/// # Errors
/// A sentence for people, where it is none of these, damaged, or beyond the limits.
#[wasm_bindgen]
pub fn open(file: &Uint8Array, name: &str) -> Result<Opened, JsError> {
    // So many bytes that it is plain that there are too many.
    let bytes = file.subarray(0, MAX_FILE_BYTES as u32 + 1).to_vec();
    Ok(match opening::file(&bytes, name)? {
        Content::Work(work, notes) => Opened::work(*work, notes),
        Content::Palette(swatches, notes) => Opened::palette(swatches, notes),
        Content::Image => Opened::image(bytes),
    })
}

/// Opens a link, or its part from `#` on.
///
/// # Errors
/// A sentence for people, where it is none, or damaged.
#[wasm_bindgen(js_name = openLink)]
pub fn open_link(link: &str) -> Result<Opened, JsError> {
    Ok(Opened::work(scumble_io::read_link(link)?, String::new()))
}

/// Puts a sample's lines, given as work of its own, into work that came without.
///
/// # Errors
/// Where either is damaged.
#[wasm_bindgen(js_name = onSample)]
pub fn on_sample(work: &[u8], sample: &[u8]) -> Result<Vec<u8>, JsError> {
    Ok(exact::write(&opening::on_sample(opening::exact(work)?, opening::exact(sample)?)))
}

/// The `.scumble` file that keeps some work, with the file of the picture under its lines if that is there.
///
/// # Errors
/// A sentence for people, where it could not be read again.
#[wasm_bindgen]
pub fn save(work: &[u8], image: Option<Vec<u8>>) -> Result<Vec<u8>, JsError> {
    Ok(opening::file_of(opening::exact(work)?, image.unwrap_or_default())?)
}

/// The file of a palette, given as [`Opened::palette`] gives it, of the kind of an extension; GIMP's for another.
///
/// # Errors
/// A sentence for people, where there is no colour.
#[wasm_bindgen(js_name = palette)]
pub fn palette_file(swatches: Vec<String>, extension: &str) -> Result<Vec<u8>, JsError> {
    let palette: Vec<_> = swatches.chunks_exact(2).filter_map(swatch).collect();
    let kind = PaletteKind::of_extension(extension).unwrap_or(PaletteKind::Gpl);
    Ok(write_palette(&palette, kind)?)
}

fn swatch(color_and_name: &[String]) -> Option<Swatch> {
    let [color, name] = color_and_name else { return None };
    Some(Swatch { color: color.parse().ok()?, name: name.clone() })
}

/// The longer side of the page that some work came with, in pixels; none where it came without. A picture of that size is exactly
/// as large.
///
/// # Errors
/// A sentence for people, where the work is damaged.
#[wasm_bindgen(js_name = pagePx)]
pub fn page_px(work: &[u8]) -> Result<Option<u32>, JsError> {
    Ok(PageSize::of(&opening::exact(work)?).map(|size| size.longer_px()))
}

/// The picture as SVG, with the work in it; `raster` is a PNG of the field alone, on the same paper, for its shades.
///
/// # Errors
/// A sentence for people, where the work is too much for a file.
#[wasm_bindgen]
pub fn svg(
    work: &[u8],
    field: &[u8],
    size_px: u32,
    lines: bool,
    transparent: bool,
    raster: &[u8],
) -> Result<Vec<u8>, JsError> {
    Ok(Wanted { work, field, size_px, lines, transparent }.svg(raster)?)
}

/// The picture as PDF.
///
/// # Errors
/// A sentence for people, where the work is damaged.
#[wasm_bindgen]
pub fn pdf(
    work: &[u8],
    field: &[u8],
    size_px: u32,
    lines: bool,
    transparent: bool,
) -> Result<Vec<u8>, JsError> {
    Ok(Wanted { work, field, size_px, lines, transparent }.pdf()?)
}

/// The link to some work, from `#` on; none where it is too large for one.
///
/// # Errors
/// A sentence for people, where the work is damaged.
#[wasm_bindgen]
pub fn link(work: &[u8]) -> Result<Option<String>, JsError> {
    match write_link(&opening::exact(work)?) {
        Ok(link) => Ok(Some(link.fragment)),
        Err(LinkError::TooLarge) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// A QR code.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Code {
    /// Modules of a side, with the blank ones around.
    pub size: u32,
    /// SVG path data of the dark modules, one unit each.
    #[wasm_bindgen(getter_with_clone)]
    pub path: String,
}

/// The QR code of a text; none where it is too long for one.
#[wasm_bindgen(js_name = qrCode)]
pub fn qr_code(text: &str) -> Option<Code> {
    qr::code(text).map(|qr::Code { size, path }| Code { size, path })
}

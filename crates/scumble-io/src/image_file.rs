//! PNG and JPEG files as pictures to trace: recognised by their first bytes, measured by their heads and followed to
//! their ends, never decoded. That is left to who shows them.
//!
//! PNG is chunks after a signature (W3C Recommendation, third edition, section 5), JPEG is segments that begin with
//! markers (ITU-T T.81, annex B).

use thiserror::Error;

use crate::checksum::checksum;

/// Largest file of a picture, in bytes.
pub const MAX_IMAGE_BYTES: usize = 8 << 20;

/// Longest side of a picture, in pixels.
const MAX_SIDE_PX: u32 = 16_384;

/// Most pixels of a picture.
const MAX_PIXELS: u64 = 64_000_000;

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
const JPEG: &[u8] = b"\xff\xd8\xff";

/// What pictures of other kinds have at some place near their beginning.
const OTHERS: [(usize, &[u8], &str); 8] = [
    (0, b"GIF8", "GIF"),
    (8, b"WEBP", "WebP"),
    (0, b"II*\0", "TIFF"),
    (0, b"MM\0*", "TIFF"),
    (4, b"ftyphei", "HEIC"),
    (4, b"ftypmif1", "HEIF"),
    (4, b"ftypavif", "AVIF"),
    (0, b"8BPS", "Photoshop"),
];

/// Why a file is not a picture that can be traced.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ImageError {
    /// Neither PNG nor JPEG.
    #[error(
        "the file is no PNG or JPEG picture, or its beginning is missing; save the picture again as one of these"
    )]
    NoImage,
    /// A picture of another kind.
    #[error("{0} pictures cannot be opened; save the picture as PNG or JPEG")]
    OtherKind(&'static str),
    /// More bytes than are kept.
    #[error("the picture’s file is larger than {} MiB; save it with fewer pixels, or as JPEG", MAX_IMAGE_BYTES >> 20)]
    TooLarge,
    /// More pixels than are shown.
    #[error(
        "the picture has {width_px} × {height_px} pixels; scale it down to 16,384 a side and 64 million in all, at most"
    )]
    TooManyPixels {
        /// Pixels of a row.
        width_px: u32,
        /// Rows.
        height_px: u32,
    },
    /// Bytes are missing, or are not as they should be.
    #[error("the picture is damaged: {0}; save or download it again")]
    Damaged(&'static str),
}

/// Whether a file begins as a picture that can be traced.
pub fn is_image(bytes: &[u8]) -> bool {
    bytes.starts_with(PNG) || bytes.starts_with(JPEG)
}

/// The kind of picture that a file is and that cannot be opened.
pub fn other_kind(bytes: &[u8]) -> Option<&'static str> {
    let is_there =
        |(at, mark, _): &&(usize, &[u8], &str)| bytes.get(*at..).is_some_and(|b| b.starts_with(mark));
    OTHERS.iter().find(is_there).map(|(_, _, kind)| *kind)
}

/// Checks that a file is a whole PNG or JPEG within the limits. What its pixels are is not looked at.
///
/// # Errors
/// When it is not.
pub fn check_image(bytes: &[u8]) -> Result<(), ImageError> {
    if bytes.len() > MAX_IMAGE_BYTES {
        return Err(ImageError::TooLarge);
    }
    let size_px = if let Some(chunks) = bytes.strip_prefix(PNG) {
        png_size(chunks)
    } else if bytes.starts_with(JPEG) {
        jpeg_size(bytes)
    } else {
        return Err(other_kind(bytes).map_or(ImageError::NoImage, ImageError::OtherKind));
    };
    check_size(size_px?)
}

fn check_size([width_px, height_px]: [u32; 2]) -> Result<(), ImageError> {
    if width_px == 0 || height_px == 0 {
        return Err(ImageError::Damaged("it says that it has no pixels"));
    }
    let pixels = u64::from(width_px) * u64::from(height_px);
    if width_px.max(height_px) > MAX_SIDE_PX || pixels > MAX_PIXELS {
        return Err(ImageError::TooManyPixels { width_px, height_px });
    }
    Ok(())
}

const CUT_OFF: ImageError = ImageError::Damaged("its end is missing");
const NO_SIZE: ImageError = ImageError::Damaged("it does not say how large it is");
const CHANGED: ImageError = ImageError::Damaged("a part of it was changed");

/// Width and height of a PNG that has all its chunks.
fn png_size(chunks: &[u8]) -> Result<[u32; 2], ImageError> {
    let (b"IHDR", [a, b, c, d, e, f, g, h, ..], mut rest) = chunk(chunks)? else { return Err(NO_SIZE) };
    let size_px = [[*a, *b, *c, *d], [*e, *f, *g, *h]].map(u32::from_be_bytes);
    loop {
        let (name, _, next) = chunk(rest)?;
        if name == b"IEND" {
            return Ok(size_px);
        }
        rest = next;
    }
}

type Chunk<'a> = (&'a [u8], &'a [u8], &'a [u8]);

/// Name and data of a PNG's chunk, and what comes after it: before them stands the length of the data, behind them a
/// checksum of both.
fn chunk(bytes: &[u8]) -> Result<Chunk<'_>, ImageError> {
    let (length, rest) = bytes.split_first_chunk().ok_or(CUT_OFF)?;
    let length = (u32::from_be_bytes(*length) as usize).saturating_add(4);
    let (named, rest) = rest.split_at_checked(length).ok_or(CUT_OFF)?;
    let (check, rest) = rest.split_first_chunk().ok_or(CUT_OFF)?;
    if checksum(named) != u32::from_be_bytes(*check) {
        return Err(CHANGED);
    }
    let (name, data) = named.split_at(4);
    Ok((name, data, rest))
}

/// Width and height of a JPEG that has its end.
fn jpeg_size(bytes: &[u8]) -> Result<[u32; 2], ImageError> {
    let mut size_px = None;
    let mut rest = &bytes[2..];
    loop {
        let (marker, data, next) = segment(rest)?;
        rest = next;
        match (marker, data) {
            // A frame, in any of its ways of coding.
            (0xc0..=0xc3 | 0xc5..=0xc7 | 0xc9..=0xcb | 0xcd..=0xcf, [_, a, b, c, d, ..]) => {
                size_px = Some([[*c, *d], [*a, *b]].map(|side| u16::from_be_bytes(side).into()));
            }
            (0xda, _) => break,
            _ => {}
        }
    }
    // A scan, in which 0xff never stands before the byte of the end.
    let is_whole = rest.windows(2).any(|pair| pair == b"\xff\xd9");
    if is_whole { size_px.ok_or(NO_SIZE) } else { Err(CUT_OFF) }
}

/// Marker and data of a JPEG's segment before the first scan, and what comes after it: before the marker stands 0xff, as
/// often as one likes, behind it the length of the data with its own two bytes.
fn segment(bytes: &[u8]) -> Result<(u8, &[u8], &[u8]), ImageError> {
    let fill = bytes.iter().take_while(|byte| **byte == 0xff).count();
    let (marker, after) = bytes[fill..].split_first().ok_or(CUT_OFF)?;
    let length = after.first_chunk().ok_or(CUT_OFF)?;
    let (data, next) = after.split_at_checked(u16::from_be_bytes(*length).into()).ok_or(CUT_OFF)?;
    match data.get(2..) {
        Some(data) if fill > 0 => Ok((*marker, data, next)),
        _ => Err(CHANGED),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_limited_by_sides_and_in_all() {
        assert_eq!(check_size([16_384, 3_906]), Ok(()));
        assert_eq!(check_size([8_000, 8_000]), Ok(()));
        for size_px @ [width_px, height_px] in [[16_385, 1], [1, 16_385], [8_001, 8_000]] {
            assert_eq!(check_size(size_px), Err(ImageError::TooManyPixels { width_px, height_px }));
        }
        assert!(matches!(check_size([0, 5]), Err(ImageError::Damaged(_))));
    }
}

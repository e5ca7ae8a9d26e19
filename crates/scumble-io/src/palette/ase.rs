//! Adobe Swatch Exchange: blocks, each a group's begin or end, or a colour with its name. All numbers are big-endian.
//!
//! RGB is taken as sRGB and gray as a level of it. CMYK has no profile here: each ink takes its part of the light,
//! `r = (1 − c) (1 − k)`. LAB is CIE L*a*b* in daylight D50 (L from 0 to 1), adapted to D65 by Bradford's matrix.

use scumble_core::Srgb8;
use scumble_core::color::srgb_from_linear;

use super::{ReadPalette, push};
use crate::error::PaletteError;

/// The first bytes.
pub(super) const MARK: &[u8] = b"ASEF";

const VERSION: [u8; 4] = [0, 1, 0, 0];
const COLOR: u16 = 1;

/// A colour that is neither spot nor global.
const NORMAL: [u8; 2] = [0, 2];

/// The rest of a file, or of a block. What is asked for beyond its end is `None`.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_be_bytes)
    }

    fn u32(&mut self) -> Option<usize> {
        self.array().map(|bytes| u32::from_be_bytes(bytes) as usize)
    }

    fn floats<const N: usize>(&mut self) -> Option<[f64; N]> {
        let mut floats = [0.0; N];
        for float in &mut floats {
            *float = f64::from(f32::from_be_bytes(self.array()?));
        }
        Some(floats)
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<ReadPalette, PaletteError> {
    let mut bytes = Bytes(bytes);
    let blocks = head(&mut bytes).ok_or(PaletteError::NoSwatches)?;
    let mut palette = ReadPalette::default();
    for block in 1..=blocks {
        match read_block(&mut bytes).ok_or(PaletteError::CutOff { block, blocks })? {
            Block::Color(color, name) => push(&mut palette, color, &name)?,
            Block::UnknownColor => palette.unknown += 1,
            Block::Other => {}
        }
    }
    Ok(palette)
}

/// How many blocks there are; `None` where a file begins otherwise.
fn head(bytes: &mut Bytes) -> Option<usize> {
    let is_known = bytes.take(MARK.len())? == MARK;
    bytes.take(VERSION.len())?;
    bytes.u32().filter(|_| is_known)
}

/// What a block is of.
enum Block {
    /// With its name.
    Color(Srgb8, String),
    /// In a space that is not known, or with numbers that are none.
    UnknownColor,
    /// A group.
    Other,
}

fn read_block(bytes: &mut Bytes) -> Option<Block> {
    let kind = bytes.u16()?;
    let length = bytes.u32()?;
    let block = Bytes(bytes.take(length)?);
    if kind == COLOR { color(block) } else { Some(Block::Other) }
}

fn color(mut block: Bytes) -> Option<Block> {
    let name_len = usize::from(block.u16()?);
    let name = name(block.take(2 * name_len)?);
    let unit = match &block.array()? {
        b"RGB " => block.floats()?,
        b"Gray" | b"GRAY" => block.floats::<1>().map(|[gray]| [gray; 3])?,
        b"CMYK" => block.floats().map(|[c, m, y, k]| [c, m, y].map(|ink: f64| (1.0 - ink) * (1.0 - k)))?,
        b"LAB " | b"Lab " => srgb_from_lab(block.floats()?),
        _ => return Some(Block::UnknownColor),
    };
    let is_sound = unit.iter().all(|channel| channel.is_finite());
    let rgb = unit.map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8);
    Some(if is_sound { Block::Color(Srgb8(rgb), name) } else { Block::UnknownColor })
}

/// A name in UTF-16, which ends in a zero.
fn name(bytes: &[u8]) -> String {
    let units: Vec<_> = bytes.chunks_exact(2).map(|unit| u16::from_be_bytes([unit[0], unit[1]])).collect();
    String::from_utf16_lossy(&units)
}

/// White in daylight D50: X, Y, Z (ICC profile connection space).
const D50: [f64; 3] = [0.9642, 1.0, 0.8249];

/// Linear sRGB of X, Y, Z in D50, by Bradford's adaptation to D65.
const LINEAR_FROM_D50: [[f64; 3]; 3] = [
    [3.133_856_1, -1.616_866_7, -0.490_614_6],
    [-0.978_768_4, 1.916_141_5, 0.033_454_0],
    [0.071_945_3, -0.228_991_4, 1.405_242_7],
];

/// L from 0 to 1, a and b from −128 to 127 (CIE 15:2004).
fn srgb_from_lab([l, a, b]: [f64; 3]) -> [f64; 3] {
    let y = (100.0 * l + 16.0) / 116.0;
    let part = |t: f64| if t > 6.0 / 29.0 { t * t * t } else { (t - 4.0 / 29.0) * 108.0 / 841.0 };
    let [x, y, z] = [y + a / 500.0, y, y - b / 200.0].map(part);
    let [x, y, z] = [x * D50[0], y * D50[1], z * D50[2]];
    LINEAR_FROM_D50
        .map(|row| srgb_from_linear((row[0] * x + row[1] * y + row[2] * z).clamp(0.0, f64::INFINITY)))
}

pub(super) fn written(colors: &[(Srgb8, String)]) -> Vec<u8> {
    let mut bytes = [MARK, &VERSION, &(colors.len() as u32).to_be_bytes()].concat();
    for (color, name) in colors {
        let name: Vec<u8> = name.encode_utf16().chain([0]).flat_map(u16::to_be_bytes).collect();
        let floats = color.0.map(|channel| (f32::from(channel) / 255.0).to_be_bytes()).concat();
        let name_len = (name.len() / 2) as u16;
        let block = [&name_len.to_be_bytes()[..], &name, b"RGB ", &floats, &NORMAL].concat();
        bytes.extend([&COLOR.to_be_bytes()[..], &(block.len() as u32).to_be_bytes(), &block].concat());
    }
    bytes
}

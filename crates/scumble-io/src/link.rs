//! Work as the fragment of a link: `#1.` and the packed work, checked, in base64url.
//!
//! A fragment never reaches a server.

use scumble_core::Work;

use crate::error::LinkError;
use crate::packed::{self, PackedSizes};

/// Longest link that is read, in characters from its `#` on.
pub const MAX_LINK: usize = 65_536;

/// The version whose links are written; what comes after it in a newer one cannot be read.
const VERSION: u32 = 1;

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Bytes of the checksum, which comes last.
const CHECK: usize = 4;

/// A link and what its parts take.
#[derive(Clone, Debug)]
pub struct Link {
    /// The fragment, with its `#`.
    pub fragment: String,
    /// Bytes of its parts.
    pub sizes: PackedSizes,
}

/// The link to some work. Of a sample only the name is in it.
///
/// # Errors
/// When the work is too large for a link.
pub fn write_link(work: &Work) -> Result<Link, LinkError> {
    let (mut bytes, sizes) = packed::pack(work).ok_or(LinkError::TooLarge)?;
    bytes.extend(checksum(&bytes).to_be_bytes());
    let fragment = format!("#{VERSION}.{}", text(&bytes));
    if fragment.len() > MAX_LINK { Err(LinkError::TooLarge) } else { Ok(Link { fragment, sizes }) }
}

/// The work in a link, or in its part from `#` on.
///
/// # Errors
/// When it is no link to work, or damaged, or of a newer version, or beyond the limits.
pub fn read_link(link: &str) -> Result<Work, LinkError> {
    let (_, fragment) = link.trim().split_once('#').ok_or(LinkError::NoLink)?;
    let (version, text) = fragment.split_once('.').ok_or(LinkError::NoLink)?;
    let is_number = !version.is_empty() && version.bytes().all(|digit| digit.is_ascii_digit());
    match version.parse() {
        _ if !is_number => return Err(LinkError::NoLink),
        Ok(VERSION) if !version.starts_with('0') => {}
        Ok(0..=VERSION) => return Err(LinkError::Damaged),
        _ => return Err(LinkError::Newer),
    }
    if fragment.len() >= MAX_LINK {
        return Err(LinkError::TooLong);
    }
    let bytes = bytes(text).ok_or(LinkError::Damaged)?;
    let (packed, check) = bytes.split_last_chunk::<CHECK>().ok_or(LinkError::Damaged)?;
    if checksum(packed).to_be_bytes() != *check {
        return Err(LinkError::Damaged);
    }
    packed::unpack(packed).ok_or(LinkError::Damaged)
}

/// CRC-32 as in PNG and ZIP: no damage of up to 32 neighbouring bits goes unseen.
fn checksum(bytes: &[u8]) -> u32 {
    let after = |rest: u32, _| rest >> 1 ^ if rest & 1 == 1 { 0xedb8_8320 } else { 0 };
    !bytes.iter().fold(!0, |rest, byte| (0..8).fold(rest ^ u32::from(*byte), after))
}

/// Base64url without padding (RFC 4648, section 5).
fn text(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let bits =
            (0..3).fold(0, |bits, i| bits << 8 | usize::from(group.get(i).copied().unwrap_or_default()));
        for i in 0..=group.len() {
            text.push(char::from(DIGITS[bits >> (18 - 6 * i) & 63]));
        }
    }
    text
}

/// The bytes of such a text, or `None` where it is none, or where bits are left that belong to no byte.
fn bytes(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() * 3 / 4);
    let (mut bits, mut count) = (0, 0);
    for digit in text.bytes() {
        let value = DIGITS.iter().position(|known| *known == digit)?;
        (bits, count) = ((bits << 6 | value) & 0xfff, count + 6);
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    (count < 6 && bits & ((1 << count) - 1) == 0).then_some(bytes)
}

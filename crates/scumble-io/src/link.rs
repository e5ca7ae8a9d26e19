//! Work as the fragment of a link: `#1.` and the packed work, checked, in base64url.
//!
//! A fragment never reaches a server.

use scumble_core::Work;

use crate::base64;
use crate::checksum::checksum;
use crate::error::LinkError;
use crate::packed::{self, PackedSizes};

/// Longest link that is read, in characters from its `#` on.
pub const MAX_LINK: usize = 65_536;

/// The version whose links are written; what comes after it in a newer one cannot be read.
const VERSION: u32 = 1;

/// Bytes of the checksum, which comes last.
const CHECK: usize = 4;

/// What a sentence or a mail puts behind a link.
const AFTER_LINKS: [char; 12] = ['.', ',', ';', ':', '!', '?', ')', ']', '>', '"', '\'', '='];

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
    let fragment = format!("#{VERSION}.{}", base64::text(&bytes, base64::URL));
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
    let bytes = base64::bytes(text.trim_end_matches(AFTER_LINKS), base64::URL).ok_or(LinkError::Damaged)?;
    let (packed, check) = bytes.split_last_chunk::<CHECK>().ok_or(LinkError::Damaged)?;
    if checksum(packed).to_be_bytes() != *check {
        return Err(LinkError::Damaged);
    }
    packed::unpack(packed).ok_or(LinkError::Damaged)
}

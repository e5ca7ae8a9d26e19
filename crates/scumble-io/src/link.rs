//! Work as the fragment of a link: `#1.` and the packed work, checked, in base64url.
//!
//! A fragment never reaches a server.

use scumble_core::Work;
use scumble_core::work::are_too_many_shades;

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
/// When the work is too large for a link, or has too many shades.
pub fn write_link(work: &Work) -> Result<Link, LinkError> {
    check_shades(work)?;
    let link = link(work).filter(|link| link.fragment.len() <= MAX_LINK);
    link.ok_or(LinkError::TooLarge)
}

/// The link, though it may be longer than a reader takes; none where there is no packing the work.
fn link(work: &Work) -> Option<Link> {
    let (mut bytes, sizes) = packed::pack(work)?;
    bytes.extend(checksum(&bytes).to_be_bytes());
    Some(Link { fragment: format!("#{VERSION}.{}", base64::text(&bytes, base64::URL)), sizes })
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
    let work = packed::unpack(packed).ok_or(LinkError::Damaged)?;
    check_shades(&work)?;
    Ok(work)
}

fn check_shades(work: &Work) -> Result<(), LinkError> {
    if are_too_many_shades(&work.document.scribbles) { Err(LinkError::TooManyShades) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use kurbo::Point;
    use scumble_core::work::MAX_SHADES;
    use scumble_core::{Paint, Scribble, ScribbleKind, Shading};

    use super::*;

    #[test]
    fn a_link_that_somebody_else_wrote_with_too_many_shades_is_refused() {
        let kind = ScribbleKind::Shade(Shading::default());
        let shade = Scribble { color: Paint::Clear, kind, width_du: 500.0, points: vec![Point::ZERO] };
        let mut work = Work::blank();
        for (count, refused) in [(MAX_SHADES, None), (MAX_SHADES + 1, Some(LinkError::TooManyShades))] {
            work.document.scribbles = vec![shade.clone(); count];
            let Link { fragment, .. } = link(&work).expect("it is small");
            assert_eq!(read_link(&fragment).err(), refused);
        }
    }
}

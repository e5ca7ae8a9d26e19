//! What tells damaged bytes from those that were written.

/// CRC-32 as in PNG and ZIP: no damage of up to 32 neighbouring bits goes unseen.
pub(crate) fn checksum(bytes: &[u8]) -> u32 {
    let after = |rest: u32, _| rest >> 1 ^ if rest & 1 == 1 { 0xedb8_8320 } else { 0 };
    !bytes.iter().fold(!0, |rest, byte| (0..8).fold(rest ^ u32::from(*byte), after))
}

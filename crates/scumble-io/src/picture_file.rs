//! Pictures as PNG files.

use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};
use thiserror::Error;

/// Why a picture could not be written.
#[derive(Debug, Error)]
pub enum PictureFileError {
    /// Width or height is zero, or the data has another length.
    #[error("a picture of {width_px} × {height_px} pixels needs four bytes for each; it has {bytes}")]
    Size {
        /// Width given.
        width_px: u32,
        /// Height given.
        height_px: u32,
        /// Length of the data given.
        bytes: usize,
    },
    /// The encoder failed.
    #[error("the picture could not be encoded: {0}")]
    Encode(#[from] png::EncodingError),
}

/// The bytes of a PNG file with 8-bit sRGB and straight alpha, row by row from the top.
///
/// # Errors
/// When the data is not `4 · width_px · height_px` bytes long.
pub fn write_png(width_px: u32, height_px: u32, rgba: &[u8]) -> Result<Vec<u8>, PictureFileError> {
    let expected = 4 * u64::from(width_px) * u64::from(height_px);
    if expected == 0 || expected != rgba.len() as u64 {
        return Err(PictureFileError::Size { width_px, height_px, bytes: rgba.len() });
    }
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width_px, height_px);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rgba)?;
    writer.finish()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_read_back_as_it_was_written() {
        let rgba: Vec<u8> = (0..4 * 3 * 2).map(|i| i * 10).collect();
        let file = write_png(3, 2, &rgba).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&file)).read_info().unwrap();
        let mut read = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut read).unwrap();
        assert_eq!((info.width, info.height, read), (3, 2, rgba));
    }

    #[test]
    fn data_of_another_length_is_refused() {
        assert!(write_png(3, 2, &[0; 23]).is_err());
        assert!(write_png(0, 2, &[]).is_err());
    }
}

//! A contact sheet: drawing with scribbles, truth and result of each drawing side by side, the worst first.

use scumble_solve::Pixmap;

use super::score::Score;
use super::subject::{Subject, palette_rgba};

/// Longer side of one picture on the sheet, in px.
const PICTURE_PX: usize = 224;

/// Between pictures, and between drawings.
const GAP_PX: usize = 4;

/// Height of a line of text over each drawing.
const TEXT_PX: usize = 16;

/// Drawings side by side.
const COLUMNS: usize = 3;

/// Width of what belongs to one drawing, with the space to the next.
const CELL_WIDTH_PX: usize = 3 * (PICTURE_PX + GAP_PX) + 4 * GAP_PX;

/// Height of what belongs to one drawing, with the space to the next.
const CELL_HEIGHT_PX: usize = TEXT_PX + PICTURE_PX + 2 * GAP_PX;

/// The ground between the pictures.
const GROUND: [u8; 4] = [225, 225, 225, 255];

/// The pictures of one drawing, opaque, and what is written over them.
pub(crate) struct Cell {
    text: String,
    side: f64,
    pictures: [Tile; 3],
}

/// A picture of at most [`PICTURE_PX`] a side.
struct Tile {
    width: usize,
    pixels: Vec<[u8; 4]>,
}

impl Cell {
    /// The cell of a drawing with the picture that a method made of it.
    pub(crate) fn new(id: &str, subject: &Subject, result: &Pixmap, score: &Score) -> Self {
        let size_px = PICTURE_PX as u32;
        let lines = subject.lines_picture(size_px);
        let mut drawing = Tile::white(&lines);
        drawing.lay(&lines);
        drawing.lay(&subject.scribbles_picture(size_px));
        let truth = &subject.truth;
        let rgba = truth.colors.iter().flat_map(|color| palette_rgba(*color)).collect();
        let truth = Pixmap { width_px: truth.width_px, height_px: truth.height_px, rgba };
        let pictures = [drawing, Tile::colored(&truth, &lines), Tile::colored(result, &lines)];
        Self { text: format!("{id} {:.3} {:.3}", score.side, score.area), side: score.side, pictures }
    }
}

impl Tile {
    fn white(size: &Pixmap) -> Self {
        let count = size.width_px as usize * size.height_px as usize;
        Self { width: size.width_px as usize, pixels: vec![[255; 4]; count] }
    }

    /// A picture, brought to the size of the lines by taking the nearest pixels, with the lines over it.
    fn colored(picture: &Pixmap, lines: &Pixmap) -> Self {
        let mut tile = Self::white(lines);
        tile.lay(&resized(picture, lines.width_px, lines.height_px));
        tile.lay(lines);
        tile
    }

    /// Lays a picture of the same size over this one.
    fn lay(&mut self, over: &Pixmap) {
        let (over, _) = over.rgba.as_chunks::<4>();
        for (pixel, over) in self.pixels.iter_mut().zip(over) {
            let alpha = u32::from(over[3]);
            let mix =
                |a: u8, b: u8| ((u32::from(a) * (255 - alpha) + u32::from(b) * alpha + 127) / 255) as u8;
            *pixel = [mix(pixel[0], over[0]), mix(pixel[1], over[1]), mix(pixel[2], over[2]), 255];
        }
    }
}

/// Another size by taking the nearest pixels.
fn resized(picture: &Pixmap, width_px: u32, height_px: u32) -> Pixmap {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let from = |at: u32, size: u32, of: u32| ((2 * at + 1) * of / (2 * size)) as usize;
    let row = |y: u32| from(y, height_px, picture.height_px) * picture.width_px as usize;
    let pixel = |x: u32, y: u32| pixels[row(y) + from(x, width_px, picture.width_px)];
    let rgba = (0..height_px).flat_map(|y| (0..width_px).flat_map(move |x| pixel(x, y))).collect();
    Pixmap { width_px, height_px, rgba }
}

/// Lays out the cells, the worst by its share of right sides first, row by row.
pub(crate) fn sheet(mut cells: Vec<Cell>) -> Pixmap {
    cells.sort_by(|a, b| a.side.total_cmp(&b.side));
    let rows = cells.len().div_ceil(COLUMNS).max(1);
    let mut sheet = Sheet::new(COLUMNS * CELL_WIDTH_PX, rows * CELL_HEIGHT_PX);
    for (i, cell) in cells.iter().enumerate() {
        let [x, y] = [i % COLUMNS * CELL_WIDTH_PX + 2 * GAP_PX, i / COLUMNS * CELL_HEIGHT_PX + GAP_PX];
        sheet.write(&cell.text, x, y);
        for (k, tile) in cell.pictures.iter().enumerate() {
            sheet.put(tile, x + k * (PICTURE_PX + GAP_PX), y + TEXT_PX);
        }
    }
    sheet.into_pixmap()
}

struct Sheet {
    width: usize,
    pixels: Vec<[u8; 4]>,
}

impl Sheet {
    fn new(width: usize, height: usize) -> Self {
        Self { width, pixels: vec![GROUND; width * height] }
    }

    fn put(&mut self, tile: &Tile, x: usize, y: usize) {
        for (row, pixels) in tile.pixels.chunks_exact(tile.width).enumerate() {
            self.pixels[(y + row) * self.width + x..][..tile.width].copy_from_slice(pixels);
        }
    }

    /// Writes digits, A to F, points and hyphens; all else is a space.
    fn write(&mut self, text: &str, x: usize, y: usize) {
        for (i, c) in text.chars().enumerate() {
            let glyph = GLYPHS.iter().find(|(known, _)| *known == c).map_or(0, |(_, glyph)| *glyph);
            for (row, column) in (0..5).flat_map(|row| (0..3).map(move |column| (row, column))) {
                if glyph >> (14 - 3 * row - column) & 1 == 1 {
                    self.dot(x + (4 * i + column) * DOT_PX, y + row * DOT_PX);
                }
            }
        }
    }

    fn dot(&mut self, x: usize, y: usize) {
        for row in y..y + DOT_PX {
            self.pixels[row * self.width + x..][..DOT_PX].fill([0, 0, 0, 255]);
        }
    }

    fn into_pixmap(self) -> Pixmap {
        let height_px = (self.pixels.len() / self.width) as u32;
        Pixmap { width_px: self.width as u32, height_px, rgba: self.pixels.into_flattened() }
    }
}

/// Side of a dot of a letter.
const DOT_PX: usize = 2;

/// Letters of 3 × 5 dots, row by row from the top left, the first dot in the highest of 15 bits.
const GLYPHS: [(char, u16); 18] = [
    ('0', 0b111_101_101_101_111),
    ('1', 0b010_110_010_010_111),
    ('2', 0b111_001_111_100_111),
    ('3', 0b111_001_111_001_111),
    ('4', 0b101_101_111_001_001),
    ('5', 0b111_100_111_001_111),
    ('6', 0b111_100_111_101_111),
    ('7', 0b111_001_010_010_010),
    ('8', 0b111_101_111_101_111),
    ('9', 0b111_101_111_001_111),
    ('A', 0b010_101_111_101_101),
    ('B', 0b110_101_110_101_110),
    ('C', 0b111_100_100_100_111),
    ('D', 0b110_101_101_101_110),
    ('E', 0b111_100_110_100_111),
    ('F', 0b111_100_110_100_100),
    ('.', 0b000_000_000_000_010),
    ('-', 0b000_000_111_000_000),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(side: f64, color: [u8; 4]) -> Cell {
        let tile = || Tile { width: 2, pixels: vec![color; 4] };
        Cell { text: "1F-9".into(), side, pictures: [tile(), tile(), tile()] }
    }

    #[test]
    fn the_worst_comes_first() {
        let (good, bad) = ([0, 255, 0, 255], [255, 0, 0, 255]);
        let sheet = sheet(vec![cell(0.9, good), cell(0.1, bad), cell(0.9, good), cell(0.9, good)]);
        assert_eq!(sheet.width_px as usize, COLUMNS * CELL_WIDTH_PX);
        assert_eq!(sheet.height_px as usize, 2 * CELL_HEIGHT_PX);
        let (pixels, _) = sheet.rgba.as_chunks::<4>();
        let first = pixels.iter().find(|pixel| **pixel == good || **pixel == bad);
        assert_eq!(first, Some(&bad));
        let count = |color| pixels.iter().filter(|pixel| **pixel == color).count();
        assert_eq!((count(good), count(bad)), (3 * 3 * 4, 3 * 4));
        assert!(count([0, 0, 0, 255]) > 0, "there is text");
    }

    #[test]
    fn pictures_are_laid_over_each_other_by_their_opacity() {
        let mut tile = Tile { width: 3, pixels: vec![[255; 4]; 3] };
        let rgba = [[0, 0, 0, 0], [0, 0, 0, 255], [255, 0, 0, 51]].concat();
        tile.lay(&Pixmap { width_px: 3, height_px: 1, rgba });
        assert_eq!(tile.pixels, [[255, 255, 255, 255], [0, 0, 0, 255], [255, 204, 204, 255]]);
    }

    #[test]
    fn another_size_takes_the_nearest_pixels() {
        let rgba: Vec<u8> = (0..4).flat_map(|i| [i; 4]).collect();
        let picture = Pixmap { width_px: 4, height_px: 1, rgba };
        let small = resized(&picture, 2, 1);
        assert_eq!((small.width_px, small.rgba), (2, vec![1, 1, 1, 1, 3, 3, 3, 3]));
        assert_eq!(resized(&picture, 8, 1).rgba[..12], [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1]);
    }
}

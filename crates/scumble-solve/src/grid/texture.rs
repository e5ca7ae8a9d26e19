//! Pictures of numbers, as the GPU has them: a pass computes each texel of one from texels of others.

/// Four numbers of a texel: mostly the channels of a blend-space colour, times its opacity, and the opacity.
pub type Texel = [f32; 4];

/// Texels in rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Texture {
    /// Texels of a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Row by row.
    pub texels: Vec<Texel>,
}

impl Texture {
    /// All zeros.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, texels: vec![[0.0; 4]; width * height] }
    }

    /// One pass: the texel at each column and row.
    pub fn draw(&mut self, kernel: impl Fn(i32, i32) -> Texel) {
        for (y, row) in self.texels.chunks_exact_mut(self.width.max(1)).enumerate() {
            for (x, texel) in row.iter_mut().enumerate() {
                *texel = kernel(x as i32, y as i32);
            }
        }
    }

    /// The texel at a column and a row, zeros beyond the border.
    #[inline]
    pub fn load(&self, x: i32, y: i32) -> Texel {
        let (x, y) = (x as u32 as usize, y as u32 as usize);
        if x < self.width && y < self.height { self.texels[y * self.width + x] } else { [0.0; 4] }
    }
}

#[inline]
pub(super) fn plus(a: Texel, b: Texel) -> Texel {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]
}

#[inline]
pub(super) fn minus(a: Texel, b: Texel) -> Texel {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]]
}

#[inline]
pub(super) fn times(a: Texel, factor: f32) -> Texel {
    a.map(|c| c * factor)
}

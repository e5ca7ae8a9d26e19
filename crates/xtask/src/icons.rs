//! The page's icon as pixels, for where it is installed: `icon-192.png` and `icon-512.png` as it is, and
//! `icon-maskable-512.png`, which any shape may be cut out of.

use anyhow::{Context, Result};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::fs;
use std::path::Path;

/// How much of a maskable icon's side the drawing takes. What lies within 40% of the side from its middle is never cut
/// off: the drawing's farthest point comes to 37%.
const MASKABLE_SHARE: f32 = 0.9;

/// Paints an icon in all its sizes.
pub(crate) fn write(svg: &Path, to: &Path) -> Result<()> {
    let icon = Tree::from_str(&fs::read_to_string(svg)?, &Options::default())?;
    for size_px in [192, 512] {
        fs::write(to.join(format!("icon-{size_px}.png")), png(&icon, size_px, None)?)?;
    }
    Ok(fs::write(to.join("icon-maskable-512.png"), png(&icon, 512, Some(Color::WHITE))?)?)
}

/// A square picture of the icon: whole, or small before a ground.
fn png(icon: &Tree, size_px: u16, ground: Option<Color>) -> Result<Vec<u8>> {
    let side_px = f32::from(size_px);
    let mut pixels = Pixmap::new(size_px.into(), size_px.into()).context("an icon has no size")?;
    ground.inspect(|color| pixels.fill(*color));
    let drawn_px = side_px * ground.map_or(1.0, |_| MASKABLE_SHARE);
    let (scale, shift_px) = (drawn_px / icon.size().width(), (side_px - drawn_px) / 2.0);
    let placed = Transform::from_translate(shift_px, shift_px).pre_scale(scale, scale);
    resvg::render(icon, placed, &mut pixels.as_mut());
    let straight = pixels.pixels().iter().map(|pixel| pixel.demultiply());
    let rgba: Vec<u8> = straight.flat_map(|c| [c.red(), c.green(), c.blue(), c.alpha()]).collect();
    Ok(scumble_io::write_png(size_px.into(), size_px.into(), &rgba)?)
}

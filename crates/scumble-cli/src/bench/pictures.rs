//! How long the picture of a drawing takes: opened, with one more scribble, with another colour, and without it again.

use kurbo::Rect;
use scumble_core::pace::Slices;
use scumble_core::{Document, Drawing, Paint, Scribble, Settings};
use scumble_solve::Picture;

use crate::clock::{Times, timed};
use crate::stages::{self, PAPER};

/// Longer side of the painted picture.
const SIZE_PX: u32 = 1024;

/// Scribbles that are each in turn the last one.
const TURNS: usize = 12;

/// What is timed, in the order of [`PictureTimes::rows`].
pub(super) const ROWS: [&str; 12] = [
    "drawing to picture, one scribble",
    "drawing to picture, all scribbles",
    "  … the longest slice of it, with spread",
    "drawing to rough picture, all scribbles",
    "drawing to what is in view at 400 %",
    "one more scribble (color to solve)",
    "  … of which color",
    "  … of which analyse",
    "  … of which factor",
    "it is recoloured (color to solve)",
    "  … of which solve",
    "it is taken back (color to solve)",
];

/// Times of one drawing.
#[derive(Debug, Default)]
pub(super) struct PictureTimes {
    pub(super) rows: [Times; ROWS.len()],
}

impl PictureTimes {
    /// Opens a drawing, then draws and recolours some scribbles, each as the last of all.
    pub(super) fn of(drawing: &Drawing, scribbles: &[Scribble]) -> anyhow::Result<Self> {
        let mut times = Self::default();
        let first = &scribbles[..scribbles.len().min(1)];
        let (opened, open_ms) = timed(|| {
            let mut picture = Picture::new(drawing)?;
            stages::spread(&mut picture, first, &[], &Settings::default())?;
            let view = stages::page_view(drawing, SIZE_PX);
            stages::paint_page(picture.mesh().spread(Settings::default().blend)?, &[], &view, Some(PAPER));
            Ok::<_, anyhow::Error>(picture)
        });
        let mut picture = opened?;
        times.rows[0].push(open_ms);
        times.rows[1].push(picture_ms(drawing, scribbles, |_| ())?);
        times.rows[2].push(longest_slice_ms(drawing, scribbles)?);
        times.rows[3].push(picture_ms(drawing, scribbles, Picture::roughen)?);
        let in_view_du = middle(drawing.frame());
        times.rows[4].push(picture_ms(drawing, scribbles, |picture| picture.narrow(Some(in_view_du)))?);
        let mut scribbles = scribbles.to_vec();
        for _ in 0..scribbles.len().min(TURNS) {
            scribbles.rotate_left(1);
            times.last(&mut picture, &mut scribbles)?;
        }
        Ok(times)
    }

    /// The last scribble comes, gets another colour, and goes.
    fn last(&mut self, picture: &mut Picture, scribbles: &mut [Scribble]) -> anyhow::Result<()> {
        let others = scribbles.len().saturating_sub(1);
        let mut spread =
            |scribbles: &[Scribble]| stages::spread(picture, scribbles, &[], &Settings::default());
        spread(&scribbles[..others])?;
        let drawn = spread(scribbles)?;
        if let Some(Scribble { color: Paint::Color(color), .. }) = scribbles.last_mut() {
            color.0[1] ^= 0x40;
        }
        let recolored = spread(scribbles)?;
        let undone = spread(&scribbles[..others])?;
        let times_ms = [
            drawn.total_ms(),
            drawn.color_ms,
            drawn.analyse_ms,
            drawn.factor_ms,
            recolored.total_ms(),
            recolored.solve_ms,
            undone.total_ms(),
        ];
        self.rows[5..].iter_mut().zip(times_ms).for_each(|(row, ms)| row.push(ms));
        Ok(())
    }
}

/// How long a picture takes, painted. Once it has its map it is asked for something in place of the whole, or for nothing.
fn picture_ms(
    drawing: &Drawing,
    scribbles: &[Scribble],
    ask_for: impl Fn(&mut Picture),
) -> anyhow::Result<f64> {
    let document = Document { scribbles: scribbles.to_vec(), ..Document::new(drawing.clone()) };
    let view = stages::page_view(drawing, SIZE_PX);
    let (made, picture_ms) = timed(|| {
        let mut picture = Picture::new(&document.drawing)?;
        ask_for(&mut picture);
        stages::paint_page(picture.update(&document)?, &[], &view, Some(PAPER));
        // What it takes to drop all of it is no part of the time.
        Ok::<_, anyhow::Error>(picture)
    });
    made.map(|_| picture_ms)
}

/// A sixteenth of a page.
fn middle(page: Rect) -> Rect {
    Rect::from_center_size(page.center(), 0.25 * page.size())
}

/// How long a page that makes the picture in slices does not answer at most, where all regions get colours.
fn longest_slice_ms(drawing: &Drawing, scribbles: &[Scribble]) -> anyhow::Result<f64> {
    let settings = Settings { spread: true, ..Settings::default() };
    let document = Document { scribbles: scribbles.to_vec(), settings, ..Document::new(drawing.clone()) };
    let mut slices = Slices::new(async {
        let mut picture = Picture::mapping(&document.drawing).await?;
        picture.updating(&document).await?;
        Ok::<_, anyhow::Error>(())
    });
    let mut longest_ms = 0.0;
    loop {
        let (made, ms) = timed(|| slices.go_on());
        longest_ms = ms.max(longest_ms);
        match made {
            Ok(made) => return made.map(|()| longest_ms),
            Err(left) => slices = left,
        }
    }
}

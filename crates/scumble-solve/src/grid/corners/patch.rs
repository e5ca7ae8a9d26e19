//! The pixels around a corner, in the region between its walls, and their links.

use kurbo::Point;

use super::super::constraints::Constraints;
use super::super::cut_links::{Link, WAYS};
use super::corner::Corner;
use super::ground::Ground;

/// Links are known of pixels so far beyond those that count.
const RIM_PX: f64 = 2.0;

/// A pixel so far from both walls is surely between them, in px.
const CLEAR_PX: f64 = 0.5;

/// A pixel between the walls of a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pixel {
    pub(super) at: [i64; 2],
    /// Its direction from the tip, from the first wall on, as it goes on from pixel to pixel.
    pub(super) angle: f64,
}

/// The centre of a pixel.
pub(super) fn center(at: [i64; 2]) -> Point {
    let [x, y] = at.map(|c| c as f64);
    Point::new(x, y)
}

/// The pixel to which a way leads.
pub(super) fn beside([x, y]: [i64; 2], [dx, dy]: [i64; 2]) -> [i64; 2] {
    [x + dx, y + dy]
}

/// What is known of a place of the patch.
#[derive(Clone, Copy, Debug, Default)]
struct Place {
    /// By link, the number of the cut.
    cuts: [Option<u32>; 4],
    /// How wide the faces to the east and to the south are; 0 at the border.
    widths: [f32; 2],
    /// Which of the pixels it is.
    pixel: Option<u32>,
}

/// The pixels around a corner.
#[derive(Debug)]
pub(super) struct Patch {
    first: [i64; 2],
    columns: i64,
    places: Vec<Place>,
    /// Those to which links lead that are not cut, from one near the tip on.
    pub(super) pixels: Vec<Pixel>,
}

impl Patch {
    /// The pixels within a distance of the tip.
    pub(super) fn around(
        corner: &Corner,
        reach_px: f64,
        constraints: &Constraints,
        ground: &Ground<'_>,
    ) -> Self {
        let range = |middle: f64, count: u32| {
            let [from, to] = [-1.0, 1.0].map(|side| middle + side * (reach_px + RIM_PX));
            let first = from.max(0.0).min(count.into()) as i64;
            first..(to + 1.0).max(0.0).min(count.into()).max(first as f64) as i64
        };
        let columns = range(corner.tip.x, constraints.width_px);
        let rows = range(corner.tip.y, constraints.height_px);
        let mut patch = Self {
            first: [columns.start, rows.start],
            columns: columns.end - columns.start,
            places: Vec::new(),
            pixels: Vec::new(),
        };
        rows.for_each(|y| patch.push_row(constraints, y));
        if let Some(first) = patch.first_pixel(corner).filter(|at| ground.leads_to(corner, center(*at))) {
            patch.flood(corner, reach_px, first);
        }
        patch
    }

    /// The pixel nearest to the tip that is clear of walls.
    fn first_pixel(&self, corner: &Corner) -> Option<[i64; 2]> {
        let distance = |at: &[i64; 2]| center(*at).distance(corner.tip);
        let clear = self.all().filter(|at| corner.is_between(center(*at), CLEAR_PX));
        clear.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    fn push_row(&mut self, constraints: &Constraints, y: i64) {
        let [width, height] = [constraints.width_px, constraints.height_px].map(i64::from);
        let (x, row) = (self.first[0], self.places.len());
        self.places.extend((x..x + self.columns).map(|x| {
            let widths = [x + 1 < width, y + 1 < height].map(|is_within| f32::from(u8::from(is_within)));
            Place { widths, ..Place::default() }
        }));
        let start = (y * width + x) as u32;
        let pixels = start..start + self.columns as u32;
        let place = |pixel: u32| row + (pixel - start) as usize;
        for number in constraints.cuts_of(&pixels) {
            let cut = &constraints.cuts[number];
            self.places[place(cut.pixel)].cuts[cut.link as usize] = Some(number as u32);
        }
        for link in [Link::East, Link::South] {
            for face in constraints.faces_of(link, &pixels) {
                self.places[place(face.pixel)].widths[link as usize] *= face.width;
            }
        }
    }

    /// Finds the pixels, from one of them on.
    fn flood(&mut self, corner: &Corner, reach_px: f64, first: [i64; 2]) {
        let distance = |at: &[i64; 2]| center(*at).distance(corner.tip);
        self.push(Pixel { at: first, angle: corner.angle_of(center(first)) });
        let mut next = 0;
        while let Some(&Pixel { at, angle }) = self.pixels.get(next) {
            next += 1;
            for (link, way) in WAYS {
                let other = beside(at, way);
                let is_near = distance(&other) <= reach_px;
                if is_near
                    && self.width(at, link) > 0.0
                    && self.cut(at, link).is_none()
                    && self.pixel(other).is_none()
                {
                    self.push(Pixel { at: other, angle: angle + corner.turned(center(at), center(other)) });
                }
            }
        }
    }

    fn push(&mut self, pixel: Pixel) {
        if let Some(place) = self.place(pixel.at) {
            self.places[place].pixel = Some(self.pixels.len() as u32);
            self.pixels.push(pixel);
        }
    }

    fn all(&self) -> impl Iterator<Item = [i64; 2]> + use<> {
        let ([x, y], columns) = (self.first, self.columns);
        (0..self.places.len() as i64).map(move |i| [x + i % columns, y + i / columns])
    }

    fn place(&self, [x, y]: [i64; 2]) -> Option<usize> {
        let [column, row] = [x - self.first[0], y - self.first[1]];
        let place = (0..self.columns).contains(&column).then_some(row * self.columns + column)?;
        usize::try_from(place).ok().filter(|&place| place < self.places.len())
    }

    /// Which of the pixels lies at a place.
    pub(super) fn pixel(&self, at: [i64; 2]) -> Option<usize> {
        Some(self.places[self.place(at)?].pixel? as usize)
    }

    /// The number of the cut of a link.
    pub(super) fn cut(&self, at: [i64; 2], link: Link) -> Option<usize> {
        Some(self.places[self.place(at)?].cuts[link as usize]? as usize)
    }

    /// The width of the face between a pixel and the one to which a link leads; 0 where there is none.
    pub(super) fn width(&self, at: [i64; 2], link: Link) -> f64 {
        let (_, way) = WAYS[link as usize];
        let (owner, axis) = match link {
            Link::East | Link::South => (at, link as usize),
            Link::West | Link::North => (beside(at, way), link as usize - 2),
        };
        self.place(owner).map_or(0.0, |place| self.places[place].widths[axis].into())
    }
}

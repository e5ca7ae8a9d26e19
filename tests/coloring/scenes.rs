//! Small drawings with scribbles, named after the figures of Bao & Fu 2019 that show what a person expects of them,
//! or after what they show: tested by the labels of sides, and as pictures.

use kurbo::{BezPath, Point, Rect, Stroke};
use scumble_core::{Curve, Drawing, EngineKind, Line, Paint, Rgba8, Scribble, ScribbleKind, Settings, Srgb8};

/// A drawing on a page of 1024 × 1024 du, and what somebody scribbled on it.
#[derive(Clone, Debug)]
pub(crate) struct Coloring {
    /// Of its picture's file.
    pub name: &'static str,
    /// The lines, each an SVG path.
    pub lines: Vec<&'static str>,
    /// The scribbles, in drawing order.
    pub scribbles: Vec<Scribble>,
    /// How it is coloured.
    pub settings: Settings,
}

pub(crate) const RED: Paint = Paint::Color(Srgb8([230, 60, 70]));
pub(crate) const BLUE: Paint = Paint::Color(Srgb8([30, 120, 210]));
pub(crate) const GREEN: Paint = Paint::Color(Srgb8([70, 170, 80]));
pub(crate) const YELLOW: Paint = Paint::Color(Srgb8([250, 210, 70]));

pub(crate) const LINE_WIDTH_DU: f64 = 6.0;
const SCRIBBLE_WIDTH_DU: f64 = 12.0;

/// Where engines are known not to do what a person would expect, and what they do.
const FALLS_SHORT: [(EngineKind, &str); 8] = [
    // A stretch of yellow lies between green and red: all of the gap at the tip of the crease is a narrow place.
    (EngineKind::Global, "figure-11-with-a-crease"),
    // The gaps between the tip of the vein and the outline are closed: half of the leaf stays white.
    (EngineKind::Global, "a-leaf-with-a-vein"),
    // Colour runs out onto the page, or goes to it from where the stroke lies beside its shape.
    (EngineKind::Progressive, "figure-17-several-open-regions"),
    (EngineKind::Progressive, "a-leaf-with-a-vein"),
    (EngineKind::Progressive, "a-start-beside-its-shape"),
    (EngineKind::Progressive, "a-stroke-over-a-star"),
    // The page is coloured from the ends of the ground on downwards, too.
    (EngineKind::Progressive, "a-sky-behind-a-pole"),
    // The circuit runs from scale to scale: hardly any side of the outline has a colour.
    (EngineKind::Progressive, "a-body-with-scales"),
];

/// All of them.
pub(crate) fn all() -> Vec<Coloring> {
    let mut all = vec![
        closed_shape(),
        u_shape(),
        three_scribbles(),
        across_two_regions(),
        out_of_its_region(),
        overlapping(),
        shading(2),
        shading(4),
        shading_with_a_crease(),
        several_open_regions(),
        open_leaf(),
        leaf_with_a_vein(),
        body_with_scales(),
        corner_behind_a_line(),
        start_beside_its_shape(),
        stroke_over_a_star(),
        sky_behind_a_pole(),
        head_with_an_eye(),
        two_rooms_and_a_door(),
        single_dot(),
        kept_free(),
    ];
    all.push(open_leaf().spread("an-open-leaf-spread"));
    all.push(kept_free().spread("kept-free-spread"));
    all
}

/// A closed shape beside another: its inside, and nothing else.
pub(crate) fn closed_shape() -> Coloring {
    let lines = [BLOB, "M 650 300 H 900 V 700 H 650 Z"];
    scene("closed-shape", &lines, &[(RED, &[(300.0, 450.0), (380.0, 520.0), (360.0, 640.0)])])
}

pub(crate) const BLOB: &str = "M 150 512 C 150 250 480 180 530 400 S 620 820 400 830 S 150 700 150 512 Z";

/// Figure 3b: what is seen through the mouth of a U stays out.
pub(crate) fn u_shape() -> Coloring {
    let lines = [U, "M 900 420 A 80 80 0 1 0 900 580 Z", "M 760 150 L 980 250"];
    scene("figure-3b-u-shape", &lines, &[(GREEN, &[(330.0, 470.0), (420.0, 540.0), (520.0, 480.0)])])
}

/// Its mouth is open to the right.
pub(crate) const U: &str = "M 620 350 H 330 A 160 160 0 0 0 330 670 H 620";

/// Figure 8: three scribbles in one region, drawn in any order.
pub(crate) fn three_scribbles() -> Coloring {
    let scribbles: [(Paint, &[(f64, f64)]); 3] = [
        (RED, &[(300.0, 400.0), (420.0, 360.0)]),
        (YELLOW, &[(560.0, 480.0), (560.0, 620.0)]),
        (BLUE, &[(400.0, 760.0), (700.0, 740.0)]),
    ];
    scene("figure-8-three-scribbles", &[PEAR], &scribbles)
}

pub(crate) const PEAR: &str =
    "M 330 230 C 520 160 640 300 660 450 S 900 600 850 760 S 500 930 330 850 S 160 300 330 230 Z";

/// Figure 10a: a scribble across two regions colours both.
pub(crate) fn across_two_regions() -> Coloring {
    scene(
        "figure-10a-across-two-regions",
        &ROOMS,
        &[(RED, &[(200.0, 500.0), (350.0, 460.0), (560.0, 520.0)])],
    )
}

/// Three rooms side by side.
pub(crate) const ROOMS: [&str; 3] = [
    "M 100 300 H 924 V 720 H 100 Z",
    "M 380 300 C 420 450 340 580 380 720",
    "M 650 300 C 690 450 610 580 650 720",
];

/// Figure 10b: a scribble that slips out of its region a little leaves the neighbour alone.
pub(crate) fn out_of_its_region() -> Coloring {
    let slip =
        [(160.0, 420.0), (330.0, 400.0), (180.0, 500.0), (330.0, 520.0), (180.0, 600.0), (410.0, 620.0)];
    scene("figure-10b-out-of-its-region", &ROOMS, &[(BLUE, &slip)])
}

/// Figure 10c: scribbles that cross one another.
pub(crate) fn overlapping() -> Coloring {
    let scribbles: [(Paint, &[(f64, f64)]); 3] = [
        (YELLOW, &[(160.0, 500.0), (470.0, 520.0)]),
        (GREEN, &[(400.0, 400.0), (560.0, 640.0)]),
        (RED, &[(490.0, 540.0), (860.0, 500.0)]),
    ];
    scene("figure-10c-overlapping", &ROOMS[..1], &scribbles)
}

/// Figure 11: the more scribbles in a region, the richer its shading. Takes 1 to 4 of them.
pub(crate) fn shading(count: usize) -> Coloring {
    let scribbles: [(Paint, &[(f64, f64)]); 4] = [
        (RED, &[(480.0, 780.0), (560.0, 800.0)]),
        (YELLOW, &[(380.0, 300.0), (460.0, 240.0)]),
        (BLUE, &[(720.0, 480.0), (730.0, 560.0)]),
        (GREEN, &[(260.0, 520.0), (270.0, 600.0)]),
    ];
    let name = if count == 2 { "figure-11-two-scribbles" } else { "figure-11-four-scribbles" };
    scene(name, &[PETAL], &scribbles[..count])
}

pub(crate) const PETAL: &str = "M 512 940 C 60 760 140 180 512 120 C 884 180 964 760 512 940 Z";

/// Figure 11: the same scribbles, and a curve between them.
pub(crate) fn shading_with_a_crease() -> Coloring {
    let lines = vec![PETAL, "M 512 120 C 460 350 640 480 560 700"];
    Coloring { name: "figure-11-with-a-crease", lines, ..shading(4) }
}

/// Figure 17: a scribble across several open regions.
pub(crate) fn several_open_regions() -> Coloring {
    let scribble = [(150.0, 480.0), (350.0, 430.0), (512.0, 500.0), (700.0, 430.0), (870.0, 480.0)];
    scene("figure-17-several-open-regions", &PETALS, &[(BLUE, &scribble)])
}

/// Four petals side by side, each open below.
pub(crate) const PETALS: [&str; 4] = [
    "M 165 700 C 65 600 65 250 195 250 S 325 600 225 700",
    "M 375 700 C 275 600 275 250 405 250 S 535 600 435 700",
    "M 585 700 C 485 600 485 250 615 250 S 745 600 645 700",
    "M 795 700 C 695 600 695 250 825 250 S 955 600 855 700",
];

/// A leaf whose outline is open at the tip and at the stalk.
pub(crate) fn open_leaf() -> Coloring {
    scene("an-open-leaf", &LEAF[..2], &[(GREEN, &[(400.0, 560.0), (500.0, 480.0)])])
}

/// The same with a vein that ends within, and the scribble on one side of it.
pub(crate) fn leaf_with_a_vein() -> Coloring {
    scene("a-leaf-with-a-vein", &LEAF, &[(GREEN, &[(340.0, 560.0), (440.0, 440.0)])])
}

/// Two halves of the outline, and the vein.
pub(crate) const LEAF: [&str; 3] =
    ["M 180 780 C 200 400 420 220 770 180", "M 212 808 C 560 840 800 600 800 210", "M 130 880 L 560 420"];

/// A body that a stroke goes through, between scales that part it into many rooms with wide gaps between them.
pub(crate) fn body_with_scales() -> Coloring {
    let stroke = [(250.0, 470.0), (420.0, 400.0), (600.0, 520.0)];
    scene("a-body-with-scales", &[BODY, SCALES], &[(YELLOW, &stroke)])
}

pub(crate) const BODY: &str = "M 120 512 C 200 240 640 200 920 512 C 640 824 200 784 120 512 Z";
const SCALES: &str = "M 380 380 A 40 40 0 0 1 380 460 M 480 380 A 40 40 0 0 1 480 460 \
    M 430 470 A 40 40 0 0 1 430 550 M 530 470 A 40 40 0 0 1 530 550 M 630 470 A 40 40 0 0 1 630 550 \
    M 480 560 A 40 40 0 0 1 480 640 M 580 560 A 40 40 0 0 1 580 640 M 680 420 A 40 40 0 0 1 680 500 \
    M 720 510 A 40 40 0 0 1 720 590";

/// A stroke that begins beside the shape that it is meant for.
pub(crate) fn start_beside_its_shape() -> Coloring {
    let stroke = [(110.0, 400.0), (250.0, 460.0), (420.0, 440.0)];
    scene("a-start-beside-its-shape", &[BLOB], &[(YELLOW, &stroke)])
}

/// A hasty stroke over a small star: most of it lies on lines, where a sample falls to either side by chance.
pub(crate) fn stroke_over_a_star() -> Coloring {
    scene("a-stroke-over-a-star", &[STAR, RAYS], &[(RED, &[(450.0, 530.0), (560.0, 490.0)])])
}

pub(crate) const STAR: &str =
    "M 512 466 L 524 496 L 556 498 L 531 518 L 539 549 L 512 532 L 485 549 L 493 518 L 468 498 L 500 496 Z";
const RAYS: &str =
    "M 512 512 L 512 484 M 512 512 L 538 504 M 512 512 L 528 534 M 512 512 L 496 534 M 512 512 L 486 504";

/// A body of which a line that nearly meets its outline parts a corner.
pub(crate) fn corner_behind_a_line() -> Coloring {
    let stroke = [(400.0, 450.0), (520.0, 400.0), (640.0, 480.0)];
    scene("a-corner-behind-a-line", &[BODY, "M 272 376 C 320 440 320 580 276 652"], &[(YELLOW, &stroke)])
}

/// A pole before the sky, on ground whose line ends just before the borders of the page.
pub(crate) fn sky_behind_a_pole() -> Coloring {
    let stroke = [(120.0, 300.0), (300.0, 260.0), (380.0, 330.0)];
    scene("a-sky-behind-a-pole", &["M 40 850 H 984", "M 512 850 V 150"], &[(BLUE, &stroke)])
}

/// A stroke over an eye, where the head is narrow.
pub(crate) fn head_with_an_eye() -> Coloring {
    scene(
        "a-head-with-an-eye",
        &[HEAD, EYE, GILL],
        &[(RED, &[(358.0, 280.0), (422.0, 256.0), (518.0, 224.0)])],
    )
}

pub(crate) const HEAD: &str =
    "M 150 544 C 278 224 438 128 622 109 C 790 288 806 704 654 904 C 438 848 246 736 150 544 Z";
const EYE: &str = "M 510 432 A 88 88 0 1 1 510 431.9 Z";
const GILL: &str = "M 582 320 C 630 432 638 576 590 688";

/// Two scribbles in two rooms with a wide door between them.
pub(crate) fn two_rooms_and_a_door() -> Coloring {
    let lines = ["M 100 250 H 924 V 770 H 100 Z", "M 512 250 V 400", "M 512 770 V 600"];
    scene(
        "two-rooms-and-a-door",
        &lines,
        &[(YELLOW, &[(200.0, 400.0), (300.0, 600.0)]), (BLUE, &[(720.0, 600.0), (820.0, 420.0)])],
    )
}

/// A single dot in a ring.
pub(crate) fn single_dot() -> Coloring {
    let lines = ["M 812 512 A 300 300 0 1 1 812 511.9 Z", "M 632 512 A 120 120 0 1 1 632 511.9 Z"];
    scene("a-single-dot", &lines, &[(RED, &[(320.0, 480.0)])])
}

/// Three rooms, the middle one kept free.
pub(crate) fn kept_free() -> Coloring {
    scene(
        "kept-free",
        &ROOMS,
        &[(RED, &[(200.0, 450.0), (280.0, 560.0)]), (Paint::Clear, &[(480.0, 450.0), (540.0, 560.0)])],
    )
}

fn scene(name: &'static str, lines: &[&'static str], scribbles: &[(Paint, &[(f64, f64)])]) -> Coloring {
    let scribble = |&(color, points): &(Paint, &[(f64, f64)])| Scribble {
        color,
        kind: ScribbleKind::Fill,
        width_du: SCRIBBLE_WIDTH_DU,
        points: points.iter().copied().map(Point::from).collect(),
    };
    let scribbles = scribbles.iter().map(scribble).collect();
    Coloring { name, lines: lines.to_vec(), scribbles, settings: Settings::default() }
}

impl Coloring {
    /// The same, with colours that go on into areas that nobody scribbled.
    pub(crate) fn spread(self, name: &'static str) -> Self {
        Self { name, settings: Settings { spread: true, ..self.settings }, ..self }
    }

    /// The same, coloured by an engine.
    pub(crate) fn by(self, engine: EngineKind) -> Self {
        Self { settings: Settings { engine, ..self.settings }, ..self }
    }

    /// Whether its engine knows all of its settings.
    pub(crate) fn is_known(&self) -> bool {
        self.settings.engine == EngineKind::Global || !self.settings.spread
    }

    /// Whether its engine is known not to do with it what a person would expect.
    pub(crate) fn falls_short(&self) -> bool {
        FALLS_SHORT.contains(&(self.settings.engine, self.name))
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let line = Line { stroke: Stroke::new(LINE_WIDTH_DU), color: Rgba8([30, 30, 40, 255]) };
        let curves = self.lines.iter().flat_map(|path| subpaths(path));
        let curves = curves.map(|path| Curve { path, line: Some(line.clone()) }).collect();
        Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) }
    }
}

/// The parts of a path, one for each `M`.
fn subpaths(path: &str) -> Vec<BezPath> {
    let parts = path.split('M').skip(1);
    parts.map(|part| BezPath::from_svg(&format!("M{part}")).expect("a path")).collect()
}

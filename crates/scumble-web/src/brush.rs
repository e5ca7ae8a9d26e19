//! What the pen draws with: the kind, colour and size of the next scribble.

use scumble_core::{Paint, PenPressure, ScribbleKind, Shading, Srgb8, Tone, clamped};

use crate::stroke::Sample;

/// Smallest and largest width of a scribble that fills, and of one that shades, in du.
const SIZES_DU: [[f64; 2]; 2] = [[2.0, 96.0], [2.0, 256.0]];

/// The brush grows and shrinks by this factor, and by one du at least.
const STEP: f64 = 1.25;

/// The lightest touch of a pen still gives so much of the brush's size.
const LEAST_RADIUS: f64 = 0.1;

/// Steps of pressure: as fine as can be seen, and short in links.
const PRESSURE_STEPS: f64 = 100.0;

/// What a scribble does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// It colours the sides around it.
    #[default]
    Fill,
    /// It colours the place where it is drawn.
    Shade,
}

impl Kind {
    pub(crate) fn other(self) -> Self {
        match self {
            Self::Fill => Self::Shade,
            Self::Shade => Self::Fill,
        }
    }
}

/// What the pressure of a pen gives a scribble that shades, along the stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pressure {
    /// Its radius, up to that of the brush.
    #[default]
    Radius,
    /// Its strength, up to the one that is set.
    Strength,
    /// Nothing.
    Off,
}

/// What a scribble is drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// As picked.
    Paint(Paint),
    /// A step from the colour under its first point.
    Tone(Tone),
}

impl From<Srgb8> for Ink {
    fn from(color: Srgb8) -> Self {
        Self::Paint(color.into())
    }
}

/// How the next scribble colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// What it does.
    pub kind: Kind,
    /// How far its colour gets its way where it shades, in `0..=1`.
    pub strength: f64,
    /// Whether it shades beyond the region that it begins in.
    pub crosses: bool,
    /// What the pressure of a pen gives it then.
    pub pressure: Pressure,
}

impl Default for Mode {
    fn default() -> Self {
        let Shading { strength, crosses, .. } = Shading::default();
        Self { kind: Kind::default(), strength, crosses, pressure: Pressure::default() }
    }
}

impl Mode {
    /// That of a scribble that shades like this. A pen that pressed evenly says nothing of itself.
    pub(crate) fn of_shade(shading: &Shading, pen: Pressure) -> Self {
        let Shading { strength, crosses, ref pressure } = *shading;
        let pressure = match pressure {
            PenPressure::Even => pen,
            PenPressure::Radius(_) => Pressure::Radius,
            PenPressure::Strength(_) => Pressure::Strength,
        };
        Self { kind: Kind::Shade, strength, crosses, pressure }
    }

    /// A shade of it, by a pen that has pressed so hard at each of its points, in parts of `0..=1`.
    fn shading(&self, parts: Vec<f64>) -> Shading {
        Shading { strength: self.strength, crosses: self.crosses, pressure: self.pressure.of(parts) }
    }

    /// Smallest and largest size of its brush, in du.
    pub fn sizes_du(&self) -> [f64; 2] {
        SIZES_DU[self.kind as usize]
    }
}

/// One change of how the next scribble colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModeChange {
    /// What it does.
    Kind(Kind),
    /// What it does not do now.
    OtherKind,
    /// How far its colour gets its way, in `0..=1`.
    Strength(f64),
    /// Whether it shades beyond the region that it begins in.
    Crosses(bool),
    /// What the pressure of a pen gives it.
    Pressure(Pressure),
}

impl ModeChange {
    pub(crate) fn apply(self, mode: &mut Mode) {
        match self {
            Self::Kind(kind) => mode.kind = kind,
            Self::OtherKind => mode.kind = mode.kind.other(),
            Self::Strength(strength) if strength.is_nan() => {}
            Self::Strength(strength) => mode.strength = strength.clamp(0.0, 1.0),
            Self::Crosses(crosses) => mode.crosses = crosses,
            Self::Pressure(pressure) => mode.pressure = pressure,
        }
    }

    /// What it makes of one that shades already.
    pub(crate) fn apply_to(self, shading: &mut Shading) {
        let mut mode = Mode::of_shade(shading, Pressure::Off);
        self.apply(&mut mode);
        *shading = mode.shading(parts_of(&shading.pressure));
    }
}

fn parts_of(pressure: &PenPressure) -> Vec<f64> {
    match pressure {
        PenPressure::Even => Vec::new(),
        PenPressure::Radius(parts) | PenPressure::Strength(parts) => parts.clone(),
    }
}

impl Pressure {
    /// What a pen gives that has pressed so hard at each of its points, in parts of `0..=1`.
    fn of(self, parts: Vec<f64>) -> PenPressure {
        let is_even = parts.iter().all(|part| *part == 1.0);
        match self {
            Self::Radius if !is_even => {
                PenPressure::Radius(parts.into_iter().map(|part| part.max(LEAST_RADIUS)).collect())
            }
            Self::Strength if !is_even => PenPressure::Strength(parts),
            _ => PenPressure::Even,
        }
    }
}

/// The width nearest to one that a scribble of a kind can be given, in du.
pub(crate) fn within_sizes(width_du: f64, kind: &ScribbleKind) -> f64 {
    clamped(width_du.round(), SIZES_DU[usize::from(*kind != ScribbleKind::Fill)])
}

/// What the pen draws with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Brush {
    pub(crate) mode: Mode,
    color: Paint,
    previous_color: Paint,
    /// For scribbles that shade: in place of the colour.
    tone: Option<Tone>,
    /// Of either kind.
    sizes_du: [f64; 2],
}

impl Default for Brush {
    fn default() -> Self {
        Self {
            mode: Mode::default(),
            color: Srgb8([0xe5, 0x48, 0x4d]).into(),
            previous_color: Srgb8([0x3b, 0x82, 0xf6]).into(),
            tone: None,
            sizes_du: [16.0, 64.0],
        }
    }
}

impl Brush {
    pub(crate) fn ink(&self) -> Ink {
        let tone = self.tone.filter(|_| self.mode.kind == Kind::Shade);
        tone.map_or(Ink::Paint(self.color), Ink::Tone)
    }

    pub(crate) fn set_ink(&mut self, ink: Ink) {
        match ink {
            Ink::Tone(tone) => self.tone = Some(tone),
            Ink::Paint(color) => {
                self.tone = None;
                if color != self.color {
                    self.previous_color = self.color;
                    self.color = color;
                }
            }
        }
    }

    /// The colour before stays the one that it is.
    pub(crate) fn tune_color(&mut self, color: Paint) {
        self.tone = None;
        self.color = color;
    }

    /// That before the one of the moment.
    pub(crate) fn color_before(&self) -> Paint {
        if matches!(self.ink(), Ink::Tone(_)) { self.color } else { self.previous_color }
    }

    pub(crate) fn size_du(&self) -> f64 {
        self.sizes_du[self.mode.kind as usize]
    }

    /// A step wider.
    pub(crate) fn wider(size_du: f64) -> f64 {
        (size_du * STEP).max(size_du + 1.0)
    }

    /// A step narrower.
    pub(crate) fn narrower(size_du: f64) -> f64 {
        (size_du / STEP).min(size_du - 1.0)
    }

    pub(crate) fn set_size(&mut self, size_du: f64) {
        if size_du.is_finite() {
            self.sizes_du[self.mode.kind as usize] = clamped(size_du.round(), self.mode.sizes_du());
        }
    }

    /// How far pressure reaches across a scribble, at most, in du.
    pub(crate) fn pressure_du(&self) -> f64 {
        let counts = self.mode.kind == Kind::Shade && self.mode.pressure != Pressure::Off;
        if counts { 0.5 * self.size_du() } else { 0.0 }
    }

    /// What a scribble is by a pen on a way.
    pub(crate) fn pressed(&self, way: &[Sample]) -> ScribbleKind {
        match self.mode.kind {
            Kind::Fill => ScribbleKind::Fill,
            Kind::Shade => ScribbleKind::Shade(
                self.mode.shading(way.iter().map(|sample| part(sample.pressure)).collect()),
            ),
        }
    }
}

/// Pressure in whole steps.
fn part(pressure: f64) -> f64 {
    (pressure * PRESSURE_STEPS).round() / PRESSURE_STEPS
}

//! What the pen draws with: the kind, colour and size of the next scribble.

use scumble_core::{Paint, ScribbleKind, Shading, Srgb8, Tone};

/// Smallest and largest width of a scribble that fills, and of one that shades, in du.
const SIZES_DU: [[f64; 2]; 2] = [[2.0, 96.0], [2.0, 256.0]];

/// The brush grows and shrinks by this factor, and by one du at least.
const STEP: f64 = 1.25;

/// The lightest touch of a pen still gives so much of the brush's size.
const LEAST_PRESSED: f64 = 0.1;

/// What a scribble does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// It colours the sides around it.
    #[default]
    Fill,
    /// It colours the place where it is drawn.
    Shade,
}

/// What the pressure of a pen gives a scribble that shades.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pressure {
    /// Its radius, up to that of the brush.
    #[default]
    Radius,
    /// Its strength, up to the one that is set.
    Strength,
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mode {
    /// What it does.
    pub kind: Kind,
    /// How it shades, if it does.
    pub shading: Shading,
    /// What the pressure of a pen gives it then.
    pub pressure: Pressure,
}

impl Mode {
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
            Self::OtherKind => {
                mode.kind = if mode.kind == Kind::Fill { Kind::Shade } else { Kind::Fill };
            }
            Self::Strength(strength) if strength.is_nan() => {}
            Self::Strength(strength) => mode.shading.strength = strength.clamp(0.0, 1.0),
            Self::Crosses(crosses) => mode.shading.crosses = crosses,
            Self::Pressure(pressure) => mode.pressure = pressure,
        }
    }
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

    /// A tone that is picked again is put away.
    pub(crate) fn set_ink(&mut self, ink: Ink) {
        match ink {
            Ink::Tone(tone) => self.tone = Some(tone).filter(|_| self.tone != Some(tone)),
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

    /// Back to the colour before.
    pub(crate) fn swap_colors(&mut self) {
        let before = if matches!(self.ink(), Ink::Tone(_)) { self.color } else { self.previous_color };
        self.set_ink(Ink::Paint(before));
    }

    pub(crate) fn size_du(&self) -> f64 {
        self.sizes_du[self.mode.kind as usize]
    }

    pub(crate) fn set_size(&mut self, size_du: f64) {
        if size_du.is_finite() {
            let [least, most] = self.mode.sizes_du();
            self.sizes_du[self.mode.kind as usize] = size_du.round().clamp(least, most);
        }
    }

    pub(crate) fn grow(&mut self) {
        self.set_size((self.size_du() * STEP).max(self.size_du() + 1.0));
    }

    pub(crate) fn shrink(&mut self) {
        self.set_size((self.size_du() / STEP).min(self.size_du() - 1.0));
    }

    /// Width in du and kind of a scribble by a pen that has pressed so hard at most, in `0..=1`.
    pub(crate) fn pressed(&self, pressed: f64) -> (f64, ScribbleKind) {
        let Mode { kind, shading, pressure } = self.mode;
        match (kind, pressure) {
            (Kind::Fill, _) => (self.size_du(), ScribbleKind::Fill),
            (Kind::Shade, Pressure::Radius) => {
                (self.size_du() * pressed.max(LEAST_PRESSED), ScribbleKind::Shade(shading))
            }
            (Kind::Shade, Pressure::Strength) => {
                let strength = shading.strength * pressed;
                (self.size_du(), ScribbleKind::Shade(Shading { strength, ..shading }))
            }
        }
    }
}

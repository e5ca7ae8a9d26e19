//! The spaces in which CSS has colours, and sRGB: CSS Color Module Level 4, with its white points and matrices.

use scumble_core::color::{linear_from_srgb, srgb_from_linear};
use scumble_core::{Blend, Rgba8};

/// A space of three numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Space {
    Rgb,
    Hsl,
    Hwb,
    Lab,
    Lch,
    Oklab,
    Oklch,
    Srgb,
    LinearSrgb,
    DisplayP3,
    XyzD65,
    XyzD50,
}

impl Space {
    /// The space of a function like `rgb()`.
    pub(crate) fn of_function(name: &str) -> Option<Self> {
        match name {
            "rgb" | "rgba" => Some(Self::Rgb),
            "hsl" | "hsla" => Some(Self::Hsl),
            "hwb" => Some(Self::Hwb),
            "lab" => Some(Self::Lab),
            "lch" => Some(Self::Lch),
            "oklab" => Some(Self::Oklab),
            "oklch" => Some(Self::Oklch),
            _ => None,
        }
    }

    /// The space that `color()` names.
    pub(crate) fn of_profile(name: &str) -> Option<Self> {
        match name {
            "srgb" | "a98-rgb" | "prophoto-rgb" | "rec2020" => Some(Self::Srgb),
            "srgb-linear" => Some(Self::LinearSrgb),
            "display-p3" => Some(Self::DisplayP3),
            "xyz" | "xyz-d65" => Some(Self::XyzD65),
            "xyz-d50" => Some(Self::XyzD50),
            _ => None,
        }
    }

    /// What a hundred percent of each number is. Hues have none.
    pub(crate) fn wholes(self) -> [f64; 3] {
        match self {
            Self::Rgb => [255.0; 3],
            Self::Hsl | Self::Hwb => [360.0, 100.0, 100.0],
            Self::Lab => [100.0, 125.0, 125.0],
            Self::Lch => [100.0, 150.0, 360.0],
            Self::Oklab => [1.0, 0.4, 0.4],
            Self::Oklch => [1.0, 0.4, 360.0],
            _ => [1.0; 3],
        }
    }

    /// A colour in sRGB; its channels may lie outside `0..=1`.
    pub(crate) fn srgb(self, [a, b, c]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Rgb => [a, b, c].map(|c| c / 255.0),
            Self::Hsl => srgb_from_hsl(a, b / 100.0, c / 100.0),
            Self::Hwb => srgb_from_hwb(a, b / 100.0, c / 100.0),
            Self::Lab => srgb_from_xyz_d50(xyz_d50_from_lab([a, b, c])),
            Self::Lch => Self::Lab.srgb(from_polar(a, b, c)),
            Self::Oklab => srgb_from_oklab([a, b, c]),
            Self::Oklch => Self::Oklab.srgb(from_polar(a, b, c)),
            Self::Srgb => [a, b, c],
            Self::LinearSrgb => [a, b, c].map(srgb_from_linear),
            Self::DisplayP3 => apply(&LINEAR_FROM_P3, [a, b, c].map(linear_from_srgb)).map(srgb_from_linear),
            Self::XyzD65 => apply(&LINEAR_FROM_XYZ_D65, [a, b, c]).map(srgb_from_linear),
            Self::XyzD50 => srgb_from_xyz_d50([a, b, c]),
        }
    }
}

/// The nearest 8-bit colour, of parts from 0 to 1.
pub(crate) fn rgba8([r, g, b]: [f64; 3], alpha: f64) -> Rgba8 {
    Rgba8([r, g, b, alpha].map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8))
}

fn from_polar(lightness: f64, chroma: f64, hue_deg: f64) -> [f64; 3] {
    let (sin, cos) = hue_deg.to_radians().sin_cos();
    [lightness, chroma * cos, chroma * sin]
}

fn srgb_from_hsl(hue_deg: f64, saturation: f64, lightness: f64) -> [f64; 3] {
    let reach = saturation.clamp(0.0, 1.0) * lightness.min(1.0 - lightness);
    [0.0, 8.0, 4.0].map(|turn| {
        let k = (turn + hue_deg / 30.0).rem_euclid(12.0);
        lightness - reach * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0)
    })
}

fn srgb_from_hwb(hue_deg: f64, white: f64, black: f64) -> [f64; 3] {
    let sum = white + black;
    if sum >= 1.0 {
        return [white / sum; 3];
    }
    srgb_from_hsl(hue_deg, 1.0, 0.5).map(|c| c * (1.0 - sum) + white)
}

fn srgb_from_oklab([l, a, b]: [f64; 3]) -> [f64; 3] {
    let [r, g, b, _] = Blend::Oklab.to_srgba([l, a, b, 1.0]);
    [r, g, b]
}

/// CIE Lab, whose white is D50.
fn xyz_d50_from_lab([l, a, b]: [f64; 3]) -> [f64; 3] {
    const KAPPA: f64 = 24389.0 / 27.0;
    const EPSILON: f64 = 216.0 / 24389.0;
    let fy = (l + 16.0) / 116.0;
    let of = |f: f64| if f.powi(3) > EPSILON { f.powi(3) } else { (116.0 * f - 16.0) / KAPPA };
    [of(fy + a / 500.0) * 0.964_295_676, of(fy), of(fy - b / 200.0) * 0.825_104_603]
}

fn srgb_from_xyz_d50(xyz: [f64; 3]) -> [f64; 3] {
    apply(&LINEAR_FROM_XYZ_D65, apply(&D65_FROM_D50, xyz)).map(srgb_from_linear)
}

fn apply(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

const LINEAR_FROM_P3: [[f64; 3]; 3] = [
    [1.224_940_176, -0.224_940_176, 0.0],
    [-0.042_056_955, 1.042_056_955, 0.0],
    [-0.019_637_555, -0.078_636_046, 1.098_273_600],
];

const LINEAR_FROM_XYZ_D65: [[f64; 3]; 3] = [
    [3.240_969_942, -1.537_383_178, -0.498_610_760],
    [-0.969_243_636, 1.875_967_502, 0.041_555_057],
    [0.055_630_080, -0.203_976_959, 1.056_971_514],
];

const D65_FROM_D50: [[f64; 3]; 3] = [
    [0.955_473_421, -0.023_098_455, 0.063_259_243],
    [-0.028_369_710, 1.009_995_398, 0.021_041_441],
    [0.012_314_015, -0.020_507_649, 1.330_365_926],
];

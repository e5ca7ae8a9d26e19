// Shared by all kernels: the view, and the one place where colours are encoded.

struct View {
    // From du to clip space: columns x and y of the linear part.
    linear: vec4<f32>,
    // A place near the middle of the view in du, and where it is in clip space. Positions are taken relative to it,
    // so that nothing is lost at large zooms.
    origin_du: vec2<f32>,
    origin_clip: vec2<f32>,
    // 1 where the field is in OKLab, 0 where it is in sRGB.
    oklab: u32,
}

@group(0) @binding(0) var<uniform> view: View;

fn clip_from_du(position_du: vec2<f32>, depth: f32) -> vec4<f32> {
    let d = position_du - view.origin_du;
    return vec4(view.origin_clip + view.linear.xy * d.x + view.linear.zw * d.y, depth, 1.0);
}

// OKLab after Björn Ottosson, "A perceptual color space for image processing" (2020); written row by row and
// multiplied from the left.
const LMS_FROM_OKLAB = mat3x3<f32>(
    1.0, 0.3963377774, 0.2158037573,
    1.0, -0.1055613458, -0.0638541728,
    1.0, -0.0894841775, -1.2914855480,
);
const LINEAR_FROM_LMS = mat3x3<f32>(
    4.0767416621, -3.3077115913, 0.2309699292,
    -1.2684380046, 2.6097574011, -0.3413193965,
    -0.0041960863, -0.7034186147, 1.7076147010,
);

// What is blended for a blend-space colour times its opacity, linear in it: sRGB itself, or the cube roots of the cone
// responses; and the transparency, which is what the opacity lacks to 1. So opaque colours stay opaque to the last bit,
// however they are blended.
fn blended(color: vec4<f32>) -> vec4<f32> {
    let transparency = 1.0 - color.a;
    if view.oklab == 1u {
        return vec4(color.rgb * LMS_FROM_OKLAB, transparency);
    }
    return vec4(color.rgb, transparency);
}

// A quarter of an 8-bit level, which nobody sees: opacities below are taken as this where a colour is divided by its own.
const LEAST_OPACITY = 1.0 / 1024.0;

// The premultiplied sRGB values of what is blended.
fn painted(color: vec4<f32>) -> vec4<f32> {
    let opacity = 1.0 - color.a;
    let alpha = saturate(opacity);
    return vec4(encoded(color.rgb / max(opacity, LEAST_OPACITY)) * alpha, alpha);
}

// The sRGB values, in 0..=1, of what is blended, opaque; what lies outside sRGB is clamped channel by channel. Targets store
// them as they are: no texture format that converts is drawn to.
fn encoded(color: vec3<f32>) -> vec3<f32> {
    if view.oklab == 1u {
        return srgb_from_linear(saturate((color * color * color) * LINEAR_FROM_LMS));
    }
    return saturate(color);
}

fn srgb_from_linear(c: vec3<f32>) -> vec3<f32> {
    let curve = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return select(curve, 12.92 * c, c <= vec3(0.0031308));
}

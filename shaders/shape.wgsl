// Flat shapes: sRGB colours with opacity. Each shape has a depth of its own, greater than those below it, so that
// the depth test lets each of its samples through once.

struct Varying {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) color: vec4<f32>,
}

@vertex
fn vertex(
    @location(0) position_du: vec2<f32>,
    @location(1) color: vec4<f32>,
    @location(2) depth: f32,
) -> Varying {
    return Varying(clip_from_du(position_du, depth), color);
}

// Premultiplied.
@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    return vec4(in.color.rgb * in.color.a, in.color.a);
}

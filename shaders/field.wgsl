// A colour field: one instance a triangle, its quadratic evaluated at every pixel.

struct Triangle {
    @location(0) corner_0: vec2<f32>,
    @location(1) corner_1: vec2<f32>,
    @location(2) corner_2: vec2<f32>,
    // Times their opacity, and the opacity: at the corners, and in the middle of edges 01, 12, 20.
    @location(3) color_0: vec4<f32>,
    @location(4) color_1: vec4<f32>,
    @location(5) color_2: vec4<f32>,
    @location(6) color_01: vec4<f32>,
    @location(7) color_12: vec4<f32>,
    @location(8) color_20: vec4<f32>,
}

struct Varying {
    @builtin(position) position: vec4<f32>,
    // Of the three corners.
    @location(0) weights: vec3<f32>,
    @location(1) @interpolate(flat) color_0: vec4<f32>,
    @location(2) @interpolate(flat) color_1: vec4<f32>,
    @location(3) @interpolate(flat) color_2: vec4<f32>,
    @location(4) @interpolate(flat) color_01: vec4<f32>,
    @location(5) @interpolate(flat) color_12: vec4<f32>,
    @location(6) @interpolate(flat) color_20: vec4<f32>,
}

@vertex
fn vertex(@builtin(vertex_index) corner: u32, triangle: Triangle) -> Varying {
    let weights = vec3<f32>(vec3(corner) == vec3(0u, 1u, 2u));
    let second = select(triangle.corner_1, triangle.corner_2, corner == 2u);
    let position_du = select(second, triangle.corner_0, corner == 0u);
    return Varying(
        clip_from_du(position_du, 0.0),
        weights,
        blended(triangle.color_0),
        blended(triangle.color_1),
        blended(triangle.color_2),
        blended(triangle.color_01),
        blended(triangle.color_12),
        blended(triangle.color_20),
    );
}

// A pixel that the triangle covers in part may have its centre outside: there the triangle's rim is continued, as
// the painter on the CPU does.
@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    let inside = max(in.weights, vec3(0.0));
    let w = inside / (inside.x + inside.y + inside.z);
    let corners = w * (2.0 * w - 1.0);
    let middles = 4.0 * w * w.yzx;
    let color = corners.x * in.color_0 + corners.y * in.color_1 + corners.z * in.color_2
        + middles.x * in.color_01 + middles.y * in.color_12 + middles.z * in.color_20;
    return painted(color);
}

// Draws every texel of a target: one triangle that covers it.
@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let far = vec2<f32>(vec2(corner & 1u, corner >> 1u));
    return vec4(4.0 * far - 1.0, 0.0, 1.0);
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<u32> {
    return bitcast<vec4<u32>>(kernel(vec2<i32>(position.xy)));
}

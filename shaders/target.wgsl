// One triangle that covers the target.
@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let far = vec2<f32>(vec2(corner & 1u, corner >> 1u));
    return vec4(4.0 * far - 1.0, 0.0, 1.0);
}

// Draws every texel of a target, which one triangle covers.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<u32> {
    return written(kernel(vec2<i32>(position.xy)));
}

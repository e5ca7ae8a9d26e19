// The matrix times a vector.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return multiplied(vec2<i32>(position.xy));
}

// What is in first, by what is in second, where that is above zero.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    let divisor = textureLoad(second, place, 0);
    let is_above = divisor > vec4(0.0);
    return select(vec4(0.0), textureLoad(first, place, 0) / select(vec4(1.0), divisor, is_above), is_above);
}

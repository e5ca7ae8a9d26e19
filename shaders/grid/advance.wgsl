// What is in first, with what is in second added, times what is in the one texel of third.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    return textureLoad(first, place, 0) + textureLoad(second, place, 0) * textureLoad(third, vec2(0), 0);
}

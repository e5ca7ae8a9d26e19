// What the equations with the values in first and the right side in second lack.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    return textureLoad(second, place, 0) - multiplied(place);
}

// What the equations with the values in first and the right side in second lack.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    return texel(second, place) - multiplied(place);
}

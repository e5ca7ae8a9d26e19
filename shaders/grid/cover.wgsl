// What is seen where a layer of colours, in second, lies over what is in first: that shows by what the last channel of third
// leaves.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) * (1.0 - texel(third, place).w) + texel(second, place);
}

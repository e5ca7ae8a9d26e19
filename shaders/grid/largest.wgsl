// The largest of a block of texels, channel by channel, without their signs.

fn merged(a: vec4<f32>, b: vec4<f32>) -> vec4<f32> {
    return max(a, b);
}

fn term(place: vec2<i32>) -> vec4<f32> {
    return abs(load(first, place));
}

// The largest of a block of texels, channel by channel, without their signs.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let origin = 8 * place;
    var largest = vec4(0.0);
    for (var i = 0; i < 64; i++) {
        largest = max(largest, abs(load(first, origin + vec2(i % 8, i / 8))));
    }
    return largest;
}

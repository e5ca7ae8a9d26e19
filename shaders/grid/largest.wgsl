// The largest of a block of texels, which is spread as those of sums are, channel by channel, without their signs.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let stride = (extent(first) + 7) / 8;
    var largest = vec4(0.0);
    for (var i = 0; i < 64; i++) {
        largest = max(largest, abs(load(first, place + stride * vec2(i % 8, i / 8))));
    }
    return largest;
}

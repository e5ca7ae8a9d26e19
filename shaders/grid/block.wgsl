// The terms of a block, which each kernel has its own, made one by merged. A block is spread over the whole, so that those who
// compute beside each other read beside each other; it is gone through by pairs of pairs, so that sums lose less in rounding, and
// without a loop, in which each read would wait for the last one.

fn stride() -> vec2<i32> {
    return (extent(first) + 7) / 8;
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    return merged(four_rows(place), four_rows(place + vec2(0, 4 * stride().y)));
}

fn four_rows(place: vec2<i32>) -> vec4<f32> {
    return merged(two_rows(place), two_rows(place + vec2(0, 2 * stride().y)));
}

fn two_rows(place: vec2<i32>) -> vec4<f32> {
    return merged(row(place), row(place + vec2(0, stride().y)));
}

fn row(place: vec2<i32>) -> vec4<f32> {
    return merged(four(place), four(place + vec2(4 * stride().x, 0)));
}

fn four(place: vec2<i32>) -> vec4<f32> {
    return merged(two(place), two(place + vec2(2 * stride().x, 0)));
}

fn two(place: vec2<i32>) -> vec4<f32> {
    return merged(term(place), term(place + vec2(stride().x, 0)));
}

// The sum of the terms of a block, which is spread over the whole, so that those who compute beside each other read beside each
// other; by rows, so that less is lost in rounding.
fn kernel(place: vec2<i32>) -> vec4<f32> {
    let stride = (extent(first) + 7) / 8;
    var sum = vec4(0.0);
    for (var y = 0; y < 8; y++) {
        var row = vec4(0.0);
        for (var x = 0; x < 8; x++) {
            row += term(place + stride * vec2(x, y));
        }
        sum += row;
    }
    return sum;
}

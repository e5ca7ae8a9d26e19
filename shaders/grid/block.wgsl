// The sum of the terms of a block; by rows, so that less is lost in rounding.
fn kernel(place: vec2<i32>) -> vec4<f32> {
    let origin = 8 * place;
    var sum = vec4(0.0);
    for (var y = 0; y < 8; y++) {
        var row = vec4(0.0);
        for (var x = 0; x < 8; x++) {
            row += term(origin + vec2(x, y));
        }
        sum += row;
    }
    return sum;
}

// The sum of the terms of a block; by rows, so that less is lost in rounding.
@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let origin = 8 * vec2<i32>(position.xy);
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

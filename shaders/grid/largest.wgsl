// The largest of a block of texels, channel by channel, without their signs.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let origin = 8 * vec2<i32>(position.xy);
    var largest = vec4(0.0);
    for (var i = 0; i < 64; i++) {
        largest = max(largest, abs(load(first, origin + vec2(i % 8, i / 8))));
    }
    return largest;
}

// A first value: that of the coarser unknown, or, for what is no part of any, the colours in first that hold it.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    let hold = textureLoad(holds, place, 0);
    if hold.w == 0.0 && hold.x > 0.0 {
        return textureLoad(first, place, 0) / hold.x;
    }
    return parent_value(place);
}

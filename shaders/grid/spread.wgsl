// A first value: that of the coarser unknown, or, for what is no part of any, the colours in first that hold it.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let hold = texel(holds, place);
    if hold.w == 0.0 && hold.x > 0.0 {
        return texel(first, place) / hold.x;
    }
    return parent_value(place);
}

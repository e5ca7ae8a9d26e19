// What holds the part of the coarser level that an unknown belongs to, and to which colours: what is in first, of that unknown
// and of those beside it that are parts of none, as far as it reaches them.

fn weighted(weight: f32, place: vec2<i32>) -> vec4<f32> {
    if weight > 0.0 {
        let hold = texel(holds, place);
        if hold.w == 0.0 {
            return texel(first, place) * (weight / hold.y);
        }
    }
    return vec4(0.0);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let hold = texel(holds, place);
    return texel(first, place) * ((hold.y - hold.x) / max(hold.y, 1e-30)) + linked(place);
}

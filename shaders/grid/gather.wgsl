// What an unknown adds to how its part of the coarser level is held, and to which colours: what is in first, of its own and of the
// unknowns beside it that are parts of none, as far as it reaches that part.

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
    // Where there is no unknown, nothing is added.
    return texel(first, place) * ((hold.y - hold.x) / max(hold.y, 1e-30)) + linked(place);
}

// The right side of the coarser level, given the residual in first: the transpose of interpolate.

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) * texel(holds, place).z;
}

// The share of one unknown, if it is a part of this slot at all.
fn share(place: vec2<i32>, slot: i32) -> vec4<f32> {
    let hold = load(holds, place);
    if i32(hold.w) != slot + 1 {
        return vec4(0.0);
    }
    return texel(first, place) * (1.0 - hold.y * hold.z) + linked(place);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let cell = vec2(place.x % coarse_columns(), place.y);
    var sum = vec4(0.0);
    for (var quarter = 0; quarter < 4; quarter++) {
        let fine = 2 * cell + vec2(quarter & 1, quarter >> 1u);
        for (var slot = 0; slot < level.slots && fine.x < level.columns; slot++) {
            sum += share(vec2(slot * level.columns + fine.x, fine.y), place.x / coarse_columns());
        }
    }
    return sum;
}

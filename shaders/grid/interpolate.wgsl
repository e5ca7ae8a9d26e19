// The values in first with the correction of the coarser level: that of their own part, and of those they are linked to.

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return parent_value(place);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let hold = texel(holds, place);
    let own = parent_value(place) * (1.0 - hold.y * hold.z);
    return texel(first, place) + own + linked(place) * hold.z;
}

// The values in first with the correction of the coarser level: that of their own part, and of those they are linked to.

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return parent_value(place);
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    let hold = textureLoad(holds, place, 0);
    let own = parent_value(place) * (1.0 - hold.y * hold.z);
    return textureLoad(first, place, 0) + own + linked(place) * hold.z;
}

// The value, in second, of the coarser unknown that an unknown is a part of.
fn parent_value(place: vec2<i32>) -> vec4<f32> {
    let slot = i32(texel(holds, place).w) - 1;
    if slot < 0 {
        return vec4(0.0);
    }
    return texel(second, vec2(slot * coarse_columns() + place.x % level.columns / 2, place.y / 2));
}

// The numbers of unknowns, in first, with the slot of the coarser cell that they are a part of, as second marks it.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let cell = place.x % level.columns;
    let slot = place.x / level.columns;
    let quarter = (cell & 1) + 2 * (place.y & 1);
    let digits = u32(texel(second, vec2(cell, place.y) / 2)[quarter]);
    let parent = (digits >> (3u * u32(slot))) & 7u;
    return vec4(texel(first, place).xyz, f32(parent));
}

// The sum of what is in first over the unknowns that one of the coarser level is made of, as second marks them.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let cell = vec2(place.x % coarse_columns(), place.y);
    let slot = u32(place.x / coarse_columns());
    let marks = vec4<u32>(texel(second, cell));
    var sum = vec4(0.0);
    for (var quarter = 0; quarter < 4; quarter++) {
        let fine = 2 * cell + vec2(quarter & 1, quarter >> 1u);
        for (var own = 0; own < level.slots; own++) {
            if ((marks[quarter] >> (3u * u32(own))) & 7u) == slot + 1u {
                sum += texel(first, vec2(own * level.columns + fine.x, fine.y));
            }
        }
    }
    return sum;
}

// The sum of share, which each kernel has its own, over the unknowns that one of the coarser level is made of.
fn parts(place: vec2<i32>) -> vec4<f32> {
    let cell = vec2(place.x % coarse_columns(), place.y);
    let slot = place.x / coarse_columns();
    var sum = vec4(0.0);
    for (var quarter = 0; quarter < 4; quarter++) {
        let fine = 2 * cell + vec2(quarter & 1, quarter >> 1u);
        for (var own = 0; own < level.slots && fine.x < level.columns; own++) {
            let unknown = vec2(own * level.columns + fine.x, fine.y);
            if i32(load(holds, unknown).w) == slot + 1 {
                sum += share(unknown);
            }
        }
    }
    return sum;
}

// Weights of the links of the unknowns of the coarser level to the slots of the cell beside them that lies as far to the east
// and to the south as the one texel of first says; of their own, where that is nowhere.

var<private> target_cell: vec2<i32>;
var<private> own_slot: i32;
var<private> own_damping: f32;

fn weighted(weight: f32, place: vec2<i32>) -> vec4<f32> {
    if weight > 0.0 {
        let other = texel(holds, place);
        let cell = vec2(place.x % level.columns, place.y) / 2;
        if all(cell == target_cell) && other.w != f32(own_slot + 1) {
            let lengthened = weight / (1.0 + 2.0 * weight * (own_damping + other.z));
            return select(vec4(0.0), vec4(lengthened), vec4(other.w) == vec4(1.0, 2.0, 3.0, 4.0));
        }
    }
    return vec4(0.0);
}

fn share(place: vec2<i32>) -> vec4<f32> {
    own_damping = texel(holds, place).z;
    return linked(place);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let step = vec2<i32>(texel(first, vec2(0)).xy);
    target_cell = vec2(place.x % coarse_columns(), place.y) + step;
    own_slot = select(-1, place.x / coarse_columns(), all(step == vec2(0)));
    return parts(place);
}

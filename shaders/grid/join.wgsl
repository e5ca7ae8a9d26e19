// What an unknown adds to the weights of the links of its part of the coarser level, to the slots of the cell that lies as far
// to the east and to the south as the one texel of first says; of its own, where that is nowhere.

var<private> target_cell: vec2<i32>;
// The slot that is not linked to, counted from 1: the own one within a cell.
var<private> left_out: f32;
var<private> damping: f32;

fn weighted(weight: f32, place: vec2<i32>) -> vec4<f32> {
    if weight > 0.0 {
        let other = texel(holds, place);
        let cell = vec2(place.x % level.columns, place.y) / 2;
        if all(cell == target_cell) && other.w != left_out {
            let lengthened = weight / (1.0 + 2.0 * weight * (damping + other.z));
            return select(vec4(0.0), vec4(lengthened), vec4(other.w) == vec4(1.0, 2.0, 3.0, 4.0));
        }
    }
    return vec4(0.0);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let step = vec2<i32>(texel(first, vec2(0)).xy);
    let hold = texel(holds, place);
    target_cell = vec2(place.x % level.columns, place.y) / 2 + step;
    left_out = select(0.0, hold.w, all(step == vec2(0)));
    damping = hold.z;
    return linked(place);
}

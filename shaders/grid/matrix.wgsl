// The matrix of a level, times the vector that value_at gives, which each kernel has its own: by the differences along links,
// whose rounding is as small as they are. After multiplied, own is the value at its place.

var<private> own: vec4<f32>;

fn weighted(weight: f32, place: vec2<i32>) -> vec4<f32> {
    if weight > 0.0 {
        return weight * (value_at(place) - own);
    }
    return vec4(0.0);
}

fn multiplied(place: vec2<i32>) -> vec4<f32> {
    own = value_at(place);
    let hold = texel(holds, place);
    // Most slots of coarser levels are those of no unknown, and have no links to be looked at.
    if hold.y == 0.0 {
        return vec4(0.0);
    }
    return hold.x * own - linked(place);
}

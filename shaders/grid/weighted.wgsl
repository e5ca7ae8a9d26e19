// What a link adds in kernels that add up linked_value, which each has its own, by the weights of links.
fn weighted(weight: f32, place: vec2<i32>) -> vec4<f32> {
    if weight > 0.0 {
        return weight * linked_value(place);
    }
    return vec4(0.0);
}

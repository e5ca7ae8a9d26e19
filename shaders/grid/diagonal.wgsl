// The numbers of unknowns whose links are known: how strongly they are held, as first says, the diagonal, the damping of the
// interpolation; and no part of the coarser level yet.

var<private> largest: f32;

fn weighted(weight: f32, place: vec2<i32>) -> vec4<f32> {
    largest = max(largest, weight);
    return vec4(weight);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    largest = 0.0;
    let hold = weights(first, place).x;
    let diagonal = hold + linked(place).x;
    let most = max(diagonal, 4.0 * largest);
    if most > 0.0 {
        return vec4(hold, diagonal, 1.0 / most, 0.0);
    }
    return vec4(0.0);
}

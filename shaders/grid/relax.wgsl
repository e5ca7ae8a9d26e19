// One step of Jacobi's method for the values in first and the right side in second, by the part of the way in third.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    let value = textureLoad(first, place, 0);
    let diagonal = textureLoad(holds, place, 0).y;
    if diagonal > 0.0 {
        let residual = textureLoad(second, place, 0) - multiplied(place);
        return value + residual * (textureLoad(third, vec2(0), 0).x / diagonal);
    }
    return value;
}

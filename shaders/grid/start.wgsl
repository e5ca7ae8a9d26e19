// The first step of Jacobi's method from zero, for the right side in first, by the part of the way in second.

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = vec2<i32>(position.xy);
    let diagonal = textureLoad(holds, place, 0).y;
    if diagonal > 0.0 {
        return textureLoad(first, place, 0) * (textureLoad(second, vec2(0), 0).x / diagonal);
    }
    return vec4(0.0);
}

// A texel, zeros beyond the border.
fn load(texels: Texels, place: vec2<i32>) -> vec4<f32> {
    if any(place < vec2(0)) || any(place >= extent(texels)) {
        return vec4(0.0);
    }
    return texel(texels, place);
}

// Single texels of numbers, each given by its centre in clip space.

struct Varying {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) numbers: vec4<u32>,
}

@vertex
fn vertex(@location(0) center: vec2<f32>, @location(1) numbers: vec4<u32>) -> Varying {
    return Varying(vec4(center, 0.0, 1.0), numbers);
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<u32> {
    return in.numbers;
}

// Numbers are written as the bits of halves, two in each channel, and eight times as large: cycles lose their last bits later.

fn written(numbers: vec4<f32>) -> vec4<u32> {
    let halves = clamp(8.0 * numbers, vec4(-65504.0), vec4(65504.0));
    return vec4(pack2x16float(halves.xy), pack2x16float(halves.zw), 0u, 1u);
}

// Computes every texel of a target, on devices that can do so without drawing.

@group(0) @binding(3) var result: Result;

@compute @workgroup_size(8, 8)
fn compute(@builtin(global_invocation_id) id: vec3<u32>) {
    if all(id.xy < textureDimensions(result)) {
        let place = vec2<i32>(id.xy);
        textureStore(result, place, written(kernel(place)));
    }
}

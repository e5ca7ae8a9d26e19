// Many passes over few texels, one after the other, computed by one work group: what waits between passes that are computed
// each by itself takes longer than they do. All texels lie in one buffer; some come from textures, some go into one.

struct Texels {
    offset: u32,
    width: i32,
    height: i32,
}

struct Instruction {
    kernel: u32,
    columns: i32,
    slots: i32,
    result: Texels,
    first: Texels,
    second: Texels,
    third: Texels,
    east: Texels,
    south: Texels,
    within: Texels,
    holds: Texels,
}

@group(0) @binding(0) var outlet: Result;
@group(0) @binding(1) var<storage, read> instructions: array<Instruction>;
@group(0) @binding(2) var<storage, read_write> pool: array<vec4<f32>>;
@group(0) @binding(3) var inlet0: texture_2d<u32>;
@group(0) @binding(4) var inlet1: texture_2d<u32>;
@group(0) @binding(5) var inlet2: texture_2d<u32>;
@group(0) @binding(6) var inlet3: texture_2d<u32>;
@group(0) @binding(7) var inlet4: texture_2d<u32>;
@group(0) @binding(8) var inlet5: texture_2d<u32>;
@group(0) @binding(9) var inlet6: texture_2d<u32>;
@group(0) @binding(10) var inlet7: texture_2d<u32>;

var<private> level: Level;
var<private> first: Texels;
var<private> second: Texels;
var<private> third: Texels;
var<private> east: Texels;
var<private> south: Texels;
var<private> within: Texels;
var<private> holds: Texels;

fn extent(texels: Texels) -> vec2<i32> {
    return vec2(texels.width, texels.height);
}

fn index(texels: Texels, place: vec2<i32>) -> u32 {
    return texels.offset + u32(place.y * texels.width + place.x);
}

// A texel within the border. In the pool all are floats.
fn texel(texels: Texels, place: vec2<i32>) -> vec4<f32> {
    return pool[index(texels, place)];
}

fn weights(texels: Texels, place: vec2<i32>) -> vec4<f32> {
    return load(texels, place);
}

fn inlet(i: u32, place: vec2<i32>) -> vec4<u32> {
    switch i {
        case 0u: { return textureLoad(inlet0, place, 0); }
        case 1u: { return textureLoad(inlet1, place, 0); }
        case 2u: { return textureLoad(inlet2, place, 0); }
        case 3u: { return textureLoad(inlet3, place, 0); }
        case 4u: { return textureLoad(inlet4, place, 0); }
        case 5u: { return textureLoad(inlet5, place, 0); }
        case 6u: { return textureLoad(inlet6, place, 0); }
        default: { return textureLoad(inlet7, place, 0); }
    }
}

fn prepare(instruction: Instruction) {
    level = Level(instruction.columns, instruction.slots, vec2(0));
    first = instruction.first;
    second = instruction.second;
    third = instruction.third;
    east = instruction.east;
    south = instruction.south;
    within = instruction.within;
    holds = instruction.holds;
}

fn execute(instruction: Instruction, place: vec2<i32>) {
    switch instruction.kernel {
        case TAKE: {
            pool[index(instruction.result, place)] = bitcast<vec4<f32>>(inlet(instruction.first.offset, place));
        }
        case GIVE: {
            textureStore(outlet, place, written(texel(first, place)));
        }
        default: {
            pool[index(instruction.result, place)] = kernel(instruction.kernel, place);
        }
    }
}

@compute @workgroup_size(512)
fn compute(@builtin(local_invocation_index) thread: u32) {
    for (var i = 0u; i < arrayLength(&instructions); i++) {
        let instruction = instructions[i];
        prepare(instruction);
        let width = instruction.result.width;
        let count = width * instruction.result.height;
        for (var number = i32(thread); number < count; number += 512) {
            execute(instruction, vec2(number % width, number / width));
        }
        storageBarrier();
    }
}

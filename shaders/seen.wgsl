// What is seen of a solved grid at a place. Who asks binds it: grid; the bits of the colours of pixels, times their opacity,
// and the opacity, in values; by cell the first of the pieces of curves and closed gaps in it, and their number, in cells; the
// bits of the ends of pieces, in pixels of the grid, in pieces.
//
// A *cell* is the square between the centres of four pixels of the grid. A place takes the colours of those centres that
// no curve hides from it, by their nearness.

struct Grid {
    // From pixels of the target to those of the grid: columns x and y of the linear part, and the shift.
    linear: vec4<f32>,
    shift: vec4<f32>,
}

// A curve that passes through the centre of a pixel, to so many pixels, hides it: which side it is on is rounding.
const BEYOND = 0.01;

// What keeps weights above zero.
const LEAST_WEIGHT = 1e-6;

fn on_grid(place: vec2<f32>) -> vec2<f32> {
    return grid.linear.xy * place.x + grid.linear.zw * place.y + grid.shift.xy;
}

// Beyond the border what is at it goes on.
fn cell_of(place: vec2<f32>) -> vec2<i32> {
    return clamp(vec2<i32>(floor(place + 0.5)), vec2(0), vec2<i32>(textureDimensions(values)));
}

fn color_at(place: vec2<f32>) -> vec4<f32> {
    let cell = cell_of(place);
    let listed = textureLoad(cells, cell, 0).xy;
    let last = vec2<i32>(textureDimensions(values)) - 1;
    let far_weight = saturate(place + 0.5 - vec2<f32>(cell));
    var seen = vec4(0.0);
    var seen_weight = 0.0;
    var all = vec4(0.0);
    for (var corner = 0; corner < 4; corner++) {
        let far = vec2(corner % 2, corner / 2);
        let pixel = clamp(cell + far - 1, vec2(0), last);
        let weights = mix(1.0 - far_weight, far_weight, vec2<f32>(far)) + LEAST_WEIGHT;
        let weight = weights.x * weights.y;
        let color = weight * bitcast<vec4<f32>>(textureLoad(values, pixel, 0));
        all += color;
        if !is_hidden(place, vec2<f32>(pixel) + 0.5, listed) {
            seen += color;
            seen_weight += weight;
        }
    }
    if seen_weight > 0.0 {
        return seen / seen_weight;
    }
    // Between curves that are closer than pixels.
    return all;
}

// Whether one of the listed pieces passes between a place and the centre of a pixel.
fn is_hidden(place: vec2<f32>, center: vec2<f32>, listed: vec2<u32>) -> bool {
    let way = center - place;
    let end = center + BEYOND * way / max(length(way), BEYOND);
    let columns = textureDimensions(pieces).x;
    for (var i = listed.x; i < listed.x + listed.y; i++) {
        let piece = bitcast<vec4<f32>>(textureLoad(pieces, vec2(i % columns, i / columns), 0));
        if are_apart(piece.xy, piece.zw, place, end) && are_apart(place, end, piece.xy, piece.zw) {
            return true;
        }
    }
    return false;
}

// Whether c and d are on different sides of the line from a to b.
fn are_apart(a: vec2<f32>, b: vec2<f32>, c: vec2<f32>, d: vec2<f32>) -> bool {
    return (turn(a, b, c) > 0.0) != (turn(a, b, d) > 0.0);
}

fn turn(a: vec2<f32>, b: vec2<f32>, c: vec2<f32>) -> f32 {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

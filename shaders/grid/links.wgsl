// The sum of weighted, which each kernel has its own, over what is linked to an unknown, with the weights of the links.
// Where there is no cell beside it, another one is looked at: its weight there is zero.
fn linked(place: vec2<i32>) -> vec4<f32> {
    let cell = place.x % level.columns;
    let slot = place.x / level.columns;
    let to_east = weights(east, place);
    let to_south = weights(south, place);
    let inside = weights(within, place);
    var sum = vec4(0.0);
    for (var other = 0; other < level.slots; other++) {
        let across = vec2(other * level.columns + cell, place.y);
        let western = across - vec2(1, 0);
        let northern = across - vec2(0, 1);
        sum += weighted(to_east[other], across + vec2(1, 0));
        sum += weighted(to_south[other], across + vec2(0, 1));
        sum += weighted(weights(east, western)[slot], western);
        sum += weighted(weights(south, northern)[slot], northern);
        sum += weighted(inside[other], across);
    }
    return sum;
}

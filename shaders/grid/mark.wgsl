// For each cell of the coarser level, which of its slots the unknowns of the finer one are parts of: a channel for each of
// its quarters, a digit of eight for each of their slots. Unknowns are one part where links between them are strong.

// A link weaker than this, as a part of the sum of the links of either unknown, does not make two unknowns one part.
const STRONG: f32 = 0.08;

// By member: the sum of its links, how strongly it is held, and those that it has strong links to, a bit for each.
var<private> links: array<f32, 16>;
var<private> held: array<f32, 16>;
var<private> strong: array<u32, 16>;
// By member that is the first of a part: all of that part, and what the coarser level can do for it.
var<private> wholes: array<u32, 16>;
var<private> scores: array<f32, 16>;

// As many of 16 as there are.
fn member_count() -> i32 {
    return 4 * level.slots;
}

fn member_place(cell: vec2<i32>, member: i32) -> vec2<i32> {
    let quarter = member / level.slots;
    let fine = 2 * cell + vec2(quarter & 1, quarter >> 1u);
    return vec2(member % level.slots * level.columns + fine.x, fine.y);
}

fn find(cell: vec2<i32>, member: i32) {
    let is_within = 2 * cell.x + ((member / level.slots) & 1) < level.columns;
    let hold = load(holds, member_place(cell, member));
    links[member] = select(0.0, hold.y - hold.x, is_within);
    held[member] = select(0.0, hold.x, is_within);
    strong[member] = 1u << u32(member);
}

// Visits the links of a member to those before it.
fn visit_links(cell: vec2<i32>, member: i32) {
    let quarter = member / level.slots;
    let slot = member % level.slots;
    for (var other = 0; other < level.slots; other++) {
        if (quarter & 1) != 0 {
            let western = (quarter - 1) * level.slots + other;
            visit(member, western, load(east, member_place(cell, western))[slot]);
        }
        if (quarter & 2) != 0 {
            let northern = (quarter - 2) * level.slots + other;
            visit(member, northern, load(south, member_place(cell, northern))[slot]);
        }
        if other < slot {
            visit(member, member - slot + other, load(within, member_place(cell, member))[other]);
        }
    }
}

var<private> is_scoring: bool;

fn visit(a: i32, b: i32, weight: f32) {
    if weight > 0.0 && is_scoring {
        lessen(a, b, weight);
    } else if weight > 0.0 && weight >= STRONG * min(links[a], links[b]) {
        strong[a] |= 1u << u32(b);
        strong[b] |= 1u << u32(a);
    }
}

// Takes a link within a part away from those that lead out of it.
fn lessen(a: i32, b: i32, weight: f32) {
    for (var i = 0; i < member_count(); i++) {
        if ((wholes[i] >> u32(a)) & (wholes[i] >> u32(b)) & 1u) != 0u {
            scores[i] -= 2.0 * weight;
        }
    }
}

// All that hang together with a member.
fn whole(member: i32) -> u32 {
    var whole = 0u;
    var grown = strong[member];
    while grown != whole {
        whole = grown;
        for (var i = 0; i < member_count(); i++) {
            if ((whole >> u32(i)) & 1u) != 0u {
                grown |= strong[i];
            }
        }
    }
    return whole;
}

fn find_wholes() {
    var found = 0u;
    for (var i = 0; i < member_count(); i++) {
        wholes[i] = 0u;
        if ((found >> u32(i)) & 1u) == 0u {
            wholes[i] = whole(i);
            found |= wholes[i];
        }
    }
}

fn sum_over(whole: u32, is_held: bool) -> f32 {
    var sum = 0.0;
    for (var i = 0; i < member_count(); i++) {
        if ((whole >> u32(i)) & 1u) != 0u {
            sum += select(links[i], held[i], is_held);
        }
    }
    return sum;
}

fn score(cell: vec2<i32>) {
    for (var i = 0; i < member_count(); i++) {
        scores[i] = sum_over(wholes[i], false);
    }
    is_scoring = true;
    for (var i = 0; i < member_count(); i++) {
        visit_member(cell, i);
    }
    for (var i = 0; i < member_count(); i++) {
        let out = scores[i];
        scores[i] = select(0.0, out * out / (out + sum_over(wholes[i], true)), out > 0.0);
    }
}

fn visit_member(cell: vec2<i32>, member: i32) {
    if links[member] + held[member] > 0.0 {
        visit_links(cell, member);
    }
}

fn best() -> i32 {
    var best = 0;
    for (var i = 1; i < member_count(); i++) {
        if scores[i] > scores[best] {
            best = i;
        }
    }
    return best;
}

// Adds a slot to the digits of a part.
fn marked(marks: vec4<f32>, whole: u32, slot: i32) -> vec4<f32> {
    var sum = marks;
    for (var i = 0; i < member_count(); i++) {
        if ((whole >> u32(i)) & 1u) != 0u {
            let digit = f32(slot << (3u * u32(i % level.slots)));
            sum += select(vec4(0.0), vec4(digit), vec4(i / level.slots) == vec4(0, 1, 2, 3));
        }
    }
    return sum;
}

fn kernel(cell: vec2<i32>) -> vec4<f32> {
    is_scoring = false;
    for (var i = 0; i < member_count(); i++) {
        find(cell, i);
    }
    for (var i = 0; i < member_count(); i++) {
        visit_member(cell, i);
    }
    find_wholes();
    score(cell);
    var marks = vec4(0.0);
    for (var slot = 1; slot <= select(4, 2, level.slots == 1); slot++) {
        let chosen = best();
        if scores[chosen] > 0.0 {
            marks = marked(marks, wholes[chosen], slot);
            scores[chosen] = 0.0;
        }
    }
    return marks;
}

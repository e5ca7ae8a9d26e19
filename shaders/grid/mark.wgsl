// For each cell of the coarser level, which of its slots the unknowns of the finer one are parts of: a channel for each of
// its quarters, a digit of eight for each of their slots. Unknowns are one part where links between them are strong.

// A link weaker than this, as a part of the sum of the links of either unknown, does not make two unknowns one part.
const STRONG: f32 = 0.08;

// By member: the sum of its links, how strongly it is held, those that it has strong links to, a bit for each; and the first
// member of its part.
var<private> links: array<f32, 16>;
var<private> held: array<f32, 16>;
var<private> strong: array<u32, 16>;
var<private> firsts: array<i32, 16>;
// By member that is the first of a part: all of its links, how strongly it is held, and what the coarser level can do for it.
var<private> linked: array<f32, 16>;
var<private> holding: array<f32, 16>;
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
    firsts[member] = -1;
    linked[member] = 0.0;
    holding[member] = 0.0;
}

fn is_member(i: i32) -> bool {
    return links[i] + held[i] > 0.0;
}

// Visits the links of a member to those before it.
fn visit_links(cell: vec2<i32>, member: i32) {
    let quarter = member / level.slots;
    let slot = member % level.slots;
    for (var other = 0; other < level.slots; other++) {
        if (quarter & 1) != 0 {
            let western = (quarter - 1) * level.slots + other;
            visit(member, western, weights(east, member_place(cell, western))[slot]);
        }
        if (quarter & 2) != 0 {
            let northern = (quarter - 2) * level.slots + other;
            visit(member, northern, weights(south, member_place(cell, northern))[slot]);
        }
        if other < slot {
            visit(member, member - slot + other, weights(within, member_place(cell, member))[other]);
        }
    }
}

var<private> is_scoring: bool;

// Finds strong links; then takes those within a part away from those that lead out of it.
fn visit(a: i32, b: i32, weight: f32) {
    if is_scoring {
        if firsts[a] == firsts[b] {
            scores[firsts[a]] -= 2.0 * weight;
        }
    } else if weight > 0.0 && weight >= STRONG * min(links[a], links[b]) {
        strong[a] |= 1u << u32(b);
        strong[b] |= 1u << u32(a);
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

fn find_parts() {
    for (var first = 0; first < member_count(); first++) {
        if is_member(first) && firsts[first] < 0 {
            let whole = whole(first);
            for (var i = first; i < member_count(); i++) {
                firsts[i] = select(firsts[i], first, ((whole >> u32(i)) & 1u) != 0u);
            }
        }
    }
}

fn score(cell: vec2<i32>) {
    for (var i = 0; i < member_count(); i++) {
        if is_member(i) {
            linked[firsts[i]] += links[i];
            holding[firsts[i]] += held[i];
        }
    }
    scores = linked;
    is_scoring = true;
    visit_members(cell);
    for (var i = 0; i < member_count(); i++) {
        let out = scores[i];
        // Less is what rounding leaves of links that all stay within; that of halves may leave more, for a slot without links.
        scores[i] = select(0.0, out * out / (out + holding[i]), out > 1e-5 * (linked[i] + holding[i]));
    }
}

fn visit_members(cell: vec2<i32>) {
    for (var i = 0; i < member_count(); i++) {
        if is_member(i) {
            visit_links(cell, i);
        }
    }
}

fn best() -> i32 {
    var best = 0;
    for (var i = 1; i < member_count(); i++) {
        // Devices round differently: the first counts of those that are nearly the same.
        if scores[i] > 1.001 * scores[best] {
            best = i;
        }
    }
    return best;
}

// Adds a slot to the digits of the part of a member.
fn marked(marks: vec4<f32>, first: i32, slot: i32) -> vec4<f32> {
    var sum = marks;
    for (var i = first; i < member_count(); i++) {
        if firsts[i] == first {
            let digit = f32(slot << (3u * u32(i % level.slots)));
            sum += select(vec4(0.0), vec4(digit), vec4(i / level.slots) == vec4(0, 1, 2, 3));
        }
    }
    return sum;
}

fn kernel(cell: vec2<i32>) -> vec4<f32> {
    for (var i = 0; i < member_count(); i++) {
        find(cell, i);
    }
    is_scoring = false;
    visit_members(cell);
    find_parts();
    score(cell);
    var marks = vec4(0.0);
    for (var slot = 1; slot <= select(4, 2, level.slots == 1); slot++) {
        let chosen = best();
        if scores[chosen] > 0.0 {
            marks = marked(marks, chosen, slot);
            scores[chosen] = 0.0;
        }
    }
    return marks;
}

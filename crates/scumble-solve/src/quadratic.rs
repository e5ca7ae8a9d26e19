//! The shape functions of quadratic elements: each is one at its own node and zero at the others.

/// Those of a triangle at a place given by the weights of its corners: corners 0, 1, 2, then the middle of edges 01,
/// 12, 20.
pub fn triangle([u, v, w]: [f64; 3]) -> [f64; 6] {
    let corner = |t: f64| t * (2.0 * t - 1.0);
    [corner(u), corner(v), corner(w), 4.0 * u * v, 4.0 * v * w, 4.0 * w * u]
}

/// Those of an edge, `t` of the way from its start to its end: start, middle, end.
pub fn edge(t: f64) -> [f64; 3] {
    [(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)]
}

/// The colour at a place of a triangle of which six colours are given.
#[inline(never)] // It is large, and where it is called nothing waits for it.
pub fn color(colors: &[[f32; 4]; 6], weights: [f64; 3]) -> [f32; 4] {
    let shape = triangle(weights);
    [0, 1, 2, 3].map(|i| (0..6).map(|k| shape[k] * f64::from(colors[k][i])).sum::<f64>() as f32)
}

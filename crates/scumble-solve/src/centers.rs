//! The colours of a field at the centres of pixels.

use kurbo::{Point, Vec2};
use scumble_core::clamped;

use crate::field::Field;
use crate::quadratic;
use crate::scene::View;

/// Blend-space colours times opacity, and opacity, row by row; zeros where there is no field.
pub fn colors(field: &Field, view: &View) -> Vec<[f32; 4]> {
    let width = view.width_px as usize;
    let mut pixels = vec![[0.0; 4]; width * view.height_px as usize];
    for triangle in &field.triangles {
        let corners = triangle
            .corners
            .map(|[x, y]| view.px_from_du * Point::new(x.into(), y.into()) - Vec2::new(0.5, 0.5));
        for y in within(corners.map(|p| p.y), view.height_px) {
            for x in within(corners.map(|p| p.x), view.width_px) {
                if let Some(weights) = weights(corners, Point::new(x as f64, y as f64)) {
                    pixels[y * width + x] = quadratic::color(&triangle.colors, weights);
                }
            }
        }
    }
    pixels
}

/// The whole numbers between the least and the largest coordinate that count rows or columns.
fn within(coordinates: [f64; 3], count: u32) -> std::ops::Range<usize> {
    let least = coordinates.iter().copied().fold(f64::INFINITY, f64::min);
    let most = coordinates.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    least.ceil().max(0.0) as usize..clamped(most.floor() + 1.0, [0.0, f64::from(count)]) as usize
}

/// The weights of the corners at a point of a triangle.
fn weights([a, b, c]: [Point; 3], p: Point) -> Option<[f64; 3]> {
    /// What a point may lie outside, as a part of the triangle: so much that no point between two falls through.
    const SLACK: f64 = 1e-9;
    let area = (b - a).cross(c - a);
    let [v, w] = [(p - a).cross(c - a) / area, (b - a).cross(p - a) / area];
    let weights = [1.0 - v - w, v, w];
    weights.iter().all(|&weight| weight >= -SLACK).then_some(weights)
}

//! A painter's own field, in which it replaces what has changed alone.

use scumble_solve::{Field, FieldChange};

/// Follows another field.
pub(crate) fn follow(own: &mut Field, field: &Field, change: &FieldChange) {
    let count = field.triangles.len();
    own.triangles.resize_with(count, Default::default);
    let places = change.places.start.min(count)..change.places.end.min(count);
    own.triangles[places.clone()].copy_from_slice(&field.triangles[places]);
    own.blend = field.blend;
    assert!(own == field, "{change:?}");
}

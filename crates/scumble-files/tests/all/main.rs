//! What the page opens and exports.

mod exporting;
mod opening;

//! Files in and out: SVG drawings, scribbles as JSON, PNG pictures.
//!
//! Nothing here trusts its input: limits are checked before anything is built, and what cannot be used is either
//! an error that says what to do or a note with a count.
//!
//! | noun | file |
//! |---|---|
//! | an SVG drawing as curves | `svg` |
//! | … its part that is shown, and its units | `page` |
//! | … its paints as single colours | `paint` |
//! | … its paths as Bézier paths | `outline` |
//! | … what keeps a hostile file from hanging the reader | `limits`, `expansion`, `geometry`, `style_sheet` |
//! | … what was left out | `survey`, `notes` |
//! | scribbles as JSON | `scribbles` |
//! | pictures as PNG | `picture_file` |

mod error;
mod expansion;
mod geometry;
mod limits;
mod notes;
mod outline;
mod page;
mod paint;
mod picture_file;
mod scribbles;
mod style_sheet;
mod survey;
mod svg;

pub use error::{ImportError, ScribblesError};
pub use notes::{ImportNotes, ScribbleNotes};
pub use picture_file::{PictureFileError, write_png};
pub use scribbles::{ReadScribbles, read_scribbles};
pub use svg::{Import, import_svg};

/// Largest file that is read, in bytes.
pub const MAX_FILE_BYTES: usize = 20_000_000;

//! Files and links in and out: Scumble's own, SVG drawings, diffusion curves, scribbles as JSON, PNG pictures.
//!
//! Nothing here trusts its input: limits are checked before anything is built, and what cannot be used is either
//! an error that says what to do or a note with a count.
//!
//! | noun | file |
//! |---|---|
//! | an SVG drawing as curves | `svg` |
//! | … its part that is shown, and its units | `page` |
//! | … how large it is where it is printed | `page_size` |
//! | … its paints as single colours | `paint` |
//! | … what its lines look like | `look` |
//! | … its colours and styles as browsers read them | `css` |
//! | … its paths as Bézier paths | `outline` |
//! | … what its clip paths and masks leave | `clip` |
//! | … which masks are followed | `masks` |
//! | … what its areas hide | `hidden` |
//! | … which of its outlines are lines, too | `doubles` |
//! | … what keeps a hostile file from hanging the reader | `limits`, `expansion`, `geometry`, `style_sheet` |
//! | … what was left out | `survey`, `notes` |
//! | diffusion curves as XML | `curve_set` |
//! | a drawing of either kind | `drawing_file` |
//! | scribbles as JSON | `scribbles` |
//! | palettes | `palette` |
//! | pictures to trace, as PNG or JPEG | `image_file` |
//! | pictures as PNG | `picture_file` |
//! | work as a `.scumble` file | `work_file`, `json`, `base64` |
//! | … as a link | `link`, `packed`, `checksum` |
//! | … within an SVG that was made of it | `svg_source` |

mod base64;
mod checksum;
mod clip;
mod css;
mod curve_set;
mod doubles;
mod drawing_file;
mod error;
mod expansion;
mod geometry;
mod hidden;
mod image_file;
mod json;
mod limits;
mod link;
mod look;
mod masks;
mod notes;
mod outline;
mod packed;
mod page;
mod page_size;
mod paint;
mod palette;
mod picture_file;
mod scribbles;
mod style_sheet;
mod survey;
mod svg;
mod svg_source;
mod work_file;

pub use base64::padded as base64;
pub use curve_set::write_curve_set;
pub use drawing_file::import_drawing;
pub use error::{FileError, ImportError, LinkError, PaletteError, ScribblesError};
pub use image_file::{ImageError, MAX_IMAGE_BYTES, check_image, is_image, other_kind};
pub use json::push_number;
pub use link::{Link, MAX_LINK, read_link, write_link};
pub use notes::{CurveNotes, CurveSetNotes, ImportNotes, ScribbleNotes};
pub use packed::PackedSizes;
pub use page_size::PageSize;
pub use palette::{PaletteKind, ReadPalette, read_palette, write_palette};
pub use picture_file::{PictureFileError, write_png};
pub use scribbles::{ReadScribbles, read_scribbles};
pub use svg::{Import, import_svg};
pub use svg_source::{COLORS_CLASS, keeps_work, write_svg_source};
pub use work_file::{FILE_IMAGE, read_file, write_file};

/// Largest file that is read, in bytes.
pub const MAX_FILE_BYTES: usize = 20_000_000;

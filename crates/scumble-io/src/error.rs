//! What can be wrong with a file, each with what to do about it.

use scumble_core::work::MAX_SHADES;
use thiserror::Error;

use crate::MAX_FILE_BYTES;
use crate::notes::ImportNotes;

/// Why a file is not a drawing that can be coloured.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ImportError {
    /// No bytes, or nothing but white space.
    #[error("the file is empty; choose an SVG file")]
    Empty,
    /// More bytes than are read.
    #[error("the file is larger than the {} MB that can be opened; simplify the drawing or remove its pictures",
        MAX_FILE_BYTES / 1_000_000)]
    TooLarge,
    /// `.svgz`.
    #[error("the file is compressed (SVGZ); unpack it with gzip, or save it as plain SVG")]
    Compressed,
    /// Text in an encoding that SVG readers rarely know.
    #[error("the file is in UTF-16; save it in UTF-8")]
    Utf16,
    /// PDF or PostScript, also as `.ai` or `.eps`.
    #[error("the file is a {0} file; save it as SVG in the program that made it")]
    ForPrint(&'static str),
    /// Binary data.
    #[error("the file is not an SVG drawing: it is no text in UTF-8; save it so, or choose an SVG file")]
    NotText,
    /// Text that is no XML.
    #[error("this is no SVG drawing, or it is damaged: {0}; save it again, or choose another")]
    NotXml(String),
    /// Diffusion curves that are no XML.
    #[error("the diffusion curves are damaged: {0}; mend the file there, or save it again")]
    CurvesNotXml(String),
    /// XML with another root.
    #[error(
        "this is no drawing: it starts with <{0}>, not with <svg>, nor with <curve_set> as diffusion curves do; choose another"
    )]
    NotSvg(String),
    /// Entities that could grow without bound.
    #[error("the file declares XML entities that could grow without bound; save it again without them")]
    Entities,
    /// Too many elements, counting each copy that `<use>` makes.
    #[error(
        "the drawing has more than 200,000 elements, counting the copies that <use> makes; simplify it or split it"
    )]
    TooManyElements,
    /// Groups within groups.
    #[error(
        "the drawing has groups within groups too deep (at most {limit}, fewer in large drawings); ungroup it and save it again"
    )]
    TooDeep {
        /// The depth allowed.
        limit: u32,
    },
    /// Elements that refer to themselves.
    #[error(
        "elements of the drawing refer to each other in a circle, or in a long chain; replace the <use> elements or gradients by copies"
    )]
    Circular,
    /// Too many segments.
    #[error(
        "the drawing has too many lines: more than 500,000 segments, long curves counting more; simplify it, scale it down or split it"
    )]
    TooDetailed,
    /// Attributes without end.
    #[error(
        "the file has elements with too many attributes, or too many name spaces; save it again as plain SVG"
    )]
    TooManyAttributes,
    /// A list of dashes without end.
    #[error("the drawing has a list of dashes that is too long; use a shorter one")]
    TooManyDashes,
    /// A line as wide as a thousand pages.
    #[error("the drawing has a line that is wider than a million units, or a mitre as long; make it smaller")]
    TooWide,
    /// Gradients or patterns with too many parts.
    #[error("the drawing has a gradient or pattern with too many parts; replace it by a plain colour")]
    TooManyStops,
    /// Style sheets that take too long to apply.
    #[error("the style sheet of the drawing is too large; save the drawing with styles as attributes")]
    TooManyStyles,
    /// Width or height is zero, negative, or no number; or so large or small that no digits are left for what is on it.
    #[error(
        "the page of the drawing has no area, or is larger than 100 million units; give it another viewBox or size"
    )]
    NoPage,
    /// Diffusion curves on a page without a size.
    #[error(
        "the diffusion curves have no page; give <curve_set> an image_width and an image_height above zero"
    )]
    NoImageSize,
    /// Diffusion curves of which none has four points.
    #[error(
        "there is no diffusion curve that can be used; give each at least four control points with x and y"
    )]
    NoDiffusionCurves,
    /// Too many curves.
    #[error("the drawing has more than 200,000 curves; simplify it or split it")]
    TooManyCurves,
    /// Nothing to colour between.
    #[error("the drawing has no lines and no shapes to colour{}", but_has(.0))]
    NoCurves(ImportNotes),
}

fn but_has(notes: &ImportNotes) -> String {
    if notes.is_empty() { String::new() } else { format!(" ({notes})") }
}

/// Why a text is not a list of scribbles.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ScribblesError {
    /// No bytes, or nothing but white space.
    #[error(
        "the scribbles file is empty; it should read {{\"scribbles\":[{{\"color\":\"#rrggbb\",\"width\":1.5,\"points\":[[x,y],…]}},…]}}"
    )]
    Empty,
    /// More bytes than are read.
    #[error("the scribbles file is larger than the {} MB that can be read; use fewer points", MAX_FILE_BYTES / 1_000_000)]
    TooLarge,
    /// No JSON, or JSON of another form.
    #[error(
        "the scribbles file cannot be read: {0}; it should read {{\"scribbles\":[{{\"color\":\"#rrggbb\",\"width\":1.5,\"points\":[[x,y],…]}},…]}}"
    )]
    NotScribbles(String),
    /// There are scribbles, but each of them is faulty or off the page.
    #[error("none of the scribbles can be used: {0}")]
    NoneUsable(crate::notes::ScribbleNotes),
    /// The pen's way is too long to follow.
    #[error("the scribbles are longer than {limit_pages} pages in all; use fewer points")]
    TooLong {
        /// The length allowed, in longer sides of the page.
        limit_pages: u32,
    },
    /// Each takes memory of its own.
    #[error("more than {MAX_SHADES} of the scribbles shade; use fewer of them")]
    TooManyShades,
}

/// Why a file is not a palette that can be used, or why there is none to write.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum PaletteError {
    /// More bytes than are read.
    #[error("the palette is larger than the {} MB that can be opened; take colours out of it", MAX_FILE_BYTES / 1_000_000)]
    TooLarge,
    /// None of the known kinds.
    #[error(
        "the file is no palette: it is neither GIMP’s (.gpl), nor Adobe Swatch Exchange (.ase), nor a list of colours #rrggbb"
    )]
    NoPalette,
    /// No colour in it.
    #[error("the palette has no colours; add some to it")]
    NoColors,
    /// Colours, but none that could be read.
    #[error(
        "the palette has colours of unknown kinds alone ({count} of them); save it again with them in RGB"
    )]
    NoKnownColors {
        /// How many.
        count: usize,
    },
    /// Too many colours.
    #[error("the palette has more than {limit} colours; take some out of it")]
    TooManyColors {
        /// How many there may be.
        limit: usize,
    },
    /// Not as its kind has it.
    #[error(
        "the palette cannot be used: line {line} should have {expected}; mend it there, or save the palette again"
    )]
    Damaged {
        /// Counted from 1.
        line: usize,
        /// What should be there.
        expected: &'static str,
    },
    /// Swatches whose first bytes are others.
    #[error(
        "the palette is damaged: its first twelve bytes should be ASEF, a version and the number of blocks; save it again as Adobe Swatch Exchange"
    )]
    NoSwatches,
    /// Bytes are missing.
    #[error(
        "the palette is damaged: block {block} of {blocks} ends too soon, or says a wrong length; save or download it again"
    )]
    CutOff {
        /// Counted from 1.
        block: usize,
        /// How many there should be.
        blocks: usize,
    },
}

/// Why a file is not work that can be opened.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FileError {
    /// No bytes, or nothing but white space.
    #[error("the file is empty; choose a .scumble file that was saved")]
    Empty,
    /// More bytes than are read.
    #[error(
        "the file is larger than the {} MB that can be opened; simplify the drawing, or trace a smaller picture",
        MAX_FILE_BYTES / 1_000_000
    )]
    TooLarge,
    /// More bytes than could be read again.
    #[error(
        "the file would be larger than the {} MB that can be opened; simplify the drawing, or trace a smaller picture",
        MAX_FILE_BYTES / 1_000_000
    )]
    WouldBeTooLarge,
    /// Binary data, or text in another encoding.
    #[error("the file is not a Scumble file: it is no text in UTF-8; choose a .scumble file")]
    NotText,
    /// Some other text.
    #[error(
        "the file is not a Scumble file: it does not say {{\"format\": \"scumble\", \"version\": \"1.0\", …}}; choose a .scumble file"
    )]
    NotWork,
    /// A version whose files differ.
    #[error("the file was saved by a newer Scumble, in version {0} of the format; update Scumble to open it")]
    Newer(String),
    /// Not as the format has it.
    #[error(
        "the file cannot be used: line {line} should have {expected}; mend it there, or save the drawing again"
    )]
    Damaged {
        /// Counted from 1.
        line: usize,
        /// What should be there.
        expected: &'static str,
    },
    /// Too many curves.
    #[error("the drawing has more than 200,000 curves; simplify it or split it")]
    TooManyCurves,
    /// The pen's way is too long to follow.
    #[error("the scribbles are longer than {limit_pages} pages in all; use fewer of them")]
    TooLong {
        /// The length allowed, in longer sides of the page.
        limit_pages: u32,
    },
    /// Each takes memory of its own.
    #[error("more than {MAX_SHADES} of the scribbles shade; use fewer of them")]
    TooManyShades,
}

/// Why a link is not work that can be opened, or why there is none.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum LinkError {
    /// Not of the form of a link.
    #[error("this is no link to a drawing: it should hold “#1.” and letters after that; copy the whole link")]
    NoLink,
    /// Changed, cut off, or of numbers that make no sense.
    #[error("the link is damaged: a part of it is missing or was changed; copy the whole link once more")]
    Damaged,
    /// A version whose links differ.
    #[error("the link was made by a newer Scumble; update Scumble to open it")]
    Newer,
    /// More characters than are read.
    #[error(
        "the link is longer than the {} characters that can be opened; ask for the drawing as a file",
        crate::MAX_LINK
    )]
    TooLong,
    /// More than a reader would take.
    #[error("the drawing is too large for a link; save it as a file and share that")]
    TooLarge,
    /// Each takes memory of its own.
    #[error("more than {MAX_SHADES} of the scribbles shade; use fewer of them")]
    TooManyShades,
}

//! Colours line drawings from the command line, tries the program on folders of drawings, and times it.
//!
//! | noun | file |
//! |---|---|
//! | what the user asked for | `options` |
//! | `scumble color`: one picture | `color` |
//! | `scumble corpus`: a folder of drawings, for crashes and lost curves | `corpus` |
//! | `scumble bench`: how long each stage takes | `bench` |
//! | … on made drawings of any richness | `made` |
//! | `scumble compare`: how far pictures on pixels are from the mesh solver's | `compare` |
//! | `scumble eval`: how well engines colour | `eval` |
//! | … beside other people's methods on pixels | `rivals` |
//! | folders of drawings with scribbles and truth | `set` |
//! | `scumble render`: the picture of a file | `render` |
//! | `scumble link`, `open`, `convert` | `share` |
//! | `scumble palette`; palettes in and out of files | `palettes` |
//! | work in and out of files of any kind | `works` |
//! | from a file to a picture, stage by stage | `stages` |
//! | times and their percentiles | `clock` |
//! | files in and out | `files` |

mod bench;
mod card;
mod clock;
mod color;
mod compare;
mod corpus;
mod eval;
mod files;
mod made;
mod options;
mod palettes;
mod render;
mod rivals;
mod set;
mod share;
mod stages;
mod works;

use std::process::ExitCode;

use options::Command;

/// What a user sees who asks for help, or for nothing.
const HELP: &str = "\
Colours line drawings: scribble a colour on it, get a smooth-shaded picture.

scumble color DRAWING.svg --scribbles S.json -o OUT.png
    [--size 1024]           longer side of the picture, in pixels
    [--lines]               draw the lines over the colours
    [--transparent]         no white paper where nothing is coloured
    [--blend oklab|srgb]    how colours mix
    [--engine global|progressive]
                            all scribbles at once, or one after the other
    [--gap-closing 0.5]     how readily gaps between lines count as closed, 0 to 1
    [--spread]              colour also what nobody scribbled (global only)
    [--save FILE.scumble]   keep the drawing with its scribbles
    [--solver mesh|gpu|cpu-grid|jeschke]
                            on triangles, exact; on pixels, by the graphics card or without;
                            on pixels after Jeschke et al. 2009
    [--timings]             print counts and milliseconds of each stage as JSON

    S.json: {\"scribbles\":[{\"color\":\"#rrggbb\",\"width\":1.5,\"points\":[[x,y],…]},…]}
    in units of the drawing's viewBox, in drawing order. With \"kind\":\"shade\",\"strength\":0.8 a scribble shades
    where it is drawn, in the region that it begins in; with \"crosses\":true also beyond. The third number of a point,
    [x,y,0.4], is how hard a pen pressed there: the part that is left of the radius, or with \"pressure\":\"strength\"
    of the strength.

scumble render FILE -o OUT.png|OUT.svg|OUT.pdf
    the picture of a .scumble file, of an SVG that was made of one, or of a drawing
    [--size 1024] [--lines] [--transparent]
                            as for color; an SVG keeps the scribbles. Without --size an SVG or a PDF is as large as the
                            SVG that the drawing came from
    [--samples DIR]         where the samples are, for a file that only names one

scumble convert A B
    turns a .svg, .scumble or .json file, or diffusion curves (.xml), into a .scumble or .json file, or the colours of its
    picture into diffusion curves (.xml), or its palette, or another (.gpl, .ase, .hex), into a palette of any kind
    [--samples DIR]         where the samples are, for a file that only names one

scumble palette FILE --from PALETTE -o OUT.scumble
    gives a drawing the colours of a palette: GIMP's (.gpl), Adobe Swatch Exchange (.ase) or a list of #rrggbb (.hex)

scumble link FILE
    prints a link to a .scumble file, or to a drawing, as its last line
    [--base URL]            what comes before the #
    [--stats]               print a table of what takes how much before it

scumble open LINK -o FILE.scumble
    turns a link into a file
    [--samples DIR]         where the samples are, for a link that only names one

scumble corpus DIR [--take N]
    tries all drawings of a folder, or N of them evenly spaced;
    exit code 1 where one panics, fails, or loses a curve

scumble bench SETDIR
    times each stage on a quality set (SETDIR/ID/drawing.svg, SETDIR/ID/dense.json), and labelling by each engine

scumble compare SETDIR [--every 1] [--half] [--referee] [--gpu]
    how far pictures by the grid solver and by Jeschke's, and those on a mesh of half the width, are from those of the mesh
    solver, on every so many-th drawing of a set, with all colours or with those of half the sides; and how far both solvers
    are from the picture on a mesh that is graded towards tips and junctions. With --gpu the grid solver is the graphics card's

scumble bench --made
    times maps, labelling and pictures on made drawings of about 1,000 to 100,000 pieces

scumble bench --memory
    how much memory pictures of made drawings of 1,000 to 300,000 pieces take

scumble bench --drag
    times the frames while the end of a curve is moved in a made drawing of 5,000 pieces, on the graphics card

scumble bench --passes
    what a picture by the grid solver costs on the graphics card: passes, bytes moved, textures; and how long it takes

scumble eval SETDIR
    tells how much of a quality set (the above, with sparse.json and truth.png) has the expected colours
    [--kind dense|sparse]   which scribbles
    [--engine global|progressive|sight|flood|lazybrush|lazybrush-soft|nearest]
                            who colours; from flood on, other people's methods on pixels
    [--gap-closing 0.5]     how readily gaps between lines count as closed, 0 to 1 (global and progressive only)
    [--spread]              colour also what nobody scribbled (global and flood only)
    [--single]              each sparse scribble alone, without spreading
    [--sheet SHEET.png]     write a contact sheet, worst first: scribbles, truth, result
    [--pictures DIR]        write the results as DIR/ID.png, one after the other

scumble --version

Exit code 2: bad input; nothing was written (with --pictures: up to there).
";

fn main() -> ExitCode {
    // Whoever reads only the first lines ends the program quietly.
    sigpipe::reset();
    match run() {
        Ok(code) => code,
        Err(error) => {
            eprintln!("scumble: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn run() -> anyhow::Result<ExitCode> {
    match options::parse(std::env::args_os().skip(1))? {
        Command::Help => print!("{HELP}"),
        Command::Version => println!("scumble {}", env!("CARGO_PKG_VERSION")),
        Command::Color(options) => color::run(&options)?,
        Command::Corpus { folder, take } => return corpus::run(&folder, take),
        Command::Bench { set } => bench::run(&set)?,
        Command::BenchMade => bench::run_made()?,
        Command::BenchMemory => bench::run_memory()?,
        Command::BenchDrag => bench::run_drag()?,
        Command::BenchPasses => bench::run_passes()?,
        Command::Compare { set, every, options } => compare::run(&set, every, options)?,
        Command::Eval(options) => eval::run(&options)?,
        Command::Render(options) => render::run(&options)?,
        Command::Convert(options) => share::convert(&options)?,
        Command::Link(options) => share::link(&options)?,
        Command::Open(options) => share::open(&options)?,
        Command::Palette(options) => palettes::run(&options)?,
    }
    Ok(ExitCode::SUCCESS)
}

//! What the user asked for.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow, bail, ensure};
use pico_args::Arguments;
use scumble_core::{Blend, EngineKind, Settings};

use crate::color::MOST_PX;
use crate::compare::CompareOptions;
use crate::eval::{EvalOptions, Method};
use crate::set::Kind;
use crate::works;

/// Picture sizes that are made, in pixels of the longer side.
const SIZES_PX: std::ops::RangeInclusive<u32> = 1..=16384;

/// A command with its options.
#[derive(Debug)]
pub(crate) enum Command {
    Help,
    Version,
    Color(ColorOptions),
    Corpus { folder: PathBuf, take: Option<usize> },
    Bench { set: PathBuf },
    BenchMade,
    BenchMemory,
    BenchDrag,
    BenchPasses,
    Compare { set: PathBuf, every: usize, options: CompareOptions },
    Eval(EvalOptions),
    Render(RenderOptions),
    Convert(ConvertOptions),
    Link(LinkOptions),
    Open(OpenOptions),
    Palette(PaletteOptions),
}

/// What `scumble color` is to make.
#[derive(Debug)]
pub(crate) struct ColorOptions {
    pub(crate) drawing: PathBuf,
    pub(crate) scribbles: PathBuf,
    pub(crate) output: PathBuf,
    pub(crate) look: Look,
    pub(crate) settings: Settings,
    /// Where to keep the drawing with its scribbles.
    pub(crate) save: Option<PathBuf>,
    pub(crate) timings: bool,
    pub(crate) solver: Solver,
}

/// How a picture is painted.
#[derive(Debug)]
pub(crate) struct Look {
    /// Longer side, where it is asked for.
    pub(crate) asked_px: Option<u32>,
    pub(crate) lines: bool,
    pub(crate) transparent: bool,
}

impl Look {
    /// The longer side of pixels.
    pub(crate) fn size_px(&self) -> u32 {
        self.asked_px.unwrap_or(1024)
    }
}

/// What spreads the colours of sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Solver {
    /// Triangles, exact at every size.
    #[default]
    Mesh,
    /// Pixels.
    GpuGrid,
    /// The same without a GPU.
    CpuGrid,
    /// Pixels, after Jeschke et al. 2009.
    Jeschke,
}

/// What `scumble render` is to make.
#[derive(Debug)]
pub(crate) struct RenderOptions {
    pub(crate) file: PathBuf,
    pub(crate) output: PathBuf,
    pub(crate) samples: Option<PathBuf>,
    pub(crate) look: Look,
    pub(crate) format: Format,
}

/// What a picture is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Png,
    Svg,
    Pdf,
}

/// What `scumble convert` is to write.
#[derive(Debug)]
pub(crate) struct ConvertOptions {
    pub(crate) from: PathBuf,
    pub(crate) to: PathBuf,
    pub(crate) samples: Option<PathBuf>,
}

/// What `scumble link` is to print.
#[derive(Debug)]
pub(crate) struct LinkOptions {
    pub(crate) file: PathBuf,
    /// What comes before the `#`.
    pub(crate) base: String,
    pub(crate) stats: bool,
}

/// What `scumble open` is to write.
#[derive(Debug)]
pub(crate) struct OpenOptions {
    pub(crate) link: String,
    pub(crate) output: PathBuf,
    pub(crate) samples: Option<PathBuf>,
}

/// What `scumble palette` is to write.
#[derive(Debug)]
pub(crate) struct PaletteOptions {
    pub(crate) file: PathBuf,
    /// The palette.
    pub(crate) from: PathBuf,
    pub(crate) output: PathBuf,
}

/// Reads a command line.
///
/// # Errors
/// When a command or an option is unknown, missing or faulty.
pub(crate) fn parse(arguments: impl Iterator<Item = OsString>) -> anyhow::Result<Command> {
    let mut arguments = Arguments::from_vec(arguments.flat_map(apart).collect());
    if arguments.contains(["-h", "--help"]) {
        return Ok(Command::Help);
    }
    if arguments.contains(["-V", "--version"]) {
        return rest(arguments, []).map(|[]| Command::Version);
    }
    match arguments.subcommand().map_err(advise)?.as_deref() {
        None => rest(arguments, []).map(|[]| Command::Help),
        Some("help") => Ok(Command::Help),
        Some("color") => color(arguments).map(Command::Color),
        Some("corpus") => {
            let take = value(&mut arguments, "--take", positive)?;
            let [folder] = rest(arguments, ["DIR"])?;
            Ok(Command::Corpus { folder: folder.into(), take })
        }
        Some("bench") if arguments.contains("--drag") => rest(arguments, []).map(|[]| Command::BenchDrag),
        Some("bench") if arguments.contains("--passes") => rest(arguments, []).map(|[]| Command::BenchPasses),
        Some("bench") if arguments.contains("--made") => rest(arguments, []).map(|[]| Command::BenchMade),
        Some("bench") if arguments.contains("--memory") => rest(arguments, []).map(|[]| Command::BenchMemory),
        Some("bench") => {
            let [set] = rest(arguments, ["SETDIR"])?;
            Ok(Command::Bench { set: set.into() })
        }
        Some("compare") => {
            let every = value(&mut arguments, "--every", positive)?;
            let options = CompareOptions {
                half: arguments.contains("--half"),
                referee: arguments.contains("--referee"),
                gpu: arguments.contains("--gpu"),
            };
            let [set] = rest(arguments, ["SETDIR"])?;
            Ok(Command::Compare { set: set.into(), every: every.unwrap_or(1), options })
        }
        Some("eval") => eval(arguments).map(Command::Eval),
        Some("render") => render(arguments).map(Command::Render),
        Some("convert") => convert(arguments).map(Command::Convert),
        Some("link") => link(arguments).map(Command::Link),
        Some("open") => open(arguments).map(Command::Open),
        Some("palette") => palette(arguments).map(Command::Palette),
        Some(other) => bail!("there is no command “{other}”; see --help"),
    }
}

/// The options that take a value.
const VALUED: [&str; 16] = [
    "-o",
    "--base",
    "--blend",
    "--engine",
    "--every",
    "--from",
    "--gap-closing",
    "--kind",
    "--pictures",
    "--samples",
    "--save",
    "--scribbles",
    "--sheet",
    "--size",
    "--solver",
    "--take",
];

/// An option and its value, which may have an equals sign between them. (`pico-args` could tell them apart itself, but then takes
/// no file names that are not in UTF-8.)
fn apart(argument: OsString) -> Vec<OsString> {
    let parts = argument.to_str().and_then(|text| text.split_once('='));
    match parts.filter(|(name, _)| VALUED.contains(name)) {
        Some((name, value)) => vec![name.into(), value.into()],
        None => vec![argument],
    }
}

/// What is given for an option, if it is given.
fn value<T>(
    arguments: &mut Arguments,
    name: &'static str,
    read: impl Fn(&str) -> Result<T, String>,
) -> anyhow::Result<Option<T>> {
    let given: Option<String> = arguments.opt_value_from_str(name).map_err(advise)?;
    let read = |text: String| read(&text).map_err(|advice| anyhow!("{name} {text}: {advice}; see --help"));
    given.map(read).transpose()
}

fn path(value: &std::ffi::OsStr) -> Result<PathBuf, std::convert::Infallible> {
    Ok(value.into())
}

fn color(mut arguments: Arguments) -> anyhow::Result<ColorOptions> {
    let scribbles = arguments.opt_value_from_os_str("--scribbles", path).map_err(advise)?;
    let output = picture(&mut arguments)?;
    let is_png = works::extension(&output) == "png";
    ensure!(is_png, "{} cannot be written; name a file that ends in .png", output.display());
    let save = arguments.opt_value_from_os_str("--save", path).map_err(advise)?;
    save.as_deref().map(works::check_writable).transpose()?;
    let settings = settings(&mut arguments)?;
    let look = look(&mut arguments)?;
    let timings = arguments.contains("--timings");
    let solver = value(&mut arguments, "--solver", solver)?.unwrap_or_default();
    ensure!(!timings || solver == Solver::Mesh, "--timings are those of the mesh solver; leave out --solver");
    ensure!(
        solver != Solver::Jeschke || look.size_px() <= MOST_PX,
        "--solver jeschke goes with a --size of up to {MOST_PX} pixels; give a smaller one, or another solver"
    );
    let [drawing] = rest(arguments, ["DRAWING.svg"])?;
    Ok(ColorOptions {
        drawing: drawing.into(),
        scribbles: scribbles.context("--scribbles is missing; name a file of scribbles")?,
        output,
        look,
        settings,
        save,
        timings,
        solver,
    })
}

fn render(mut arguments: Arguments) -> anyhow::Result<RenderOptions> {
    let output = picture(&mut arguments)?;
    let samples = arguments.opt_value_from_os_str("--samples", path).map_err(advise)?;
    let format = format(&output)?;
    let look = look(&mut arguments)?;
    let [file] = rest(arguments, ["FILE"])?;
    Ok(RenderOptions { file: file.into(), output, samples, look, format })
}

/// The kind of picture that a file is named for.
fn format(output: &Path) -> anyhow::Result<Format> {
    match &*works::extension(output) {
        "svg" => Ok(Format::Svg),
        "pdf" => Ok(Format::Pdf),
        "png" => Ok(Format::Png),
        _ => bail!("{} cannot be written; name a file that ends in .png, .svg or .pdf", output.display()),
    }
}

fn convert(mut arguments: Arguments) -> anyhow::Result<ConvertOptions> {
    let samples = arguments.opt_value_from_os_str("--samples", path).map_err(advise)?;
    let [from, to] = rest(arguments, ["A", "B"])?;
    let to = PathBuf::from(to);
    works::check_convertible(&to)?;
    Ok(ConvertOptions { from: from.into(), to, samples })
}

fn link(mut arguments: Arguments) -> anyhow::Result<LinkOptions> {
    let base: Option<String> = arguments.opt_value_from_str("--base").map_err(advise)?;
    let base = base.unwrap_or_default();
    ensure!(!base.contains('#'), "--base has a “#”; give the address up to it");
    let is_address = !base.starts_with('-') && !base.contains(char::is_whitespace);
    ensure!(
        is_address,
        "--base {base} is no address; give what comes before the #, for example https://example.org/"
    );
    let stats = arguments.contains("--stats");
    let [file] = rest(arguments, ["FILE"])?;
    Ok(LinkOptions { file: file.into(), base, stats })
}

fn palette(mut arguments: Arguments) -> anyhow::Result<PaletteOptions> {
    let output = work_file(&mut arguments)?;
    let from = arguments.opt_value_from_os_str("--from", path).map_err(advise)?;
    let from = from.context("--from is missing; name a palette, for example --from colours.gpl")?;
    let [file] = rest(arguments, ["FILE"])?;
    Ok(PaletteOptions { file: file.into(), from, output })
}

fn work_file(arguments: &mut Arguments) -> anyhow::Result<PathBuf> {
    let output: Option<PathBuf> = arguments.opt_value_from_os_str("-o", path).map_err(advise)?;
    let output = output.context("-o is missing; name the file to write, for example -o drawing.scumble")?;
    works::check_writable(&output)?;
    Ok(output)
}

fn open(mut arguments: Arguments) -> anyhow::Result<OpenOptions> {
    let output = work_file(&mut arguments)?;
    let samples = arguments.opt_value_from_os_str("--samples", path).map_err(advise)?;
    let [link] = rest(arguments, ["LINK"])?;
    Ok(OpenOptions { link: link.to_string_lossy().into_owned(), output, samples })
}

fn picture(arguments: &mut Arguments) -> anyhow::Result<PathBuf> {
    let output = arguments.opt_value_from_os_str("-o", path).map_err(advise)?;
    output.context("-o is missing; name the picture to write, for example -o picture.png")
}

fn look(arguments: &mut Arguments) -> anyhow::Result<Look> {
    let asked_px = value(arguments, "--size", size)?;
    let lines = arguments.contains("--lines");
    Ok(Look { asked_px, lines, transparent: arguments.contains("--transparent") })
}

fn eval(mut arguments: Arguments) -> anyhow::Result<EvalOptions> {
    let kind = value(&mut arguments, "--kind", kind)?;
    let method = value(&mut arguments, "--engine", Method::parse)?;
    let settings = reach(&mut arguments)?;
    let single = arguments.contains("--single");
    let sheet = arguments.opt_value_from_os_str("--sheet", path).map_err(advise)?;
    let pictures = arguments.opt_value_from_os_str("--pictures", path).map_err(advise)?;
    let [set] = rest(arguments, ["SETDIR"])?;
    let is_together = sheet.is_none() && pictures.is_none();
    ensure!(!single || is_together, "--single makes no pictures; leave out --sheet and --pictures");
    let is_plain = kind != Some(Kind::Dense) && !settings.spread;
    ensure!(
        !single || is_plain,
        "--single takes sparse scribbles and does not spread; leave out --kind and --spread"
    );
    Ok(EvalOptions {
        set: set.into(),
        kind: kind.unwrap_or_default(),
        method: method.unwrap_or_default(),
        settings,
        single,
        sheet,
        pictures,
    })
}

/// How the drawing is to be coloured, where the options say otherwise than the defaults do.
fn settings(arguments: &mut Arguments) -> anyhow::Result<Settings> {
    let blend = value(arguments, "--blend", blend)?;
    let engine = value(arguments, "--engine", engine)?;
    let reach = reach(arguments)?;
    let is_global = engine != Some(EngineKind::Progressive);
    ensure!(is_global || !reach.spread, "only --engine global spreads; leave out --spread or --engine");
    Ok(Settings { blend: blend.unwrap_or(reach.blend), engine: engine.unwrap_or(reach.engine), ..reach })
}

/// How far colours are to go; all else as the defaults say.
fn reach(arguments: &mut Arguments) -> anyhow::Result<Settings> {
    let default = Settings::default();
    let gap_closing = value(arguments, "--gap-closing", unit)?;
    let gap_closing = gap_closing.unwrap_or(default.gap_closing);
    Ok(Settings { gap_closing, spread: arguments.contains("--spread"), ..default })
}

/// What is left once the options are taken: exactly the arguments that have these names.
fn rest<const N: usize>(arguments: Arguments, names: [&str; N]) -> anyhow::Result<[OsString; N]> {
    let rest = arguments.finish();
    let texts = rest.iter().map(|argument| argument.to_string_lossy());
    if let Some(option) = texts.into_iter().find(|text| text.starts_with('-')) {
        bail!("{}; see --help", fault_of(&option));
    }
    let count = rest.len();
    rest.try_into().map_err(|_| match names.get(count) {
        Some(name) => anyhow!("{name} is missing; see --help"),
        None => anyhow!("there are {count} arguments where {N} are expected; see --help"),
    })
}

/// What is wrong with something like an option that is left.
fn fault_of(option: &str) -> String {
    match option.split_once('=') {
        _ if option == "-" => "“-” names no file; give its name, for example /dev/stdin".into(),
        Some((name, _)) => format!("the option {name} is unknown here, or takes no value"),
        None => format!("the option {option} is unknown here, or given twice"),
    }
}

fn size(text: &str) -> Result<u32, String> {
    let size_px = text.parse().ok().filter(|size_px| SIZES_PX.contains(size_px));
    size_px.ok_or_else(|| format!("give a number of pixels from {} to {}", SIZES_PX.start(), SIZES_PX.end()))
}

fn positive(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|n| *n > 0).ok_or_else(|| "give a whole number above zero".into())
}

fn unit(text: &str) -> Result<f64, String> {
    let part = text.parse().ok().filter(|part| (0.0..=1.0).contains(part));
    part.ok_or_else(|| "give a number from 0 to 1".into())
}

fn kind(text: &str) -> Result<Kind, String> {
    let kind = [Kind::Sparse, Kind::Dense].into_iter().find(|kind| kind.name() == text);
    kind.ok_or_else(|| "give sparse or dense".into())
}

fn blend(text: &str) -> Result<Blend, String> {
    match text {
        "oklab" => Ok(Blend::Oklab),
        "srgb" => Ok(Blend::Srgb),
        _ => Err("give oklab or srgb".into()),
    }
}

fn solver(text: &str) -> Result<Solver, String> {
    match text {
        "mesh" => Ok(Solver::Mesh),
        "gpu" => Ok(Solver::GpuGrid),
        "cpu-grid" => Ok(Solver::CpuGrid),
        "jeschke" => Ok(Solver::Jeschke),
        _ => Err("give mesh, gpu, cpu-grid or jeschke".into()),
    }
}

fn engine(text: &str) -> Result<EngineKind, String> {
    match text {
        "global" => Ok(EngineKind::Global),
        "progressive" => Ok(EngineKind::Progressive),
        _ => Err("give global or progressive".into()),
    }
}

fn advise(error: pico_args::Error) -> anyhow::Error {
    anyhow!("{error}; see --help")
}

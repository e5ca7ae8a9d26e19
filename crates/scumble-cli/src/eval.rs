//! `scumble eval`: how well engines, and other people's methods beside them, colour the drawings of a quality set.

mod latency;
mod method;
mod score;
mod sheet;
mod single;
mod subject;
mod truth;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Context;
use scumble_core::Settings;
use scumble_io::write_png;
use scumble_solve::Pixmap;

pub(crate) use method::Method;

use crate::files;
use crate::set::{self, Kind};
use latency::Latency;
use score::Score;
use sheet::Cell;
use single::Singles;
use subject::Subject;

/// How many of the worst drawings are told.
const WORST: usize = 8;

/// What `scumble eval` is to do.
#[derive(Debug)]
pub(crate) struct EvalOptions {
    pub(crate) set: PathBuf,
    pub(crate) kind: Kind,
    pub(crate) method: Method,
    pub(crate) settings: Settings,
    /// Score each sparse scribble alone instead.
    pub(crate) single: bool,
    /// A picture of all drawings to write.
    pub(crate) sheet: Option<PathBuf>,
    /// A folder for the coloured pictures.
    pub(crate) pictures: Option<PathBuf>,
}

/// Colours and scores the drawings of a set and prints the figures.
///
/// # Errors
/// When the set cannot be read, a drawing fails, or a picture cannot be written.
pub(crate) fn run(options: &EvalOptions) -> anyhow::Result<()> {
    if options.single { run_single(options) } else { run_together(options) }
}

/// All scribbles of a drawing together.
fn run_together(options: &EvalOptions) -> anyhow::Result<()> {
    let mut report = Report::default();
    for_each_drawing(options, options.kind, |id, subject| report.add(id, subject, options))?;
    if let Some(path) = &options.sheet {
        write_picture(path, &sheet::sheet(report.cells))?;
    }
    print_scores(options, report.scores);
    report.latency.print();
    Ok(())
}

/// Each scribble alone, by the chosen method and by two plain ones.
fn run_single(options: &EvalOptions) -> anyhow::Result<()> {
    let beside = [method::FLOOD, method::SIGHT].into_iter().filter(|plain| plain.name != options.method.name);
    let mut reports: Vec<Singles> = [options.method].into_iter().chain(beside).map(Singles::new).collect();
    for_each_drawing(options, Kind::Sparse, |_, subject| {
        reports.iter_mut().try_for_each(|singles| singles.add(subject, options.settings))
    })?;
    reports.iter().for_each(Singles::print);
    Ok(())
}

fn for_each_drawing(
    options: &EvalOptions,
    kind: Kind,
    mut run: impl FnMut(&str, &mut Subject) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    for entry in set::entries(&options.set)? {
        let done = Subject::read(&entry, kind).and_then(|mut subject| run(&entry.id, &mut subject));
        done.with_context(|| format!("drawing {}", entry.id))?;
    }
    Ok(())
}

/// What is found out about the drawings.
#[derive(Default)]
struct Report {
    scores: Vec<(String, Score)>,
    cells: Vec<Cell>,
    latency: Latency,
}

impl Report {
    fn add(&mut self, id: &str, subject: &mut Subject, options: &EvalOptions) -> anyhow::Result<()> {
        self.latency.take(subject, options.method, options.settings);
        let scribbles = subject.scribbles.clone();
        let picture = subject.paint(options.method, options.settings, &scribbles)?;
        if let Some(folder) = &options.pictures {
            fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
            write_picture(&folder.join(format!("{id}.png")), &picture)?;
        }
        let used: BTreeSet<u8> = scribbles.iter().map(truth::palette_index).collect::<Result<_, _>>()?;
        let used: Vec<u8> = used.into_iter().collect();
        let score = Score::new(&subject.truth, &score::classes(&picture, &used));
        if options.sheet.is_some() {
            self.cells.push(Cell::new(id, subject, &picture, &score));
        }
        self.scores.push((id.into(), score));
        Ok(())
    }
}

fn write_picture(path: &Path, picture: &Pixmap) -> anyhow::Result<()> {
    files::write(path, &write_png(picture.width_px, picture.height_px, &picture.rgba)?)
}

/// Prints the worst drawings and the means.
fn print_scores(options: &EvalOptions, mut scores: Vec<(String, Score)>) {
    scores.sort_by(|(_, a), (_, b)| a.side.total_cmp(&b.side));
    for (id, Score { side, area, cover }) in scores.iter().take(WORST) {
        println!("  worst {id:<24} side {side:.3} area {area:.3} cover {cover:.3}");
    }
    let all: Vec<Score> = scores.into_iter().map(|(_, score)| score).collect();
    let Score { side, area, cover } = Score::mean(&all);
    let (method, kind, count) = (options.method.name, options.kind.name(), all.len());
    println!("{method}, {kind}: {count} drawings: side {side:.4} area {area:.4} cover {cover:.4}");
}

//! `scumble eval`: how well engines colour the drawings of a quality set.

mod method;
mod score;
mod truth;

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, ensure};
use scumble_core::Scribble;
use scumble_io::write_png;
use scumble_solve::Pixmap;

pub(crate) use method::{Manner, Method};

use crate::clock::{print_head, print_row};
use crate::files;
use crate::set::{self, Entry, Kind};
use crate::stages::{self, Opened};
use method::Latency;
use score::Score;
use truth::Truth;

/// How many of the worst drawings are told.
const WORST: usize = 8;

/// What `scumble eval` is to do.
#[derive(Debug)]
pub(crate) struct EvalOptions {
    pub(crate) set: PathBuf,
    pub(crate) kind: Kind,
    pub(crate) method: Method,
    pub(crate) manner: Manner,
    /// A folder for the coloured pictures.
    pub(crate) pictures: Option<PathBuf>,
}

/// One drawing with all that belongs to it.
struct Subject {
    opened: Opened,
    scribbles: Vec<Scribble>,
    truth: Truth,
}

/// Colours and scores the drawings of a set and prints the figures.
///
/// # Errors
/// When the set cannot be read, a drawing fails, or a picture cannot be written.
pub(crate) fn run(options: &EvalOptions) -> anyhow::Result<()> {
    let mut latency = Latency::default();
    let mut scores = Vec::new();
    for entry in set::entries(&options.set)? {
        let score = evaluate(&entry, options, &mut latency);
        let score = score.with_context(|| format!("drawing {}", entry.id))?;
        scores.push((entry.id, score));
    }
    print_scores(options, scores);
    print_latency(&latency);
    Ok(())
}

fn evaluate(entry: &Entry, options: &EvalOptions, latency: &mut Latency) -> anyhow::Result<Score> {
    let mut subject = Subject::read(entry, options.kind)?;
    latency.take(options.method, options.manner, subject.opened.picture.map(), &subject.scribbles);
    let picture = subject.paint(options)?;
    if let Some(folder) = &options.pictures {
        let file = write_png(picture.width_px, picture.height_px, &picture.rgba)?;
        fs::create_dir_all(folder).with_context(|| format!("{} cannot be made", folder.display()))?;
        files::write(&folder.join(format!("{}.png", entry.id)), &file)?;
    }
    let used: BTreeSet<u8> = subject.scribbles.iter().map(truth::palette_index).collect::<Result<_, _>>()?;
    let used: Vec<u8> = used.into_iter().collect();
    Ok(Score::new(&subject.truth, &score::classes(&picture, &used)))
}

impl Subject {
    fn read(entry: &Entry, kind: Kind) -> anyhow::Result<Self> {
        let opened = stages::open(&entry.svg()?)?;
        let scribbles = entry.scribbles(kind, &opened.import.drawing)?;
        let path = entry.path("truth.png");
        let truth = Truth::read(&files::read(&path)?).with_context(|| format!("{}", path.display()))?;
        let view = stages::page_view(&opened.import.drawing, truth.longer_side_px());
        let fits = (view.width_px, view.height_px) == (truth.width_px, truth.height_px);
        ensure!(fits, "{} has not the shape of the drawing", path.display());
        Ok(Self { opened, scribbles, truth })
    }

    fn paint(&mut self, options: &EvalOptions) -> anyhow::Result<Pixmap> {
        let size_px = self.truth.longer_side_px();
        method::paint(options.method, options.manner, &mut self.opened, &self.scribbles, size_px)
    }
}

/// Prints the worst drawings and the means.
fn print_scores(options: &EvalOptions, mut scores: Vec<(String, Score)>) {
    scores.sort_by(|(_, a), (_, b)| a.side.total_cmp(&b.side));
    for (id, Score { side, area, cover }) in scores.iter().take(WORST) {
        println!("  worst {id:<24} side {side:.3} area {area:.3} cover {cover:.3}");
    }
    let all: Vec<Score> = scores.into_iter().map(|(_, score)| score).collect();
    let Score { side, area, cover } = Score::mean(&all);
    let (method, kind, count) = (options.method.name(), options.kind.name(), all.len());
    println!("{method}, {kind}: {count} drawings: side {side:.4} area {area:.4} cover {cover:.4}");
}

fn print_latency(latency: &Latency) {
    println!();
    print_head("labels, one thread");
    print_row("all scribbles at once", &latency.at_once);
    print_row("one more scribble, from the second on", &latency.one_more);
    print_row("the last scribble, all others being there", &latency.last);
}

//! How times grow with the pieces of a drawing: labels by each engine, and pictures.

use scumble_core::{Drawing, PlanarMap, Sampling, Settings};

use super::labels::{self, CANDIDATES, LabelTimes, ROWS};
use super::pictures::{self, PictureTimes};
use super::times_of;
use crate::clock::timed;
use crate::made;

/// Cells in a row, for about 1,000, 5,000, 10,000, 30,000 and 100,000 pieces.
const CELLS: [u32; 5] = [1, 5, 9, 23, 50];

/// The drawing that is told in full: of 5,000 pieces.
const IN_FULL: usize = 1;

/// All times on one made drawing.
struct Sample {
    piece_count: usize,
    map_ms: f64,
    gaps_ms: f64,
    labels: [LabelTimes; CANDIDATES.len()],
    pictures: PictureTimes,
}

/// Times maps, labels and pictures on made drawings and prints how they grow.
///
/// # Errors
/// When a made drawing has no map.
pub(crate) fn run() -> anyhow::Result<()> {
    let scribbles = made::scribbles();
    let samples = CELLS
        .into_iter()
        .map(|cells| {
            let drawing = made::drawing(cells);
            let (map, map_ms, gaps_ms) = map(&drawing)?;
            let labels = CANDIDATES.map(|candidate| times_of(candidate, &map, &scribbles));
            let pictures = PictureTimes::of(&drawing, &scribbles)?;
            Ok(Sample { piece_count: map.pieces().len(), map_ms, gaps_ms, labels, pictures })
        })
        .collect::<anyhow::Result<Vec<_>>>()?;
    let in_full = &samples[IN_FULL];
    labels::print(&format!("{} pieces, {} scribbles", in_full.piece_count, scribbles.len()), &in_full.labels);
    print(&samples);
    Ok(())
}

/// The map of a drawing, and the milliseconds of map and gaps.
pub(crate) fn map(drawing: &Drawing) -> anyhow::Result<(PlanarMap, f64, f64)> {
    let (map, map_ms) = timed(|| PlanarMap::build(drawing, &Sampling::default()));
    let map = map?;
    let (map, gaps_ms) = timed(|| map.with_gaps_closed(Settings::default().gap_closing));
    Ok((map, map_ms, gaps_ms))
}

fn print(samples: &[Sample]) {
    println!();
    print!("{:<40}", "median ms by pieces");
    samples.iter().for_each(|sample| print!(" {:>9}", sample.piece_count));
    println!(" {:>9}", "exponent");
    print_row("map", samples, |sample| sample.map_ms);
    print_row("gaps", samples, |sample| sample.gaps_ms);
    println!("pictures");
    for (row, name) in pictures::ROWS.iter().enumerate() {
        print_row(&format!("  {name}"), samples, |sample| sample.pictures.rows[row].median());
    }
    for (i, candidate) in CANDIDATES.iter().enumerate() {
        println!("{}", candidate.name);
        for (row, name) in ROWS.iter().enumerate() {
            print_row(&format!("  {name}"), samples, |sample| sample.labels[i].rows[row].median());
        }
    }
}

fn print_row(name: &str, samples: &[Sample], ms: impl Fn(&Sample) -> f64) {
    print!("{name:<40}");
    samples.iter().for_each(|sample| print!(" {:9.3}", ms(sample)));
    println!(" {:9.2}", exponent(samples, ms));
}

/// The power of the number of pieces with which a time grows, from the first drawing to the last; 1 is linear.
fn exponent(samples: &[Sample], ms: impl Fn(&Sample) -> f64) -> f64 {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return 0.0 };
    let pieces = last.piece_count as f64 / first.piece_count as f64;
    (ms(last) / ms(first)).ln() / pieces.ln()
}

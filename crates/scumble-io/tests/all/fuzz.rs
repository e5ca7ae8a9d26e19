//! Readers of foreign bytes, given damaged ones: no panic, no hang, and what is read can be kept and read again.
//!
//! `FUZZ_RUNS=10000000 cargo test --release -p scumble-io fuzz::` goes on for longer. The seeds are the fixtures and
//! the sample drawings; a run is told by its number, so that a finding can be had again with `FUZZ_FROM`.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use crate::dice::Dice;
use kurbo::Rect;
use scumble_core::{Document, Drawing, Labels, PlanarMap, Sampling, Srgb8, Swatch, Tracing, Work, exact};
use scumble_io::{
    ImportError, PaletteKind, check_image, import_drawing, import_svg, read_file, read_link, read_palette,
    read_scribbles, write_curve_set, write_file, write_link, write_palette,
};

/// Runs of one target, and the number of the first one.
fn runs(default: u64) -> std::ops::Range<u64> {
    let number = |name| std::env::var(name).ok().and_then(|text: String| text.parse().ok());
    let from = number("FUZZ_FROM").unwrap_or(0);
    from..from + number("FUZZ_RUNS").unwrap_or(default)
}

fn seeds(folder: &str, ending: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.to_string_lossy().ends_with(ending));
    paths.sort();
    paths.iter().map(|path| fs::read(path).unwrap()).collect()
}

fn files_of_all_versions() -> Vec<Vec<u8>> {
    ["tests/fixtures/v1.0", "tests/fixtures/v1.1", "tests/fixtures/v1.2", "tests/fixtures/v1.3"]
        .iter()
        .flat_map(|folder| seeds(folder, ".scumble"))
        .collect()
}

fn page() -> Document {
    Document::new(Drawing::new(Rect::new(0.0, 0.0, 64.0, 64.0)))
}

/// What parsers may stumble over.
const WORDS: [&[u8]; 14] = [
    b"[",
    b"{",
    b"\"",
    b"\\u",
    b"-",
    b"1e308",
    b"0.",
    b"<",
    b"</g>",
    b"<use href=\"#a\"/>",
    b"&#0;",
    b"NaN",
    b"\xff",
    b"Z",
];

/// A seed with a few bytes changed, cut, doubled, or from another seed.
fn damaged(seeds: &[Vec<u8>], dice: &mut Dice) -> Vec<u8> {
    let mut bytes = seeds[dice.below(seeds.len())].clone();
    for _ in 0..1 + dice.below(6) {
        let at = dice.below(bytes.len());
        let most = 1 << dice.below(10);
        let end = bytes.len().min(at + dice.below(most));
        match dice.below(7) {
            0 => bytes[at] ^= 1 << dice.below(8),
            1 => bytes[at] = dice.below(256) as u8,
            2 => drop(bytes.drain(at..end)),
            3 => drop(bytes.splice(at..at, WORDS[dice.below(WORDS.len())].iter().copied())),
            4 => bytes.extend_from_within(at..end),
            5 => drop(
                bytes.splice(at..end, seeds[dice.below(seeds.len())].iter().copied().take(at).skip(at / 2)),
            ),
            _ => bytes[at..end].reverse(),
        }
        if bytes.is_empty() {
            bytes.push(0);
        }
    }
    bytes
}

/// What was read can be kept, and is the same when it is read again.
fn check(work: &Work, run: u64) {
    if let Ok(file) = write_file(work) {
        let again = read_file(&file).unwrap_or_else(|error| panic!("run {run}: {error}"));
        assert!(write_file(&again).as_deref() == Ok(&file), "run {run}");
    }
    if let Ok(link) = write_link(work) {
        let again = read_link(&link.fragment).unwrap_or_else(|error| panic!("run {run}: {error}"));
        assert!(write_link(&again).is_ok_and(|again| again.fragment == link.fragment), "run {run}");
    }
}

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// The bytes of a link that stand for the work, without their checksum.
fn unpacked(link: &str) -> Vec<u8> {
    let digits =
        link["#1.".len()..].bytes().map(|digit| DIGITS.iter().position(|known| *known == digit).unwrap());
    let bits: Vec<_> = digits.flat_map(|digit| (0..6).rev().map(move |bit| digit >> bit & 1)).collect();
    let bytes: Vec<_> =
        bits.chunks_exact(8).map(|bits| bits.iter().fold(0, |byte, bit| byte << 1 | *bit as u8)).collect();
    bytes[..bytes.len() - 4].to_vec()
}

/// A link with a checksum that is right, as somebody hostile would make it.
fn packed(bytes: &[u8]) -> String {
    let mut rest = !0_u32;
    for byte in bytes {
        rest ^= u32::from(*byte);
        (0..8).for_each(|_| rest = (rest >> 1) ^ (0xedb8_8320 * (rest & 1)));
    }
    let all = [bytes, &(!rest).to_be_bytes()].concat();
    let mut bits: Vec<_> =
        all.iter().flat_map(|byte| (0..8).rev().map(move |bit| usize::from(byte >> bit & 1))).collect();
    bits.resize(bits.len().next_multiple_of(6), 0);
    let digit = |bits: &[usize]| char::from(DIGITS[bits.iter().fold(0, |digit, bit| digit << 1 | bit)]);
    ["#1.", &bits.chunks(6).map(digit).collect::<String>()].concat()
}

fn links() -> Vec<String> {
    let versions = [
        include_str!("../fixtures/v1.0/links.txt"),
        include_str!("../fixtures/v1.1/links.txt"),
        include_str!("../fixtures/v1.2/links.txt"),
        include_str!("../fixtures/v1.3/links.txt"),
    ];
    let links = versions.into_iter().flat_map(str::lines);
    links.map(|line| line.split_once(' ').unwrap().1.to_owned()).collect()
}

#[test]
fn hostile_links() {
    let seeds: Vec<_> = links().iter().map(|link| unpacked(link)).collect();
    assert_eq!(packed(&seeds[0]), links()[0]);
    let mut read = 0;
    for run in runs(2000) {
        let mut dice = Dice(run + 1);
        if let Ok(work) = read_link(&packed(&damaged(&seeds, &mut dice))) {
            read += 1;
            check(&work, run);
        }
    }
    assert!(read > 0, "the checksum was right, and some of them are work");
}

#[test]
fn damaged_links() {
    let seeds: Vec<_> = links().into_iter().map(String::into_bytes).collect();
    for run in runs(20_000) {
        let link = damaged(&seeds, &mut Dice(run + 1));
        let link = String::from_utf8_lossy(&link);
        let is_whole = links().iter().any(|whole| {
            link.trim_end_matches(|c: char| !DIGITS.contains(&(c as u8)) || !c.is_ascii()).ends_with(&**whole)
        });
        assert!(read_link(&link).is_err() || is_whole, "run {run}: {link}");
    }
}

#[test]
fn files() {
    let seeds = files_of_all_versions();
    let mut read = 0;
    for run in runs(2000) {
        if let Ok(work) = read_file(&damaged(&seeds, &mut Dice(run + 1))) {
            read += 1;
            check(&work, run);
        }
    }
    assert!(read > 0, "some damage makes other work");
}

#[test]
fn images() {
    let seeds = [seeds("tests/foreign", ".png"), seeds("tests/foreign", ".jpg")].concat();
    let mut whole = 0;
    for run in runs(20_000) {
        let image = damaged(&seeds, &mut Dice(run + 1));
        let is_whole = check_image(&image).is_ok();
        whole += u64::from(is_whole);
        let document = Document { tracing: Some(Tracing::faded(1)), ..page() };
        let file = write_file(&Work { image, ..Work::new(document) }).unwrap();
        assert_eq!(read_file(&file).is_ok(), is_whole, "run {run}");
    }
    assert!(whole > 0, "some damage leaves the parts as they are");
}

#[test]
fn exact_bytes() {
    let works = files_of_all_versions();
    let exact = works.iter().map(|file| exact::write(&read_file(file).unwrap()));
    let seeds: Vec<_> = exact.chain(seeds("tests/fixtures/v1.0", ".work")).collect();
    let mut read = 0;
    for run in runs(5000) {
        if let Some(work) = exact::read(&damaged(&seeds, &mut Dice(run + 1))) {
            read += 1;
            let bytes = exact::write(&work);
            let again = exact::read(&bytes).unwrap_or_else(|| panic!("run {run}"));
            assert!(exact::write(&again) == bytes, "run {run}");
        }
    }
    assert!(read > 0, "some damage makes other work");
}

#[test]
fn svg_drawings() {
    let seeds = [seeds("../../web/samples", ".svg"), seeds("../../tests/e2e/drawings", ".svg")].concat();
    let mut read = 0;
    for run in runs(500) {
        if let Ok(import) = import_svg(&damaged(&seeds, &mut Dice(run + 1))) {
            read += 1;
            check(&Work::new(Document::new(import.drawing)), run);
        }
    }
    assert!(read > 0, "some damage makes other drawings");
}

#[test]
fn diffusion_curves() {
    let seeds = seeds("tests/foreign", ".xml");
    let mut read = 0;
    for run in runs(500) {
        let Ok((work, _)) = import_drawing(&damaged(&seeds, &mut Dice(run + 1))) else { continue };
        let document = &work.document;
        if let Ok(map) = PlanarMap::build(&document.drawing, &Sampling::default()) {
            let (text, _) = write_curve_set(document, &map, &Labels::none(&map));
            let again = import_drawing(text.as_bytes()).map(|(work, _)| work.document.settings);
            assert!(
                matches!(again, Err(ImportError::NoDiffusionCurves)) || again == Ok(document.settings),
                "run {run}"
            );
        }
        read += 1;
        check(&work, run);
    }
    assert!(read > 0, "some damage makes other curves");
}

#[test]
fn palettes() {
    let swatch = |i| Swatch { color: Srgb8([i, 3 * i, 255 - 7 * i]).into(), name: "Sea ".repeat(i.into()) };
    let swatches: Vec<_> = (0..30).map(swatch).collect();
    let kinds = [PaletteKind::Gpl, PaletteKind::Ase, PaletteKind::Hex];
    let seeds: Vec<_> = kinds.iter().map(|kind| write_palette(&swatches, *kind).unwrap()).collect();
    let mut read = 0;
    for run in runs(20_000) {
        let meant = kinds[run as usize % kinds.len()];
        let Ok(palette) = read_palette(&damaged(&seeds, &mut Dice(run + 1)), Some(meant)) else { continue };
        for kind in kinds {
            let again = read_palette(&write_palette(&palette.swatches, kind).unwrap(), None).unwrap();
            let is_named = kind != PaletteKind::Hex;
            let given = palette
                .swatches
                .iter()
                .cloned()
                .map(|swatch| if is_named { swatch } else { swatch.color.into() });
            assert!(again.swatches.iter().cloned().eq(given), "run {run} {kind:?}");
        }
        read += 1;
    }
    assert!(read > 0, "some damage makes other colours");
}

#[test]
fn scribbles() {
    let seeds = [
        br##"{"scribbles":[{"color":"#e6194b","width":1.5,"points":[[38,50],[46,54]]},{"color":"none","width":2,"points":[[9,9]]}]}"##.to_vec(),
        br##"{"scribbles":[{"color":"#ffffff","width":3,"kind":"shade","strength":0.8,"crosses":true,"pressure":"strength","points":[[8,5,0.1],[16,24,0.7]]}]}"##.to_vec(),
    ];
    let page = page();
    let mut read = 0;
    for run in runs(5000) {
        if let Ok(other) = read_scribbles(&damaged(&seeds, &mut Dice(run + 1)), &page.drawing) {
            read += 1;
            check(&Work::new(Document { scribbles: other.scribbles, ..page.clone() }), run);
        }
    }
    assert!(read > 0, "some damage makes other scribbles");
}

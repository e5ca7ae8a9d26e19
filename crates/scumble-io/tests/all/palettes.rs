//! Palettes come back as they were, and what others write is read.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::collection::vec;
use proptest::prelude::*;
use scumble_core::{Paint, Srgb8, Swatch};
use scumble_io::{PaletteError, PaletteKind, read_palette, write_palette};

const KINDS: [PaletteKind; 3] = [PaletteKind::Gpl, PaletteKind::Ase, PaletteKind::Hex];

fn colors(bytes: impl AsRef<[u8]>) -> Vec<[u8; 3]> {
    let rgb = |swatch: &Swatch| match swatch.color {
        Paint::Color(Srgb8(rgb)) => rgb,
        Paint::Clear => panic!("a colour"),
    };
    read_palette(bytes.as_ref(), None).unwrap().swatches.iter().map(rgb).collect()
}

fn names(bytes: impl AsRef<[u8]>) -> Vec<String> {
    read_palette(bytes.as_ref(), None).unwrap().swatches.into_iter().map(|swatch| swatch.name).collect()
}

#[track_caller]
fn refused(bytes: impl AsRef<[u8]>, error: PaletteError) {
    assert_eq!(read_palette(bytes.as_ref(), None).unwrap_err(), error);
}

/// A file of swatches, each a space and its numbers; within a group, as programs write them.
fn ase(swatches: &[(&[u8; 4], &[f32])]) -> Vec<u8> {
    let name = [0, 2, 0, b'a', 0, 0];
    let block =
        |kind: [u8; 2], body: Vec<u8>| [&kind[..], &(body.len() as u32).to_be_bytes(), &body].concat();
    let mut bytes = [&b"ASEF\0\x01\0\0"[..], &(swatches.len() as u32 + 2).to_be_bytes()].concat();
    bytes.extend(block([0xc0, 1], name.to_vec()));
    for (space, numbers) in swatches {
        let numbers: Vec<u8> = numbers.iter().flat_map(|number| number.to_be_bytes()).collect();
        bytes.extend(block([0, 1], [&name[..], &space[..], &numbers, &[0, 0]].concat()));
    }
    bytes.extend(block([0xc0, 2], vec![]));
    bytes
}

#[test]
fn gimps_palettes_are_read() {
    let text =
        "GIMP Palette\r\nName: Sea\r\nColumns: 3\r\n# remark\r\n\r\n  1   2 3\tDeep blue\r\n255 254 253\r\n";
    assert_eq!(colors(text), [[1, 2, 3], [255, 254, 253]]);
    assert_eq!(colors(b"GIMP Palette\n1 2 3 caf\xe9"), [[1, 2, 3]]);
    let expected = "three numbers from 0 to 255";
    refused("GIMP Palette\n1 2 3\n1 2\n", PaletteError::Damaged { line: 3, expected });
    refused("GIMP Palette\n1 2 256\n", PaletteError::Damaged { line: 2, expected });
    refused("GIMP Palette\nName: none\n", PaletteError::NoColors);
    let with_alpha = "GIMP Palette\nChannels: RGBA\n#\n1 2 3 255 Untitled\n4 5 6 0\tSea\n7 8 9\n";
    assert_eq!(colors(with_alpha), [[1, 2, 3], [4, 5, 6], [7, 8, 9]]);
    assert_eq!(names(with_alpha), ["", "Sea", ""]);
    assert_eq!(names("GIMP Palette\nChannels: RGB\n1 2 3 4 km"), ["4 km"]);
    refused("\n \r\n\nGIMP Palette\n1 2 3\n1 2\n", PaletteError::Damaged { line: 6, expected });
}

#[test]
fn what_is_meant_as_a_palette_is_told_what_it_lacks_of_one() {
    let meant =
        |text: &str, kind| read_palette(text.as_bytes(), Some(kind)).map(|palette| palette.swatches.len());
    let damaged = |line, expected| Err(PaletteError::Damaged { line, expected });
    assert_eq!(meant("\n\nPalette\n1 2 3\n", PaletteKind::Gpl), damaged(3, "“GIMP Palette”"));
    assert_eq!(meant("; mine\nred\n", PaletteKind::Hex), damaged(2, "a colour #rrggbb"));
    assert_eq!(meant("#ffffff\n", PaletteKind::Ase), Ok(1), "its beginning tells more than its name");
    assert_eq!(meant("ASE", PaletteKind::Ase), Err(PaletteError::NoSwatches));
    for kind in KINDS.into_iter().filter(|kind| *kind != PaletteKind::Ase) {
        assert_eq!(meant(" \n", kind), Err(PaletteError::NoColors));
    }
}

#[test]
fn lists_of_colours_are_read() {
    assert_eq!(
        colors("\u{feff}1a1C2c\n#ff0080 ; pink\n\n// more\nabc, 0f0\n"),
        [[0x1a, 0x1c, 0x2c], [255, 0, 128], [0xaa, 0xbb, 0xcc], [0, 255, 0],]
    );
    refused("#ffffff\n#fffffff\n", PaletteError::Damaged { line: 2, expected: "a colour #rrggbb" });
    // A word alone may be anything; a name that ends in .hex says what it is meant as.
    assert_eq!(read_palette(b"abc\n", Some(PaletteKind::Hex)).map(|palette| palette.swatches.len()), Ok(1));
    for none in [
        "",
        "hello",
        "<svg/>",
        "{}",
        "; only a remark",
        "#ffff",
        "abc",
        "bad\n#ffffff",
        "decade of drawings",
        "#facade,d #1",
    ] {
        refused(none, PaletteError::NoPalette);
    }
}

#[test]
fn names_are_read() {
    let gimp = "GIMP Palette\n1 2 3\tDeep  blue \n4 5 6\n7 8 9 Untitled\n10 11 12 #0a0b0c\n13 14 15 16 km\n";
    assert_eq!(names(gimp), ["Deep  blue", "", "", "", "16 km"]);
    assert_eq!(names(ase(&[(b"RGB ", &[0.0; 3])])), ["a"]);
    assert_eq!(names("#ffffff ; paper"), [""]);
}

#[test]
fn names_come_back_but_from_lists_of_colours() {
    let swatch = |rgb, name: &str| Swatch { color: Srgb8(rgb).into(), name: name.into() };
    let given =
        [swatch([1, 2, 3], "Häut \u{1f41f}"), swatch([4, 5, 6], ""), swatch([7, 8, 9], "a\nb\u{0}\t")];
    for kind in KINDS {
        let names = names(write_palette(&given, kind).unwrap());
        let expected = if kind == PaletteKind::Hex { ["", "", ""] } else { ["Häut \u{1f41f}", "", "a b"] };
        assert_eq!(names, expected, "{kind:?}");
    }
    let long = names(write_palette(&[swatch([0; 3], &"é".repeat(70_000))], PaletteKind::Ase).unwrap());
    assert_eq!(long[0].chars().count(), 80);
}

#[test]
fn swatches_of_all_spaces_are_read() {
    let read = |space, numbers: &[f32]| colors(ase(&[(space, numbers)]))[0];
    assert_eq!(read(b"RGB ", &[1.0, 0.5, 0.0]), [255, 128, 0]);
    assert_eq!(read(b"RGB ", &[1.5, -0.5, 0.2]), [255, 0, 51]);
    assert_eq!(read(b"Gray", &[0.2]), [51; 3]);
    assert_eq!(read(b"CMYK", &[0.0, 0.5, 1.0, 0.0]), [255, 128, 0]);
    assert_eq!(read(b"CMYK", &[0.0, 0.0, 0.0, 1.0]), [0; 3]);
    assert_eq!(read(b"LAB ", &[1.0, 0.0, 0.0]), [255; 3]);
    assert_eq!(read(b"LAB ", &[0.0, 0.0, 0.0]), [0; 3]);
    // sRGB's red, green and blue in L*a*b* of D50 (Lindbloom's calculator).
    for (lab, expected) in [
        ([0.542917, 80.8125, 69.8851], [255, 0, 0]),
        ([0.878237, -79.2873, 80.9902], [0, 255, 0]),
        ([0.295676, 68.2986, -112.0294], [0, 0, 255]),
    ] {
        let color = read(b"LAB ", &lab);
        assert!(
            color.iter().zip(expected).all(|(a, b): (&u8, u8)| a.abs_diff(b) <= 1),
            "{color:?} is not {expected:?}"
        );
    }
}

#[test]
fn swatches_of_unknown_spaces_are_left_out() {
    let palette =
        read_palette(&ase(&[(b"HSB ", &[0.1]), (b"RGB ", &[0.0; 3]), (b"RGB ", &[f32::NAN; 3])]), None)
            .unwrap();
    assert_eq!((palette.swatches.len(), &*palette.notes()), (1, "left out: 2 colours of an unknown kind"));
    refused(ase(&[(b"HSB ", &[0.1])]), PaletteError::NoKnownColors { count: 1 });
    refused(ase(&[(b"LAB ", &[f32::NAN, 0.0, 0.0])]), PaletteError::NoKnownColors { count: 1 });
}

#[test]
fn swatches_that_are_cut_off_are_refused() {
    let whole = ase(&[(b"RGB ", &[0.0, 0.5, 1.0]), (b"CMYK", &[0.0; 4])]);
    for end in b"ASEF".len()..12 {
        refused(&whole[..end], PaletteError::NoSwatches);
    }
    // The first group's begin, two colours, and its end.
    let mut blocks = Vec::new();
    for end in 12..whole.len() {
        let Err(PaletteError::CutOff { block, blocks: 4 }) = read_palette(&whole[..end], None) else {
            panic!("{end} bytes")
        };
        blocks.push(block);
    }
    assert!(blocks.is_sorted());
    blocks.dedup();
    assert_eq!(blocks, [1, 2, 3, 4]);
    let endless = PaletteError::CutOff { block: 1, blocks: 0xffff_ffff };
    refused(b"ASEF\0\x01\0\0\xff\xff\xff\xff\0\x01\xff\xff\xff\xff", endless);
}

#[test]
fn too_much_is_refused() {
    refused("#ffffff\n".repeat(1001), PaletteError::TooManyColors { limit: 1000 });
    assert_eq!(colors("#ffffff\n".repeat(1000)).len(), 1000);
    for kind in KINDS {
        let written = |count| write_palette(&vec![Paint::from(Srgb8([1, 2, 3])).into(); count], kind);
        assert_eq!(written(1001), Err(PaletteError::TooManyColors { limit: 1000 }));
        assert_eq!(colors(written(1000).unwrap()).len(), 1000);
    }
    refused(" ".repeat(20_000_001), PaletteError::TooLarge);
}

#[test]
fn a_palette_without_colours_is_not_written() {
    assert_eq!(write_palette(&[Paint::Clear.into()], PaletteKind::Gpl), Err(PaletteError::NoColors));
}

proptest! {
    #[test]
    fn every_kind_comes_back(palette in vec(any::<[u8; 3]>(), 1..40)) {
        let paints = palette.iter().map(|rgb| Paint::Color(Srgb8(*rgb))).chain([Paint::Clear]);
        let swatches: Vec<_> = paints.map(Swatch::from).collect();
        for kind in KINDS {
            let bytes = write_palette(&swatches, kind).unwrap();
            prop_assert_eq!(PaletteKind::of_bytes(&bytes), Some(kind));
            prop_assert_eq!(colors(&bytes), palette.clone());
            prop_assert!(names(&bytes).iter().all(String::is_empty));
        }
    }
}

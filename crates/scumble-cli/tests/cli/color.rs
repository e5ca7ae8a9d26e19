//! What `scumble color` makes.

use crate::folder::{CIRCLE, Folder, INSIDE, stderr};

const RED: [u8; 4] = [0xe6, 0x19, 0x4b, 255];
const WHITE: [u8; 4] = [255; 4];
const BLACK: [u8; 4] = [0, 0, 0, 255];
const NOTHING: [u8; 4] = [0; 4];

struct Picture {
    width: usize,
    height: usize,
    rgba: Vec<u8>,
}

impl Picture {
    /// The colour of the pixel at a part of width and height.
    fn at(&self, x: f64, y: f64) -> [u8; 4] {
        let [column, row] = [(x * self.width as f64) as usize, (y * self.height as f64) as usize];
        let start = 4 * (row * self.width + column);
        self.rgba[start..start + 4].try_into().unwrap()
    }
}

fn colored(folder: &Folder, options: &[&str]) -> Picture {
    let arguments = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png"];
    let output = folder.run(&[&arguments, options].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(folder.names(), ["d.svg", "o.png", "s.json"], "no other file is left behind");
    let file = folder.read("o.png");
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgba).unwrap();
    Picture { width: info.width as usize, height: info.height as usize, rgba }
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_stays_a_link() {
    let folder = folder("link").with("target.png", "");
    std::os::unix::fs::symlink("target.png", folder.path().join("link.png")).unwrap();
    let output = folder.run(&["color", "d.svg", "--scribbles", "s.json", "-o", "link.png"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(folder.path().join("link.png").is_symlink());
    assert!(folder.read("target.png").starts_with(b"\x89PNG"));
}

fn folder(name: &str) -> Folder {
    Folder::new(name).with("d.svg", CIRCLE).with("s.json", INSIDE)
}

#[test]
fn a_scribble_in_a_circle_colours_its_inside_and_nothing_else() {
    let picture = colored(&folder("inside"), &["--size", "256"]);
    assert_eq!((picture.width, picture.height), (256, 256));
    for y in 0..256 {
        for x in 0..256 {
            let radius_px = (f64::from(x) - 127.5).hypot(f64::from(y) - 127.5);
            let color = picture.at(f64::from(x) / 256.0, f64::from(y) / 256.0);
            match radius_px {
                ..94.0 => assert_eq!(color, RED, "inside, at {x}, {y}"),
                98.0.. => assert_eq!(color, WHITE, "outside, at {x}, {y}"),
                _ => {}
            }
        }
    }
}

#[test]
fn every_solver_colours_the_inside() {
    let folder = folder("solvers");
    let mesh = colored(&folder, &["--size", "128", "--solver", "mesh"]);
    for solver in ["cpu-grid", "jeschke"] {
        let picture = colored(&folder, &["--size", "128", "--solver", solver]);
        let differences = picture.rgba.iter().zip(&mesh.rgba).map(|(a, b)| a.abs_diff(*b));
        assert!(differences.max() <= Some(2), "{solver}");
    }
}

#[test]
fn the_gpu_paints_what_the_cpu_does() {
    let folder = folder("gpu");
    let gpu = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--size", "128", "--solver", "gpu"];
    let tried = stderr(&folder.run(&gpu));
    if tried.contains("no graphics adapter") {
        return eprintln!("skipped: {tried}");
    }
    let [on_gpu, on_cpu] =
        ["gpu", "cpu-grid"].map(|solver| colored(&folder, &["--size", "128", "--solver", solver]).rgba);
    assert!(on_gpu.iter().zip(&on_cpu).all(|(a, b)| a.abs_diff(*b) <= 1));
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_graphics_driver_there_is_a_way_out() {
    let folder = folder("no-gpu");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_scumble"))
        .args(["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--size", "64", "--solver", "gpu"])
        .envs([("VK_DRIVER_FILES", "/none.json"), ("VK_ICD_FILENAMES", "/none.json")])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("no graphics adapter") && message.contains("cpu-grid"), "{message}");
    assert_eq!(folder.names(), ["d.svg", "s.json"]);
}

#[test]
fn lines_and_transparency_are_asked_for() {
    let folder = folder("lines");
    let on_the_line = (0.5 + 24.0 / 64.0, 0.5);
    let plain = colored(&folder, &["--transparent"]);
    assert_eq!((plain.width, plain.height), (1024, 1024));
    assert_eq!((plain.at(0.5, 0.5), plain.at(0.02, 0.02)), (RED, NOTHING));
    assert_ne!(plain.at(on_the_line.0, on_the_line.1), BLACK);
    let lined = colored(&folder, &["--transparent", "--lines"]);
    assert_eq!((lined.at(0.5, 0.5), lined.at(0.02, 0.02)), (RED, NOTHING));
    assert_eq!(lined.at(on_the_line.0, on_the_line.1), BLACK);
}

#[test]
fn the_size_is_that_of_the_longer_side() {
    let wide = CIRCLE.replace("10 20 64 64", "0 20 128 64").replace("cx=\"42\"", "cx=\"64\"");
    let folder = folder("wide").with("d.svg", wide);
    let picture = colored(&folder, &["--size", "200"]);
    assert_eq!((picture.width, picture.height), (200, 100));
    let picture = colored(&folder, &["--size", "1"]);
    assert_eq!((picture.width, picture.height), (1, 1));
}

#[test]
fn blend_spaces_differ_between_two_colours_and_nowhere_else() {
    let open_box = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">
        <path d="M4 4H60V60H4ZM32 4V40" fill="none" stroke="black"/></svg>"#;
    let dab = |color, x| format!(r#"{{"color":"{color}","width":1,"points":[[{x},20]]}}"#);
    let scribbles = |second| format!(r#"{{"scribbles":[{},{second}]}}"#, dab("#0000ff", 18));
    let folder = Folder::new("blend").with("d.svg", open_box);
    let both = |folder: &Folder| ["oklab", "srgb"].map(|blend| colored(folder, &["--blend", blend]).rgba);
    let folder = folder.with("s.json", scribbles(dab("#0000ff", 46)));
    let [oklab, srgb] = both(&folder);
    assert!(oklab == srgb, "one colour");
    let folder = folder.with("s.json", scribbles(dab("#ffff00", 46)));
    let [oklab, srgb] = both(&folder);
    assert!(oklab != srgb, "two colours that mix");
}

#[test]
fn timings_are_one_json_object() {
    let folder = folder("timings");
    let dab = r##",{"color":"#000000","width":1,"points":[[12,22]]}]}"##;
    let two = format!("{}}}{dab}", INSIDE.trim_end_matches("}]}"));
    let folder = folder.with("s.json", two);
    let output = folder.run(&["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--timings"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let timings: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(timings["counts"]["curves"], 1);
    for count in ["pieces", "triangles", "unknowns"] {
        assert!(timings["counts"][count].as_u64().unwrap() > 100, "{count}");
    }
    for stage in ["import", "map", "mesh", "analyse", "factor", "paint"] {
        assert!(timings["ms"][stage].as_f64().unwrap() >= 0.0, "{stage}");
    }
    for stage in ["color", "solve"] {
        assert_eq!(timings["ms"][stage].as_array().unwrap().len(), 2, "{stage}: one for each scribble");
    }
}

#[test]
fn timings_do_not_change_the_picture() {
    let folder = folder("timed");
    let plain = colored(&folder, &["--size", "128"]);
    let timed = colored(&folder, &["--size", "128", "--timings"]);
    assert!(plain.rgba == timed.rgba);
}

#[test]
fn what_is_usable_is_used_with_a_warning() {
    let scribbles = INSIDE.replace(
        r#"{"scribbles":["#,
        r##"{"version":2,"scribbles":[{"color":"red","width":1,"points":[[38,50]]},"##,
    );
    let drawing = CIRCLE.replace("</svg>", "<text>a</text></svg>");
    let folder = Folder::new("warnings").with("d.svg", drawing).with("s.json", scribbles);
    let output = folder.run(&["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--size", "64"]);
    assert!(output.status.success());
    let warnings = stderr(&output);
    assert!(warnings.contains("d.svg: left out: 1 text\n"), "{warnings}");
    assert!(
        warnings.contains("s.json: left out: 1 unknown field, 1 scribble without a colour #rrggbb"),
        "{warnings}"
    );
    assert_eq!(colored(&folder, &["--size", "64"]).at(0.5, 0.5), RED);
}

#[test]
fn no_scribbles_are_white_paper() {
    let folder = folder("blank").with("s.json", r#"{"scribbles":[]}"#);
    let picture = colored(&folder, &["--size", "64"]);
    assert!(picture.rgba.iter().all(|&byte| byte == 255));
}

#[test]
fn points_far_outside_do_not_change_what_is_inside() {
    let far = INSIDE.replace("[46,54]", "[46,54],[1e300,-1e300]");
    let folder = folder("far").with("s.json", far);
    assert_eq!(colored(&folder, &["--size", "64"]).at(0.5, 0.5), RED);
}

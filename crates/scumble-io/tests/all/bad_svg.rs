//! Files that are no drawing, or that were made to hurt: each has an answer that says what is wrong.

use scumble_io::{ImportError, import_svg};

fn error(bytes: impl AsRef<[u8]>) -> ImportError {
    match import_svg(bytes.as_ref()) {
        Ok(import) => panic!("read {} curves", import.drawing.curves.len()),
        Err(error) => error,
    }
}

fn svg(content: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">{content}</svg>"#)
}

const LINE: &str = r#"<path d="M1 1h6" stroke="black"/>"#;

#[test]
fn what_is_no_svg_is_refused() {
    assert_eq!(error(""), ImportError::Empty);
    assert_eq!(error(" \n\t "), ImportError::Empty);
    assert_eq!(error([0x1f, 0x8b, 8, 0, 0]), ImportError::Compressed);
    assert_eq!(error(b"\xff\xfe<\0s\0v\0g\0"), ImportError::Utf16);
    assert_eq!(error([0x89, b'P', b'N', b'G', 0, 1, 2, 255, 254]), ImportError::NotText);
    assert_eq!(error("%PDF-1.7\n%\u{e2}"), ImportError::ForPrint("PDF"));
    assert_eq!(error("%!PS-Adobe-3.0 EPSF-3.0"), ImportError::ForPrint("PostScript"));
    assert_eq!(error([0xc5, 0xd0, 0xd3, 0xc6, 30, 0]), ImportError::ForPrint("PostScript"));
    assert_eq!(error("<html><body/></html>"), ImportError::NotSvg("html".into()));
    assert_eq!(error(r#"<svg xmlns="urn:other"/>"#), ImportError::NotSvg("svg".into()));
    assert!(matches!(error("not a drawing"), ImportError::NotXml(_)));
    assert!(matches!(error("<svg><g></svg>"), ImportError::NotXml(_)));
    assert!(matches!(error("\0\0\0\0\0\0"), ImportError::NotXml(_)));
}

#[test]
fn what_may_have_been_pasted_is_not_called_a_file() {
    for (text, start) in [
        ("rubbish <<<>>", "this is no SVG drawing, or it is damaged: "),
        ("<p>rubbish</p>", "this is no drawing: it starts with <p>, "),
    ] {
        let said = error(text).to_string();
        assert!(said.starts_with(start) && !said.contains("file"), "{said}");
    }
}

#[test]
fn binary_junk_is_refused() {
    let mut state = 1_u32;
    let mut next = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    for len in [1, 10, 1000, 100_000] {
        let junk: Vec<u8> = (0..len).map(|_| next()).collect();
        assert!(matches!(error(&junk), ImportError::NotText | ImportError::NotXml(_)), "{len} bytes");
    }
}

#[test]
fn a_drawing_without_curves_is_refused() {
    assert!(matches!(error(svg("")), ImportError::NoCurves(_)));
    assert!(matches!(
        error(svg("<g><rect fill='none' width='9' height='9'/></g>")),
        ImportError::NoCurves(_)
    ));
    let only_text = error(svg("<text>a</text><image/>")).to_string();
    assert!(only_text.ends_with("(left out: 1 text, 1 image)"), "{only_text}");
    let only_broken = error(svg(r#"<path d="M NaN 1 L 1e308 2" stroke="black"/>"#)).to_string();
    assert!(only_broken.ends_with("(left out: 1 shape with unusable coordinates)"), "{only_broken}");
}

#[test]
fn a_page_without_area_is_refused() {
    for view_box in
        ["0 0 0 0", "0 0 64 0", "0 0 -4 4", "0 0 NaN 4", "0 0 1e308 1e308", "a b c d", "", "0 0 1e-30 1"]
    {
        let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="{view_box}">{LINE}</svg>"#);
        assert_eq!(error(svg), ImportError::NoPage, "viewBox {view_box:?}");
    }
    let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" width="0" height="9">{LINE}</svg>"#);
    assert_eq!(error(svg), ImportError::NoPage);
}

#[test]
fn more_curves_than_a_file_holds_are_refused() {
    let lines = |count: usize| svg(&format!(r#"<path d="{}" stroke="black"/>"#, "M1 1h6".repeat(count)));
    assert_eq!(error(lines(200_001)), ImportError::TooManyCurves);
    assert_eq!(
        import_svg(lines(200_000).as_bytes()).map(|import| import.drawing.curves.len()).ok(),
        Some(200_000)
    );
}

#[test]
fn fifty_megabytes_are_refused() {
    assert_eq!(error(svg(&LINE.repeat(50_000_000 / LINE.len()))), ImportError::TooLarge);
}

#[test]
fn a_million_nested_groups_are_refused() {
    let nested = |depth: usize| svg(&format!("{}{LINE}{}", "<g>".repeat(depth), "</g>".repeat(depth)));
    assert_eq!(error(nested(1_000_000)), ImportError::TooManyElements);
    for depth in [400_000, 10_000, 201] {
        assert!(matches!(error(nested(depth)), ImportError::TooDeep { .. }), "{depth} groups");
    }
    assert!(import_svg(nested(190).as_bytes()).is_ok());
    let wide = format!("{}{}{}", "<g>".repeat(190), LINE.repeat(100_000), "</g>".repeat(190));
    assert!(matches!(error(svg(&wide)), ImportError::TooDeep { .. }));
}

/// What a web page has by default.
const STACK_BYTES: usize = 1 << 20;

#[test]
fn the_deepest_drawings_that_are_read_need_little_stack() {
    let groups = svg(&format!("{}{LINE}{}", "<g opacity='0.999'>".repeat(195), "</g>".repeat(195)));
    let link = |i: usize| format!(r##"<use href="#s{i}" width="9" height="9"/>"##);
    let symbol = |i: usize| format!(r#"<symbol id="s{i}" viewBox="0 0 9 9">{}</symbol>"#, link(i + 1));
    let symbols: String = (0..95).map(symbol).collect();
    let symbols = svg(&format!(r#"{symbols}<symbol id="s95">{LINE}</symbol>{}"#, link(0)));
    let masked = |inner: &str| [r#"<g mask="url(#m)">"#, inner, "</g>"].concat();
    let masked = (0..90).fold(LINE.to_owned(), |inner, _| masked(&inner));
    let masks = [95, 190].map(|levels| {
        let content = [&"<g>".repeat(levels), LINE, &"</g>".repeat(levels)].concat();
        svg(&format!(r#"<mask id="m">{content}</mask>{masked}"#))
    });
    for deep in [groups, symbols].into_iter().chain(masks) {
        let read = move || import_svg(deep.as_bytes()).map(|import| import.drawing.curves.len());
        let thread = std::thread::Builder::new().stack_size(STACK_BYTES).spawn(read).unwrap();
        assert_eq!(thread.join().unwrap(), Ok(1));
    }
}

#[test]
fn use_bombs_are_refused() {
    let level =
        |i: usize| format!(r##"<g id="u{i}">{}</g>"##, format!(r##"<use href="#u{}"/>"##, i - 1).repeat(10));
    let bomb = |levels: usize| {
        let levels: String = (1..=levels).map(level).collect();
        svg(&format!(r#"<g id="u0">{LINE}</g>{levels}"#))
    };
    assert_eq!(error(bomb(5)), ImportError::TooManyElements);
    assert_eq!(error(bomb(60)), ImportError::TooManyElements);
    assert!(matches!(error(bomb(200)), ImportError::TooDeep { .. }));
    assert!(import_svg(bomb(2).as_bytes()).is_ok());
}

#[test]
fn use_chains_and_circles_are_refused() {
    let link = |i: usize| format!(r##"<g id="u{i}"><use href="#u{}"/></g>"##, i + 1);
    let chain: String = (0..100_000).map(link).collect();
    assert!(matches!(error(svg(&chain)), ImportError::TooDeep { .. }));
    let circle =
        r##"<g id="a"><use href="#b"/></g><g id="b"><use href="#c"/></g><g id="c"><use href="#a"/></g>"##;
    assert_eq!(error(svg(circle)), ImportError::Circular);
    assert_eq!(error(svg(r##"<g id="a"><use href="#a"/></g>"##)), ImportError::Circular);
}

#[test]
fn copies_of_long_paths_are_refused() {
    let long = format!(r#"<path id="p" stroke="black" d="M0 0{}"/>"#, "l1 1".repeat(100_000));
    assert_eq!(
        error(svg(&format!("{long}{}", r##"<use href="#p"/>"##.repeat(100)))),
        ImportError::TooDetailed
    );
}

#[test]
fn entity_bombs_are_refused() {
    let laughs: String =
        (1..10).map(|i| format!(r#"<!ENTITY l{i} "{}">"#, format!("&l{};", i - 1).repeat(10))).collect();
    let bomb = format!(r#"<!DOCTYPE svg [<!ENTITY l0 "lol">{laughs}]>{}"#, svg("<text>&l9;</text>"));
    assert_eq!(error(bomb), ImportError::Entities);
    let flat =
        format!(r#"<!DOCTYPE svg [<!ENTITY e "{}">]>{}"#, " ".repeat(4000), svg(&"&e;".repeat(100_000)));
    assert_eq!(error(flat), ImportError::Entities);
    let long = format!(r#"<!DOCTYPE svg [<!ENTITY e "{}">]>{}"#, " ".repeat(10_000), svg("&e;"));
    assert_eq!(error(long), ImportError::Entities);
}

#[test]
fn attributes_without_end_are_refused() {
    let attributes: String = (0..100_000).map(|i| format!(r#" a{i}="""#)).collect();
    assert_eq!(error(svg(&format!("<g{attributes}/>"))), ImportError::TooManyAttributes);
    let name_spaces: String = (0..20_000).map(|i| format!(r#"<g xmlns:n{i}="u{i}"/>"#)).collect();
    assert_eq!(error(svg(&name_spaces)), ImportError::TooManyAttributes);
}

#[test]
fn gradient_and_pattern_bombs_are_refused() {
    let shapes = r#"<path d="M0 0h9v9z" fill="url(#g)"/>"#.repeat(1000);
    let stops = "<stop offset='0.5'/>".repeat(100_000);
    let gradient = format!(r#"<linearGradient id="g">{stops}</linearGradient>{shapes}"#);
    assert_eq!(error(svg(&gradient)), ImportError::TooManyStops);
    let pattern =
        format!(r#"<pattern id="g" width="1" height="1">{}</pattern>{shapes}"#, LINE.repeat(10_000));
    assert_eq!(error(svg(&pattern)), ImportError::TooManyStops);
    let link = |i: usize| format!(r##"<linearGradient id="g{i}" href="#g{}"/>"##, i + 1);
    let chain: String = (0..10_000).map(link).collect();
    assert_eq!(error(svg(&chain)), ImportError::Circular);
    let circle = r##"<radialGradient id="g" href="#h"/><radialGradient id="h" href="#g"/>"##;
    assert_eq!(error(svg(circle)), ImportError::Circular);
}

#[test]
fn patterns_within_patterns_end() {
    let pattern = |i: usize| {
        let tiles = format!(r##"<path d="M0 0h9v9z" fill="url(#p{})"/>"##, i + 1).repeat(10);
        format!(r#"<pattern id="p{i}" width="1" height="1">{tiles}</pattern>"#)
    };
    let nested: String = (0..30).map(pattern).collect();
    let import = import_svg(svg(&format!(r#"{nested}<path d="M1 1h9v9z" fill="url(#p0)"/>"#)).as_bytes());
    assert_eq!(import.map(|import| import.drawing.curves.len()), Ok(1));
}

/// Masks that mask each other, or what is masked, without end.
fn endless_masks() -> Vec<String> {
    let masked = |i: usize| format!(r#"<rect width="9" height="9" fill="white" mask="url(#m{i})"/>"#);
    let nested = |i: usize| format!(r#"<mask id="m{i}">{}</mask>"#, masked(i + 1).repeat(10));
    let used = |i: usize| {
        let group = format!(r#"<g id="g{i}">{}</g>"#, masked(i + 1).repeat(10));
        format!(r##"<defs>{group}</defs><mask id="m{i}"><use href="#g{i}"/></mask>"##)
    };
    let linked = |i: usize| {
        format!(r#"<mask id="m{i}" mask="url(#m{})"><path d="M0 0h9v9z" fill="white"/></mask>"#, i + 1)
    };
    let circle = |count: usize| -> String {
        (0..count).map(|i| format!(r#"<mask id="m{i}">{}</mask>"#, masked((i + 1) % count))).collect()
    };
    let plain = r#"<mask id="m0"><path d="M0 0h9v9z" fill="white"/></mask>"#;
    let inherited = |i: usize| {
        let mask = r#"mask="inherit" maskUnits="userSpaceOnUse" width="9" height="9""#;
        let next = (i + 1) % 3;
        format!(
            r#"<g mask="url(#m{next})"><mask id="m{i}" {mask}><path d="M0 0h9v9z" fill="white"/></mask></g>"#
        )
    };
    let inherits = (0..3).map(inherited).collect::<String>();
    vec![
        inherits.replace(r#"mask="inherit""#, r#"style="mask:inherit""#),
        inherits,
        (0..30).map(nested).collect(),
        (0..30).map(used).collect(),
        (0..50_000).map(linked).collect(),
        circle(1),
        circle(2),
        circle(3),
        [plain, &circle(3)].concat(),
        [plain, &circle(3).replace(" id=", " xml:id=")].concat(),
        circle(3).replace(" mask=", " xlink:mask="),
        circle(3).replace(r#"mask="url(#m1)""#, r#"style="MASK:url(#m1)""#),
        format!(r#"<style>rect{{mask/**/:url(#m0)}}</style>{}"#, circle(3).replace(" mask=", " title=")),
    ]
}

#[test]
fn masks_that_mask_each_other_are_ignored_and_counted() {
    for masks in endless_masks() {
        let shape = r#"<path d="M1 1h30v30" fill="none" stroke="black" mask="url(#m0)"/>"#;
        let svg = svg(&[&masks, shape].concat());
        let svg = svg.replace("<svg ", r#"<svg xmlns:xlink="http://www.w3.org/1999/xlink" "#);
        let import = import_svg(svg.as_bytes()).unwrap();
        assert_eq!(import.drawing.curves[0].path.to_svg(), "M16,16 L496,16 L496,496", "{svg:.300}");
        assert!(import.notes.masks > 0, "{svg:.300}");
    }
}

#[test]
fn masks_without_end_are_answered_soon() {
    let mask = |content: &str| format!(r#"<mask id="m" fill="white">{content}</mask>"#);
    let masked = |count: usize| r#"<path d="M1 1h30v30" mask="url(#m)"/>"#.repeat(count);
    let square = r#"<path d="M0 0h9v9z"/>"#;
    let stops = "<stop stop-color='white'/>".repeat(200);
    let gradient = format!(r#"<linearGradient id="g">{stops}</linearGradient>"#);
    let nothing = r#"<rect width="0" height="9"/>"#;
    for content in [
        [mask(&square.repeat(10)), masked(150_000)].concat(),
        [
            "<style>path{mask:inherit}</style>",
            &mask(&square.repeat(100)),
            r#"<g mask="url(#m)">"#,
            &r#"<path d="M1 1h30v30"/>"#.repeat(50_000),
            "</g>",
        ]
        .concat(),
        [mask(square), masked(20_000)].concat(),
        [mask(&square.repeat(100)), masked(3000)].concat(),
        [mask(&square.repeat(50_000)), masked(9)].concat(),
        [mask(&square.repeat(50_000)), format!(r#"<mask id="n">{}</mask>"#, masked(50_000)), masked(1)]
            .concat(),
        [mask(&nothing.repeat(30_000)), masked(30_000)].concat(),
        [
            &gradient,
            r#"<g fill="url(#g)">"#,
            &mask(&square.repeat(9)).replace(" fill=\"white\"", ""),
            "</g>",
            &masked(9000),
        ]
        .concat(),
        [
            mask(&square.repeat(9)),
            format!(r#"<pattern id="p" width="9" height="9">{}</pattern>"#, masked(100)),
            r##"<path d="M1 1h30v30" fill="url(#p)"/>"##.repeat(9000),
        ]
        .concat(),
    ] {
        let file = svg(&content);
        let start = std::time::Instant::now();
        let _ = import_svg(file.as_bytes());
        let took = start.elapsed();
        assert!(took.as_secs() < 10, "{took:?} for {content:.60}…");
    }
}

#[test]
fn style_sheet_bombs_are_refused() {
    let groups = |depth: usize| format!("{}{LINE}{}", "<g>".repeat(depth), "</g>".repeat(depth));
    let deep = format!("<style>y {} path{{fill:red}}</style>{}", "g ".repeat(12), groups(60));
    assert_eq!(error(svg(&deep)), ImportError::TooManyStyles);
    let many = format!("<style>{}</style>{}", ".a{fill:red}".repeat(20_000), LINE.repeat(20_000));
    assert_eq!(error(svg(&many)), ImportError::TooManyStyles);
    let classes =
        format!("<style>{}</style><g class='{}'/>", ".a{fill:red}".repeat(1000), "b ".repeat(1_000_000));
    assert_eq!(error(svg(&classes)), ImportError::TooManyStyles);
    let long = format!("<g style='{}'/>", "fill:red;".repeat(1_000_000));
    assert_eq!(error(svg(&long)), ImportError::TooManyStyles);
    let comment = format!("<style>/* {} */ .a{{fill:red}}</style>{LINE}", "a, b { } ".repeat(10_000));
    assert!(import_svg(svg(&comment).as_bytes()).is_ok());
}

#[test]
fn dashes_without_end_are_refused() {
    let dashes = "1 ".repeat(1000);
    for dashed in [
        format!(r#"<g stroke-dasharray="{dashes}">{LINE}</g>"#),
        format!("<g style='stroke-dasharray:{dashes}'>{LINE}</g>"),
        format!("<style>g{{stroke-dasharray:{dashes}}}</style>{LINE}"),
    ] {
        assert_eq!(error(svg(&dashed)), ImportError::TooManyDashes);
    }
    let entity = format!(r#"<!DOCTYPE svg [<!ENTITY w "{dashes}">]>"#);
    let dashed = svg(&format!(r#"<g stroke-dasharray="&w;">{LINE}</g>"#));
    assert_eq!(error(format!("{entity}{dashed}")), ImportError::TooManyDashes);
}

/// Values within values, of about so many bytes.
fn nested_values(bytes: usize) -> Vec<String> {
    let nested = |open: &&str| {
        let count = bytes / (open.len() + 1);
        format!("{}{}", open.repeat(count), ")".repeat(count))
    };
    ["(", "var(--a,", "rgb(from ", "light-dark(", "color-mix(in a,"].iter().map(nested).collect()
}

#[test]
fn colours_and_styles_without_end_are_answered_soon() {
    let mut files = Vec::new();
    for value in nested_values(4_500_000) {
        files.push(format!(r#"<g fill="{value}" style="stroke:{value};--b:{value};transform:{value}"/>"#));
        files.push(format!("<style>a{{fill:{value};--b:{value}}}</style>"));
    }
    for value in nested_values(240) {
        files.push(format!(r#"<g fill="{value}"/>"#).repeat(70_000));
        files.push(
            format!(r#"<g style="fill:{value};width:{value};--a:{value};transform:{value}"/>"#)
                .repeat(18_000),
        );
    }
    let names = |count: usize| (0..count).map(|i| format!("--a{i}:var(--a{});", i + 1)).collect::<String>();
    files.push(format!("<style>a{{{}}}</style>", names(700_000)));
    files.push(format!("<style>{}</style>", "a{".repeat(9_000_000)));
    files.push(format!("<style>{}</style>", "a{--b:c}".repeat(2_000_000)));
    files.push(format!("<g style=\"fill:{}\"/>", r"\'".repeat(9_000_000)));
    for call in ["scaleX(1)", "scaleX(1e308)", "rotateZ(1)", "matrix(1e308,1e-308,0,1e308,0,0)"] {
        files.push(format!("<g style='transform:scaleX(1){}'/>", call.repeat(19_000_000 / call.len())));
        let declaration = format!("transform:scaleX(1){call};");
        files.push(format!("<g style='{}'/>", declaration.repeat(19_000_000 / declaration.len())));
    }
    files.push(format!("<g style='{}'/>", ";:".repeat(9_000_000)));
    files.push(format!("<g style='{}{}'/>", "fill:red;".repeat(1_000_000), "stroke:#;".repeat(1_000_000)));
    for content in files {
        let file = svg(&content);
        assert!(file.len() < 20_000_000);
        let start = std::time::Instant::now();
        let _ = import_svg(file.as_bytes());
        let took = start.elapsed();
        assert!(took.as_secs() < 10, "{took:?} for {}…", &content[..60]);
    }
}

#[test]
fn lines_as_wide_as_a_thousand_pages_are_refused() {
    assert_eq!(error(svg(r#"<path d="M1 1h6" style="stroke-miterlimit:1e40"/>"#)), ImportError::TooWide);
    assert_eq!(error(svg(r#"<path d="M1 1h6" style="stroke-width:/**/1e40"/>"#)), ImportError::TooWide);
    assert_eq!(error(svg(r#"<path d="M1 1h6" stroke-width="&#49;e40"/>"#)), ImportError::TooWide);
    assert_eq!(
        error(svg(r#"<g stroke-width="1e7"><path d="M1 1h6" stroke="black"/></g>"#)),
        ImportError::TooWide
    );
    assert_eq!(
        error(svg(&format!("<style>path {{ stroke-width : 10000000px }}</style>{LINE}"))),
        ImportError::TooWide
    );
}

#[test]
fn more_segments_than_fit_are_refused() {
    let stairs = format!(r#"<path stroke="black" d="M0 0{}"/>"#, "h1v1".repeat(260_000));
    assert_eq!(error(svg(&stairs)), ImportError::TooDetailed);
}

#[test]
fn every_message_says_what_to_do() {
    let messages = [error(""), error(svg("")), error("\u{1}"), error(svg(&"<g>".repeat(1_000_001)))];
    for message in messages.map(|error| error.to_string()) {
        assert!((20..400).contains(&message.len()), "{message}");
    }
}

//! Colours, transforms and style sheets as browsers read them, written anew for `usvg`, which knows fewer of them.
//!
//! It leaves out a line whose colour it cannot read, makes such an area black, and passes over all declarations behind one that
//! it does not understand. It knows no units in transforms. Only values of colours and styles are looked at here, each once.
//!
//! | noun | file |
//! |---|---|
//! | what lies between brackets, quotes and semicolons | `text` |
//! | rules that hold on some condition | `at_rules` |
//! | what colours are given to | `property` |
//! | a colour, as it is written | `values` |
//! | the spaces that colours are in | `spaces` |
//! | transforms | `transforms` |
//! | variables | `variables` |

pub(crate) mod at_rules;
mod property;
mod spaces;
mod text;
mod transforms;
mod values;
mod variables;

use std::borrow::Cow;
use std::ops::Range;

use roxmltree::{Attribute, Document, Node};

use crate::limits::SVG;
use crate::style_sheet::{self, shown_texts, without_comments};
use property::Property;
use text::{declared, is_plain};
use values::readable;
use variables::Variables;

/// What is to be written anew.
#[derive(Debug, Default)]
pub(crate) struct Mends {
    /// Where in the text, and what there.
    pub(crate) edits: Vec<(Range<usize>, String)>,
    /// Colours that nobody can read.
    pub(crate) unreadable: usize,
    /// Transforms that cannot be followed.
    pub(crate) lost_transforms: usize,
}

/// Bytes that a declaration with variables may grow by.
const MOST_GROWTH: usize = 16;

/// What stands for a line whose width is that of the whole picture, whatever its transform: `usvg` keeps no other mark of it,
/// and nothing else is made of this one.
pub(crate) const UNSCALED: &str = "shape-rendering:optimizeSpeed";

/// Filters and masks that are none.
const NOTHING: [&str; 4] = ["", "none", "initial", "unset"];

/// What has a filter or a mask does not hide what is painted before it.
const SEEN_THROUGH: &str = "mix-blend-mode:multiply";

/// Looks through all elements.
pub(crate) fn of(xml: &Document) -> Mends {
    let mut mender = Mender {
        text: xml.input_text(),
        variables: variables(xml),
        has_own_boxes: has_own_boxes(xml),
        mends: Mends::default(),
    };
    let elements = xml.descendants().filter(|node| matches!(node.tag_name().namespace(), None | Some(SVG)));
    for node in elements.filter(Node::is_element) {
        mender.element(node);
    }
    mender.mends
}

/// A text with its edits, but for those within another. What entities repeat is edited once.
pub(crate) fn edited(text: &str, mut edits: Vec<(Range<usize>, String)>) -> String {
    edits.sort_by_key(|(place, _)| place.start);
    edits.dedup();
    let mut edited = String::with_capacity(text.len());
    let mut at = 0;
    for (place, anew) in edits {
        if let Some(before) = text.get(at..place.start) {
            edited.extend([before, &anew]);
            at = place.end;
        }
    }
    edited.push_str(text.get(at..).unwrap_or_default());
    edited
}

/// The variables of all style sheets, and of all elements after these.
fn variables(xml: &Document) -> Variables {
    let sheets = shown_texts(xml).filter(|css| css.contains("--")).map(without_comments);
    let sheets: Vec<_> = sheets.map(|css| at_rules::plain(&css).into_owned()).collect();
    let blocks = sheets.iter().flat_map(|css| text::blocks(css).into_iter().map(|block| &css[block]));
    let styles = xml.descendants().filter_map(|node| node.attribute("style"));
    let styles: Vec<_> = styles.filter(|css| css.contains("--")).map(without_comments).collect();
    Variables::of(blocks.chain(styles.iter().map(String::as_str)))
}

/// Whether styles say that transforms are around points of the boxes of shapes.
fn has_own_boxes(xml: &Document) -> bool {
    let styles = xml.descendants().filter_map(|node| node.attribute("style"));
    let boxes = ["fill-box", "stroke-box", "content-box", "border-box"];
    let mut boxed = styles.chain(shown_texts(xml)).filter(|css| css.contains("transform-box"));
    boxed.any(|css| boxes.iter().any(|name| css.contains(name)))
}

struct Mender<'t> {
    text: &'t str,
    variables: Variables,
    /// Whether shapes may be turned around points of their own boxes, which are not known here.
    has_own_boxes: bool,
    mends: Mends,
}

impl Mender<'_> {
    fn element(&mut self, node: Node) {
        match node.tag_name().name() {
            "style" => self.sheet(node),
            // Their `fill` is what stays of a movement.
            "set" | "animate" | "animateColor" | "animateMotion" | "animateTransform" => {}
            _ => node.attributes().for_each(|attribute| self.attribute(node, attribute)),
        }
    }

    fn attribute(&mut self, node: Node, attribute: Attribute) {
        let value = attribute.value();
        let anew = match (attribute.name(), Property::of(attribute.name())) {
            _ if attribute.namespace().is_some() => None,
            ("style", _) => self.declarations(value, Some(node)),
            (_, Some(property)) => match readable(property, value, &self.variables) {
                Some(Cow::Borrowed(same)) if same == value => None,
                Some(anew) => Some(anew.into_owned()),
                None => Some(self.stand_in(property)),
            },
            _ => None,
        };
        let place = attribute.range_value();
        if let Some(anew) = anew.filter(|_| is_quoted(self.text, &place)) {
            self.mends.edits.push((place, escaped(&anew)));
        }
    }

    fn stand_in(&mut self, property: Property) -> String {
        self.mends.unreadable += 1;
        property.stand_in().to_owned()
    }

    fn sheet(&mut self, node: Node) {
        let whole = without_comments(&style_sheet::texts_of(node).collect::<String>());
        let css = if style_sheet::is_shown(&node) { at_rules::plain(&whole) } else { Cow::Borrowed("") };
        let blocks = text::blocks(&css).into_iter();
        let edits: Vec<_> =
            blocks.filter_map(|block| Some((block.clone(), self.declarations(&css[block], None)?))).collect();
        let place = self.content(node).filter(|_| css != whole || !edits.is_empty());
        if let Some(place) = place {
            self.mends.edits.push((place, escaped(&edited(&css, edits))));
        }
    }

    /// Where the content of an element lies; `None` where an entity stands for it: that lies elsewhere, and stays.
    fn content(&self, node: Node) -> Option<Range<usize>> {
        let start = node.first_child()?.range().start;
        let end = node.range().start + self.text.get(node.range())?.rfind("</")?;
        node.range().contains(&start).then_some(start..end)
    }

    /// The declarations of a rule, or of an element; `None` where they can stay as they are.
    fn declarations(&mut self, css: &str, node: Option<Node>) -> Option<String> {
        let css = if css.contains("/*") { Cow::Owned(without_comments(css)) } else { Cow::Borrowed(css) };
        let whole = css.trim_start_matches(|c: char| c == ';' || c.is_whitespace());
        let mut is_mended = css.trim_start().starts_with(';') && !whole.is_empty();
        let mut kept = Vec::new();
        let given = node.iter().flat_map(Node::attributes).filter_map(|given| Property::of(given.name()));
        let mut known: Vec<_> = given.collect();
        for declaration in text::parts(whole, |b| b == b';').filter(|text| !text.trim().is_empty()) {
            let anew = self.declaration(declaration, &mut known);
            is_mended |= !matches!(anew, Some(Cow::Borrowed(_)));
            kept.extend(anew);
        }
        is_mended.then(|| kept.join(";"))
    }

    /// A declaration as `usvg` reads it; `None` where what came before it stands.
    fn declaration<'c>(&mut self, declaration: &'c str, known: &mut Vec<Property>) -> Option<Cow<'c, str>> {
        let (name, value) = declared(declaration).filter(|(name, _)| !name.starts_with("--"))?;
        if name.bytes().any(|byte| byte.is_ascii_uppercase()) {
            let lower = [&name.to_ascii_lowercase(), ":", value].concat();
            return self.declaration(&lower, known).map(|anew| Cow::Owned(anew.into_owned()));
        }
        let Some(property) = Property::of(name) else { return self.other(declaration, name, value) };
        let (value, important) = split_important(value);
        let anew = readable(property, value, &self.variables).filter(|_| !value.is_empty());
        let is_known = known.contains(&property);
        // Once each: this list is searched for each declaration.
        known
            .extend(Some(property).filter(|_| (is_known || !value.is_empty()) && !known.contains(&property)));
        match anew {
            Some(anew) if anew == value && is_plain(name, value) => Some(Cow::Borrowed(declaration)),
            Some(anew) => Some(Cow::Owned([name, ":", &anew, important].concat())),
            None if value.is_empty() || is_known => None,
            None => Some(Cow::Owned([name, ":", &self.stand_in(property), important].concat())),
        }
    }

    /// A declaration of something else than a colour.
    fn other<'c>(&mut self, declaration: &'c str, name: &str, value: &str) -> Option<Cow<'c, str>> {
        match (name, split_important(value).0) {
            ("vector-effect", "non-scaling-stroke") => return Some(Cow::Owned(UNSCALED.to_owned())),
            // It would be taken for that.
            ("shape-rendering", _) => return None,
            // Of the outermost element; only that much of it is read.
            ("background", "") => return None,
            ("background", _) => {
                let of_color = ["background-color:", value].concat();
                return self
                    .other(&of_color, "background-color", value)
                    .map(|anew| Cow::Owned(anew.into_owned()));
            }
            ("transform", _) => return self.transform(declaration, value),
            ("filter" | "mask", value)
                if NOTHING.iter().any(|nothing| value.eq_ignore_ascii_case(nothing)) => {}
            ("mask", _) if is_plain(name, value) => {
                return Some(Cow::Owned([declaration, ";", SEEN_THROUGH].concat()));
            }
            ("filter" | "mask", _) => return Some(Cow::Owned(SEEN_THROUGH.to_owned())),
            _ => {}
        }
        if is_plain(name, value) && !value.contains("var(") {
            return Some(Cow::Borrowed(declaration));
        }
        let anew = self.variables.put_in(value).filter(|anew| anew.len() <= value.len() + MOST_GROWTH)?;
        is_plain(name, &anew).then(|| Cow::Owned([name, ":", &anew].concat()))
    }

    /// A declaration of a transform.
    fn transform<'c>(&mut self, declaration: &'c str, value: &str) -> Option<Cow<'c, str>> {
        let (given, important) = split_important(value);
        if given.is_empty() {
            return None;
        }
        let with_variables = || Some(transforms::readable(&self.variables.put_in(given)?)?.into_owned());
        let anew = transforms::readable(given).or_else(|| with_variables().map(Cow::Owned));
        match anew.filter(|anew| !self.has_own_boxes || transforms::only_moves(anew)) {
            Some(anew) if anew == given && declaration.ends_with(important) => {
                Some(Cow::Borrowed(declaration))
            }
            Some(anew) => Some(Cow::Owned(["transform:", &anew, important].concat())),
            None => {
                self.mends.lost_transforms += 1;
                None
            }
        }
    }
}

/// Whether a place is right between two quotes: the parser counts the bytes before a value up to some limit.
pub(crate) fn is_quoted(text: &str, place: &Range<usize>) -> bool {
    let byte = |at: Option<usize>| at.and_then(|at| text.as_bytes().get(at));
    let quotes = [byte(place.start.checked_sub(1)), byte(Some(place.end))];
    quotes[0] == quotes[1] && matches!(quotes[0], Some(b'"' | b'\''))
}

/// A value, and the mark that lets it go before others.
fn split_important(value: &str) -> (&str, &str) {
    const MARK: &str = "!important";
    match value.rsplit_once('!') {
        Some((value, mark)) if mark.trim().eq_ignore_ascii_case("important") => (value.trim_end(), MARK),
        _ => (value, ""),
    }
}

/// A text that stands in XML, in quotes or between tags.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&apos;"),
            other => escaped.push(other),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mended(svg: &str) -> String {
        edited(svg, of(&Document::parse(svg).unwrap()).edits)
    }

    #[test]
    fn what_is_read_anyway_is_not_touched() {
        for svg in [
            r##"<svg fill="none" stroke="#123" style="fill:url(#a) none;stroke-dasharray:1,2;;font:'A/B'"/>"##,
            r##"<svg><style>/* x:y */ .a, #b > c { fill: none; stroke: red !important }</style></svg>"##,
            r##"<svg><animate fill="freeze"/><x:a xmlns:x="urn:x" fill="nothing"/></svg>"##,
        ] {
            assert!(of(&Document::parse(svg).unwrap()).edits.is_empty(), "{svg}");
        }
    }

    #[test]
    fn only_what_has_to_be_is_written_anew() {
        for (svg, expected) in [
            (r#"<svg  stroke = 'currentcolor' id="1"/>"#, r#"<svg  stroke = 'currentColor' id="1"/>"#),
            (r#"<svg style="--x:1; fill:none;stroke:#00f"/>"#, r#"<svg style=" fill:none;stroke:#00f"/>"#),
            (r#"<svg style="fill:var(--x, none) ! important"/>"#, r#"<svg style="fill:none!important"/>"#),
            (r#"<svg style=";fill:;stroke:red"/>"#, r#"<svg style="stroke:red"/>"#),
            (r#"<svg style="font:&quot;A&quot;;--x:'"/>"#, r#"<svg style="font:&quot;A&quot;"/>"#),
            (r#"<svg style="/*;*/--x:1;stroke-width:var(--x)"/>"#, r#"<svg style="stroke-width:1"/>"#),
            (
                r#"<svg style="transform:scaleX(2)!important;fill:none"/>"#,
                r#"<svg style="transform:matrix(2e0 0e0 0e0 1e0 0e0 0e0)!important;fill:none"/>"#,
            ),
            (r#"<svg style="transform:;fill:none"/>"#, r#"<svg style="fill:none"/>"#),
            (r#"<svg style="FILL:none;Stroke-Width:2"/>"#, r#"<svg style="fill:none;stroke-width:2"/>"#),
            (r#"<svg fill="a" stroke="b"/>"#, r#"<svg fill="white" stroke="black"/>"#),
            (
                "<svg><style>@import url('x;y');@media all{a{x:1}}</style></svg>",
                "<svg><style>a{x:1}</style></svg>",
            ),
            (
                r#"<svg><style media="print">a{x:1}</style></svg>"#,
                r#"<svg><style media="print"></style></svg>"#,
            ),
            (
                "<svg><style>@layer{a{--x:1}}b{y:var(--x)}</style></svg>",
                "<svg><style>a{}b{y:1}</style></svg>",
            ),
            (
                "<svg><style><![CDATA[a>b{--y:2;fill:none}]]> c{x:1} </style></svg>",
                "<svg><style>a&gt;b{fill:none} c{x:1} </style></svg>",
            ),
        ] {
            assert_eq!(mended(svg), expected);
        }
    }

    #[test]
    fn edits_within_others_are_passed_over() {
        let cut = |place| (place, String::new());
        assert_eq!(edited("0123456789", vec![cut(9..10), cut(1..3), cut(4..8), cut(5..6)]), "038");
        assert_eq!(edited("0123", vec![(1..3, "x".into()), (2..3, "y".into()), (3..3, "z".into())]), "0xz3");
        assert_eq!(edited("01", vec![(1..1, "x".into()), (1..1, "x".into())]), "0x1");
        assert_eq!(edited("0123", Vec::new()), "0123");
    }
}

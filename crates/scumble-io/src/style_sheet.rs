//! What it costs to match a file's style sheets.
//!
//! `simplecss` tests every rule on every element, and a selector of k words by trying all ancestors for each of
//! them. The cost is estimated from the text alone.

use roxmltree::{Document, Node};

use crate::css::at_rules;

/// Tests of one element against all style sheets of a tree of a given height, and declarations applied to it.
pub(crate) fn tests_per_element(xml: &Document, height: u32) -> f64 {
    texts(xml).map(|css| tests(&without_comments(css), f64::from(height))).sum()
}

/// The texts of a tree's style sheets.
pub(crate) fn texts<'a>(xml: &'a Document) -> impl Iterator<Item = &'a str> {
    sheets(xml).flat_map(texts_of)
}

/// Those of the style sheets that a screen shows.
pub(crate) fn shown_texts<'a>(xml: &'a Document) -> impl Iterator<Item = &'a str> {
    sheets(xml).filter(is_shown).flat_map(texts_of)
}

/// Whether a screen shows a style sheet.
pub(crate) fn is_shown(sheet: &Node) -> bool {
    sheet.attribute("media").is_none_or(at_rules::is_shown)
}

fn sheets<'a, 'i>(xml: &'a Document<'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    xml.descendants().filter(|node| node.tag_name().name() == "style")
}

/// The text of one style sheet, which entities may part.
pub(crate) fn texts_of<'a>(sheet: Node<'a, '_>) -> impl Iterator<Item = &'a str> {
    sheet.children().filter(Node::is_text).filter_map(|node| node.text())
}

pub(crate) fn without_comments(css: &str) -> String {
    let mut parts = css.split("/*");
    let first = parts.next().unwrap_or_default();
    let rest = parts.map(|part| part.split_once("*/").map_or("", |(_, after)| after));
    std::iter::once(first).chain(rest).collect()
}

/// A rule is stored and tested once for each of its selectors, with all its declarations.
fn tests(css: &str, height: f64) -> f64 {
    let rules = css.split('}').filter_map(|rule| rule.split_once('{'));
    let selectors = rules.flat_map(|(selectors, body)| {
        let declarations = 1.0 + body.matches(';').count() as f64;
        selectors.split(',').map(move |selector| (selector, declarations))
    });
    selectors.map(|(selector, declarations)| selector_tests(selector, height) + declarations).sum()
}

/// Ways to lay the words of a selector along the ancestors of an element.
fn selector_tests(selector: &str, height: f64) -> f64 {
    let words: Vec<_> = selector.split_whitespace().collect();
    let is_word = |word: &str| !matches!(word, ">" | "+");
    let descents = words.windows(2).filter(|pair| is_word(pair[0]) && is_word(pair[1])).count();
    (0..descents).map(|i| (height - i as f64).max(1.0) / (i + 1) as f64).product()
}

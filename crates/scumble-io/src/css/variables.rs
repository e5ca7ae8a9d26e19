//! Variables of style sheets: `--name: value`, and `var(--name, fallback)` in their places.
//!
//! A name has one value in the whole file, the first: where there are more, a sheet begins with what holds for all.

use std::collections::HashMap;

use super::text::{self, enclosed};

/// Longest value with variables in it, in bytes, before and after they have been put in. Longer ones are no colours.
const MAX_VALUE_BYTES: usize = 256;

/// Most parentheses that open in such a value: each is looked through once for each that it is in.
const MAX_CALLS: usize = 12;

/// Most variables of a file; there are no others then.
const MAX_VARIABLES: usize = 10_000;

/// How many variables stand for each other in turn.
const MAX_CHAIN: usize = 4;

/// Values by name.
#[derive(Clone, Debug, Default)]
pub(crate) struct Variables(HashMap<String, String>);

impl Variables {
    /// The variables that some blocks of declarations have.
    pub(crate) fn of<'c>(blocks: impl Iterator<Item = &'c str>) -> Self {
        let mut variables = Self::default();
        for declaration in blocks.flat_map(|block| text::parts(block, |b| b == b';')) {
            let declared = text::declared(declaration);
            let variable = declared.filter(|(name, value)| name.starts_with("--") && is_short(value));
            let has_room = variables.0.len() < MAX_VARIABLES;
            if let Some((name, value)) = variable.filter(|_| has_room) {
                variables.0.entry(name.to_owned()).or_insert_with(|| value.to_owned());
            }
        }
        (0..MAX_CHAIN).fold(variables, |variables, _| variables.resolved())
    }

    /// The same, with their values in the places where they stand for each other.
    fn resolved(self) -> Self {
        if !self.0.values().any(|value| value.contains("var(")) {
            return self;
        }
        let put_in = |value: &String| self.put_in(value).unwrap_or_default();
        Self(self.0.iter().map(|(name, value)| (name.clone(), put_in(value))).collect())
    }

    /// A value with its variables, or what stands behind those that there are not; `None` where it stays without, or is
    /// too long.
    pub(crate) fn put_in(&self, value: &str) -> Option<String> {
        let mut text = String::new();
        let mut rest = Some(value).filter(|value| is_short(value))?;
        while let Some(at) = rest.find("var(") {
            let (arguments, after) = enclosed(&rest[at + 3..])?;
            text.push_str(&rest[..at]);
            text.push_str(&self.value(arguments)?);
            rest = after;
        }
        text.push_str(rest);
        Some(text).filter(|text| is_short(text))
    }

    fn value(&self, arguments: &str) -> Option<String> {
        let (name, fallback) = match arguments.split_once(',') {
            Some((name, fallback)) => (name, Some(fallback.trim())),
            None => (arguments, None),
        };
        self.0.get(name.trim()).cloned().or_else(|| self.put_in(fallback?))
    }
}

fn is_short(value: &str) -> bool {
    let has_few_calls = || value.bytes().filter(|&byte| byte == b'(').count() <= MAX_CALLS;
    value.len() <= MAX_VALUE_BYTES && has_few_calls()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_stand_for_each_other_and_have_fallbacks() {
        let blocks = [
            "--a: red; --b: var(--a); fill: blue",
            "--a: green; --c: var(--d, f(var(--b), 1)); --e:var(--e)",
        ];
        let variables = Variables::of(blocks.into_iter());
        let put_in = |value| variables.put_in(value);
        assert_eq!(put_in("var( --a )").as_deref(), Some("red"));
        assert_eq!(put_in("1 var(--c) 2").as_deref(), Some("1 f(red, 1) 2"));
        assert_eq!(put_in("var(--x, var(--y, 3))").as_deref(), Some("3"));
        assert_eq!(put_in("var(--x)"), None);
        assert_eq!(put_in("var(--x"), None);
    }

    #[test]
    fn values_stay_short() {
        let doubling = "--a:1234567890;--b:var(--a)var(--a)var(--a);--c:var(--b)var(--b)var(--b);--d:var(--c)var(--c)var(--c)";
        let variables = Variables::of([doubling].into_iter());
        assert_eq!(variables.put_in("var(--c)").map(|value| value.len()), Some(90));
        assert_eq!(variables.put_in("var(--d)").unwrap_or_default(), "");
        assert_eq!(variables.put_in(&"x".repeat(300)), None);
    }
}

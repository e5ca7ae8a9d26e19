//! WGSL without comments, indentation and empty lines: every visitor of the page would load them.

/// The text of a file in `shaders/`, as far as devices read it.
macro_rules! wgsl {
    ($file:expr) => {{
        const FILE: &[u8] =
            include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shaders/", $file, ".wgsl"));
        const READ: [u8; $crate::wgsl::squeezed(FILE, &mut [])] = {
            let mut read = [0; $crate::wgsl::squeezed(FILE, &mut [])];
            $crate::wgsl::squeezed(FILE, &mut read);
            read
        };
        match std::str::from_utf8(&READ) {
            Ok(text) => text,
            Err(_) => panic!("a shader is UTF-8"),
        }
    }};
}

pub(crate) use wgsl;

/// Writes what is left of a text, as far as there is room; its length.
pub(crate) const fn squeezed(text: &[u8], room: &mut [u8]) -> usize {
    let (mut from, mut to) = (0, 0);
    while from < text.len() {
        let is_line_start = to == 0 || from > 0 && text[from - 1] == b'\n';
        from = skip(text, from, is_line_start);
        if from < text.len() {
            if to < room.len() {
                room[to] = text[from];
            }
            (from, to) = (from + 1, to + 1);
        }
    }
    to
}

/// The next place with something that is read.
const fn skip(text: &[u8], mut from: usize, is_line_start: bool) -> usize {
    while is_line_start && from < text.len() && (text[from] == b' ' || text[from] == b'\n') {
        from += 1;
    }
    let is_comment = from + 1 < text.len() && text[from] == b'/' && text[from + 1] == b'/';
    while is_comment && from < text.len() && text[from] != b'\n' {
        from += 1;
    }
    if is_comment && is_line_start { skip(text, from, true) } else { from }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn left(text: &str) -> String {
        let mut room = vec![0; squeezed(text.as_bytes(), &mut [])];
        squeezed(text.as_bytes(), &mut room);
        String::from_utf8(room).expect("text")
    }

    #[test]
    fn what_devices_read_is_left() {
        assert_eq!(
            left("// a\n//\n\nfn f() {\n    let a = 4 / b; // c\n\n    // d\n  }\n"),
            "fn f() {\nlet a = 4 / b; \n}\n"
        );
        assert_eq!(left("  // a"), "");
        assert_eq!(left("x"), "x");
    }
}

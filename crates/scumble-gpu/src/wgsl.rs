//! WGSL without comments, and with few spaces and lines: every visitor of the page would load them. Comments are
//! of one line.

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
    let (mut from, mut to) = (skip(text, 0), 0);
    while from < text.len() {
        to = written(text[from], room, to);
        let next = skip(text, from + 1);
        let after = if next < text.len() { text[next] } else { b'\n' };
        if next > from + 1
            && let Some(kept) = gap(text[from], text[next - 1], after)
        {
            to = written(kept, room, to);
        }
        from = next;
    }
    to
}

const fn written(byte: u8, room: &mut [u8], to: usize) -> usize {
    if to < room.len() {
        room[to] = byte;
    }
    to + 1
}

/// The next place with something that is read.
const fn skip(text: &[u8], mut from: usize) -> usize {
    let mut is_comment = false;
    while from < text.len() {
        is_comment |= text[from] == b'/' && from + 1 < text.len() && text[from + 1] == b'/';
        is_comment &= text[from] != b'\n';
        if !is_comment && text[from] != b' ' && text[from] != b'\n' {
            break;
        }
        from += 1;
    }
    from
}

/// What stays between two bytes with nothing but a gap between them: the end of a line before what is not indented, where programs
/// look for what is declared; and spaces without which two words, or two signs, would be one.
const fn gap(before: u8, space: u8, after: u8) -> Option<u8> {
    if space == b'\n' && after != b'}' {
        Some(b'\n')
    } else if is_of_word(before) && is_of_word(after) || is_of_sign(before) && is_of_sign(after) {
        Some(b' ')
    } else {
        None
    }
}

const fn is_of_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

const fn is_of_sign(byte: u8) -> bool {
    matches!(byte, b'+' | b'-' | b'*' | b'/' | b'<' | b'>' | b'=' | b'&' | b'|' | b'!')
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
            "fn f(){let a=4/b;}\n"
        );
        assert_eq!(
            left("const A = 1;\nlet b: vec2<f32> = a - -b\n    + c;\n"),
            "const A=1;\nlet b:vec2<f32> =a- -b+c;\n"
        );
        assert_eq!(
            left("fn f() {\n    return // a\n        x < -b;\n}\n\n// c\nfn g() {\n}\n"),
            "fn f(){return x< -b;}\nfn g(){}\n"
        );
        assert_eq!(left("  // a"), "");
        assert_eq!(left("x"), "x");
    }
}

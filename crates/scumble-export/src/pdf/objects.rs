//! The objects of a file, and the table that tells where they are.

use miniz_oxide::deflate::compress_to_vec_zlib;

/// How hard deflate tries, of 10.
const LEVEL: u8 = 8;

/// The four bytes above 127 tell programs that the file is not text.
const HEADER: &[u8] = b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n";

/// Objects that have been written, numbered from 1.
#[derive(Debug)]
pub(super) struct Objects {
    file: Vec<u8>,
    /// Where each begins.
    offsets: Vec<usize>,
}

impl Default for Objects {
    fn default() -> Self {
        Self { file: HEADER.to_vec(), offsets: Vec::new() }
    }
}

impl Objects {
    /// The number of the object that is added next.
    pub(super) fn next(&self) -> usize {
        self.offsets.len() + 1
    }

    /// Adds an object, given in parts, and gives its number.
    pub(super) fn add(&mut self, parts: &[&str]) -> usize {
        let number = self.begin();
        parts.iter().for_each(|part| self.push(part));
        self.push("\nendobj\n");
        number
    }

    /// Adds bytes, which are compressed, with entries of their own in the dictionary.
    pub(super) fn stream(&mut self, entries: &str, bytes: &[u8]) -> usize {
        let packed = compress_to_vec_zlib(bytes, LEVEL);
        let number = self.begin();
        for part in
            ["<<", entries, " /Filter /FlateDecode /Length ", &packed.len().to_string(), ">>\nstream\n"]
        {
            self.push(part);
        }
        self.file.extend(packed);
        self.push("\nendstream\nendobj\n");
        number
    }

    /// The file.
    pub(super) fn finish(mut self, catalog: usize) -> Vec<u8> {
        let (start, size) = (self.file.len().to_string(), self.next().to_string());
        self.push(&["xref\n0 ", &size, "\n0000000000 65535 f \n"].concat());
        for offset in std::mem::take(&mut self.offsets) {
            self.push(&format!("{offset:010} 00000 n \n"));
        }
        let root = reference(catalog);
        self.push(
            &["trailer\n<</Size ", &size, " /Root ", &root, ">>\nstartxref\n", &start, "\n%%EOF\n"].concat(),
        );
        self.file
    }

    fn begin(&mut self) -> usize {
        let number = self.next();
        self.offsets.push(self.file.len());
        self.push(&[&number.to_string(), " 0 obj\n"].concat());
        number
    }

    fn push(&mut self, text: &str) {
        self.file.extend_from_slice(text.as_bytes());
    }
}

/// How other objects name one.
pub(super) fn reference(number: usize) -> String {
    format!("{number} 0 R")
}

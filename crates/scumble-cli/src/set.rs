//! Quality sets: folders of drawings with scribbles, and the colours that a person would expect.

use std::path::{Path, PathBuf};

use anyhow::Context;
use scumble_core::{Drawing, Scribble};
use scumble_io::read_scribbles;
use serde::Deserialize;

use crate::files;

/// How many scribbles a drawing has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Kind {
    /// One scribble for each area of one colour.
    Sparse,
    /// One scribble for each piece that the drawn lines cut off.
    #[default]
    Dense,
}

impl Kind {
    /// As the user writes it, and as the file is named.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Sparse => "sparse",
            Self::Dense => "dense",
        }
    }
}

/// One drawing of a set.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// Name of its folder.
    pub(crate) id: String,
    folder: PathBuf,
}

#[derive(Deserialize)]
struct EntryText {
    id: String,
}

/// The drawings that the set's `index.json` lists, in its order.
///
/// # Errors
/// When the file cannot be read, is no such list, or lists nothing.
pub(crate) fn entries(set: &Path) -> anyhow::Result<Vec<Entry>> {
    let index = set.join("index.json");
    let texts: Vec<EntryText> = serde_json::from_slice(&files::read(&index)?)
        .with_context(|| format!("{} is no list of drawings", index.display()))?;
    anyhow::ensure!(!texts.is_empty(), "{} lists no drawing", index.display());
    for EntryText { id } in &texts {
        let is_name = Path::new(id).file_name() == Some(id.as_ref());
        anyhow::ensure!(is_name, "{} lists “{id}”, which is no name of a folder in the set", index.display());
    }
    Ok(texts.into_iter().map(|EntryText { id }| Entry { folder: set.join(&id), id }).collect())
}

impl Entry {
    /// A file that every drawing of a set has.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// The bytes of its `drawing.svg`.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub(crate) fn svg(&self) -> anyhow::Result<Vec<u8>> {
        files::read(&self.path("drawing.svg"))
    }

    /// Its scribbles, in drawing order.
    ///
    /// # Errors
    /// When the file cannot be read or has no scribble that can be used.
    pub(crate) fn scribbles(&self, kind: Kind, drawing: &Drawing) -> anyhow::Result<Vec<Scribble>> {
        let path = self.path(&format!("{}.json", kind.name()));
        let read = read_scribbles(&files::read(&path)?, drawing);
        Ok(read.with_context(|| format!("{}", path.display()))?.scribbles)
    }
}

//! The texts that one run has read, by number, so that a span can say which text it is in.

use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use super::Span;

/// The number of a text in [`Files`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileId(pub(crate) u32);

/// One text, under the name by which its author knows it.
#[derive(Debug, Clone)]
pub struct File {
    /// As the library or the command line names it.
    pub name: Arc<str>,
    /// All of it.
    pub text: Arc<str>,
    /// The file on disk that it was read from, without links; none of what came from elsewhere.
    pub path: Option<Arc<Path>>,
    line_starts: OnceLock<Arc<[u32]>>,
}

/// All the texts that a run has read.
#[derive(Debug, Clone, Default)]
pub struct Files {
    files: Vec<File>,
}

/// A place for a person: line and column from 1, the column in characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl Files {
    /// Takes a text in and numbers it.
    pub fn add(&mut self, name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> FileId {
        self.add_read(name, text, None)
    }

    /// As [`Files::add`], of a text that was read from the file at `path`, if it was.
    pub(crate) fn add_read(
        &mut self,
        name: impl Into<Arc<str>>,
        text: impl Into<Arc<str>>,
        path: Option<Arc<Path>>,
    ) -> FileId {
        let id = FileId(self.files.len() as u32);
        self.files.push(File { name: name.into(), text: text.into(), path, line_starts: OnceLock::new() });
        id
    }

    /// Puts another text in the place of the one numbered `id`.
    pub(crate) fn replace(&mut self, id: FileId, text: impl Into<Arc<str>>) {
        let file = &mut self.files[id.0 as usize];
        (file.text, file.line_starts) = (text.into(), OnceLock::new());
    }

    /// Takes all texts of `other` in; the number of each grows by what comes back.
    pub(crate) fn append(&mut self, other: &Self) -> u32 {
        let offset = self.files.len() as u32;
        self.files.extend(other.files.iter().cloned());
        offset
    }

    /// The text numbered `id`.
    pub fn get(&self, id: FileId) -> &File {
        &self.files[id.0 as usize]
    }

    /// The files on disk that texts were read from.
    pub(crate) fn on_disk(&self) -> Vec<PathBuf> {
        self.files.iter().filter_map(|file| file.path.as_deref()).map(Path::to_owned).collect()
    }

    /// Every text, in the order they were read.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &File)> {
        self.files.iter().enumerate().map(|(index, file)| (FileId(index as u32), file))
    }
}

impl File {
    /// Where each line starts.
    pub fn line_starts(&self) -> &[u32] {
        self.line_starts.get_or_init(|| {
            let breaks = self.text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
            std::iter::once(0).chain(breaks.map(|(at, _)| at as u32 + 1)).collect()
        })
    }

    /// The line (from 0) that byte `offset` is on.
    pub fn line_of(&self, offset: usize) -> usize {
        self.line_starts().partition_point(|start| *start as usize <= offset) - 1
    }

    /// Line and column of byte `offset`; an offset inside a character counts as its start.
    pub fn place(&self, offset: usize) -> Place {
        let offset = self.text.floor_char_boundary(offset);
        let line = self.line_of(offset);
        let start = self.line_starts()[line] as usize;
        Place { line: line + 1, column: self.text[start..offset].chars().count() + 1 }
    }

    /// The text under `span`.
    pub fn slice(&self, span: Span) -> &str {
        &self.text[span.range()]
    }
}

impl<'a> codespan_reporting::files::Files<'a> for Files {
    type FileId = FileId;
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, id: FileId) -> Result<&'a str, codespan_reporting::files::Error> {
        self.files
            .get(id.0 as usize)
            .map(|file| &*file.name)
            .ok_or(codespan_reporting::files::Error::FileMissing)
    }

    fn source(&'a self, id: FileId) -> Result<&'a str, codespan_reporting::files::Error> {
        self.files
            .get(id.0 as usize)
            .map(|file| &*file.text)
            .ok_or(codespan_reporting::files::Error::FileMissing)
    }

    fn line_index(&'a self, id: FileId, offset: usize) -> Result<usize, codespan_reporting::files::Error> {
        Ok(self.get(id).line_of(offset))
    }

    fn line_range(
        &'a self,
        id: FileId,
        line: usize,
    ) -> Result<std::ops::Range<usize>, codespan_reporting::files::Error> {
        let file = self.get(id);
        let starts = file.line_starts();
        let start = *starts
            .get(line)
            .ok_or(codespan_reporting::files::Error::LineTooLarge { given: line, max: starts.len() - 1 })?
            as usize;
        let end = starts.get(line + 1).map_or(file.text.len(), |end| *end as usize);
        Ok(start..end)
    }
}

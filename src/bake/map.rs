//! From the result back to the authors' files, byte by byte.

use crate::source::{FileId, Span};

/// A stretch of the result and where it is from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Segment {
    /// The stretch of the result.
    pub out: Span,
    /// The file that it is from.
    pub file: FileId,
    /// Where in that file. Of the same length for copied text; otherwise the whole of it stands for the whole stretch.
    pub from: Span,
    /// Whether the text is the author's own.
    pub copied: bool,
    /// The instance that it is part of; none for parameters.
    pub instance: Option<u32>,
}

/// Where every byte of a result is from.
#[derive(Debug, Clone, Default)]
pub struct SourceMap {
    segments: Vec<Segment>,
}

/// A place in an author's file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Origin {
    /// The file.
    pub file: FileId,
    /// Where in it.
    pub span: Span,
    /// The instance that was reached; none for parameters.
    pub instance: Option<u32>,
}

impl SourceMap {
    /// Adds a stretch behind all others.
    pub(crate) fn push(&mut self, segment: Segment) {
        if !segment.out.is_empty() {
            self.segments.push(segment);
        }
    }

    /// All stretches, in the order of the result. Between them lies what no author wrote.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Where the stretch `out` of the result is from. What spans several files comes back cut to the first; what no
    /// author wrote, as the end of what came before it.
    pub fn origin(&self, out: Span) -> Option<Origin> {
        let after = self.segments.partition_point(|segment| segment.out.start <= out.start);
        let first = self.segments.get(after.checked_sub(1)?)?;
        if out.start >= first.out.end {
            let end = Span { start: first.from.end, end: first.from.end };
            return Some(Origin { file: first.file, span: end, instance: first.instance });
        }
        let inside = if first.copied { out.start - first.out.start } else { 0 };
        let start = first.from.start + inside;
        let last_byte = out.end.max(out.start + 1) - 1;
        let last = self.segments.partition_point(|segment| segment.out.start <= last_byte);
        let last = self.segments.get(last.saturating_sub(1)).filter(|last| {
            last.file == first.file && last.instance == first.instance && last_byte < last.out.end
        });
        let end = match last {
            Some(last) if last.copied => last.from.start + (out.end.max(last.out.start) - last.out.start),
            Some(last) => last.from.end,
            None => first.from.end,
        };
        let span = Span { start, end: if end < start { first.from.end } else { end } };
        Some(Origin { file: first.file, span, instance: first.instance })
    }
}

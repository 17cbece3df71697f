//! `docs/benchmarks.md`: sections that parts of the suite write, each replacing the one of the same title.

use std::fmt::Write as _;
use std::path::Path;

use crate::Outcome;

/// One part's findings.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    pub(crate) text: String,
}

/// A Markdown table; all columns but the first are numbers.
pub(crate) fn table<const N: usize>(head: [&str; N], rows: &[[String; N]]) -> String {
    let line = |cells: &[&str]| format!("| {} |\n", cells.join(" | "));
    let ruler: Vec<&str> = (0..N).map(|column| if column == 0 { "---" } else { "---:" }).collect();
    let mut text = line(&head) + &line(&ruler);
    for row in rows {
        text += &line(&row.each_ref().map(String::as_str));
    }
    text
}

/// Writes `measured` into the page at `path`, under `head`; all other sections stay as they are.
pub(crate) fn write(path: &Path, head: &str, order: &[&str], measured: &Section) -> Outcome {
    let old = std::fs::read_to_string(path).unwrap_or_default(); // there may be none yet
    let mut page = head.trim_end().to_owned() + "\n";
    for title in order {
        let new = (measured.title == *title).then_some(measured.text.as_str());
        if let Some(text) = new.or_else(|| part_of(&old, title)) {
            let _ = write!(page, "\n## {title}\n\n{}\n", text.trim());
        }
    }
    std::fs::write(path, page)?;
    Ok(())
}

/// The text under the heading `title`.
fn part_of<'a>(page: &'a str, title: &str) -> Option<&'a str> {
    let heading = format!("\n## {title}\n");
    let from = page.find(&heading)? + heading.len();
    let rest = page.get(from..)?;
    Some(rest.find("\n## ").map_or(rest, |end| &rest[..end]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_that_was_not_measured_anew_stays() {
        let page = "# Head\n\n## One\n\nold one\n\n## Two\n\n| old two |\n";
        assert_eq!(part_of(page, "One").map(str::trim), Some("old one"));
        assert_eq!(part_of(page, "Two").map(str::trim), Some("| old two |"));
        assert_eq!(part_of(page, "Three"), None);
    }

    #[test]
    fn a_table_has_a_ruler_under_its_head() {
        let made = table(["what", "ms"], &[["a".to_owned(), "1".to_owned()]]);
        assert_eq!(made, "| what | ms |\n| --- | ---: |\n| a | 1 |\n");
    }
}

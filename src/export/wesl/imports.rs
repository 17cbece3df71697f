//! Which names a module declares and uses, and the `import` lines that follow from them.

use rustc_hash::FxHashSet;

use crate::syntax::{DeclarationKind, parse_fragment, split};

/// How wide a line of imports gets, if its names let it.
const WIDTH: usize = 110;

/// The names of a module's scope.
#[derive(Default)]
pub(super) struct Names {
    /// What it declares.
    pub(super) declared: Vec<String>,
    /// What it uses, its own declarations among them; each once.
    pub(super) used: Vec<String>,
    /// It has `enable`, `requires` or `diagnostic` of its own.
    pub(super) has_directives: bool,
    /// It has a `const_assert`.
    pub(super) asserts: bool,
}

/// The names in `text`, which has no directive of ours left.
pub(super) fn names(text: &str) -> Names {
    use DeclarationKind as D;
    let module = split(&parse_fragment(text.into()), &[]);
    let mut names = Names::default();
    for declaration in &module.declarations {
        names.has_directives |= matches!(declaration.kind, D::Enable | D::Requires | D::Diagnostic);
        names.asserts |= declaration.kind == D::ConstAssert;
        names.declared.extend(declaration.name.map(|(symbol, _)| module.name(text, symbol).to_owned()));
    }
    let mut seen = FxHashSet::default();
    for reference in &module.references {
        if seen.insert(reference.symbol) {
            names.used.push(module.name(text, reference.symbol).to_owned());
        }
    }
    names
}

/// `import super::medium::{AIR_HEIGHT, air_density};`
pub(super) fn line(path: &str, mut names: Vec<&str>) -> String {
    names.sort_unstable();
    if let [name] = names[..] {
        return format!("import {path}::{name};");
    }
    let short = format!("import {path}::{{{}}};", names.join(", "));
    if short.chars().count() <= WIDTH {
        return short;
    }
    let mut text = format!("import {path}::{{\n");
    let mut width = 0;
    for name in names {
        if width > 0 && width + 1 + name.len() + 1 > WIDTH {
            text.push('\n');
            width = 0;
        }
        let before = if width == 0 { "    " } else { " " };
        width += before.len() + name.len() + 1;
        text = text + before + name + ",";
    }
    text + "\n};"
}

/// `text` with `lines` where imports stand: behind the comment at the top, before everything else.
pub(super) fn with_imports(text: &str, lines: &[String]) -> String {
    let text = text.trim_start_matches(['\n', '\r']);
    let mut head = 0;
    for line in text.split_inclusive('\n') {
        if !line.starts_with("//") {
            let is_set_off = line.trim().is_empty();
            head = if is_set_off { head } else { 0 };
            break;
        }
        head += line.len();
    }
    let (comment, rest) = text.split_at(head);
    let rest = rest.trim_start_matches(['\n', '\r']);
    let mut blocks = vec![comment.trim_end().to_owned(), lines.join("\n"), rest.trim_end().to_owned()];
    blocks.retain(|block| !block.is_empty());
    blocks.join("\n\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_stand_behind_the_comment_at_the_top() {
        let lines = ["import super::b::f;".to_owned()];
        assert_eq!(
            with_imports("// What it is.\n\n/// One.\nfn one() {}\n", &lines),
            "// What it is.\n\nimport super::b::f;\n\n/// One.\nfn one() {}\n"
        );
        let documented = "/// One.\nfn one() {}\n";
        assert_eq!(with_imports(documented, &lines), format!("import super::b::f;\n\n{documented}"));
        assert_eq!(with_imports(documented, &[]), documented);
    }

    #[test]
    fn locals_are_not_imported() {
        let names = names("fn f(a: f32) -> f32 { let g = h(a); return g * C; }");
        assert_eq!(names.declared, ["f"]);
        assert_eq!(names.used, ["f", "f32", "h", "C"]);
    }

    #[test]
    fn many_names_take_several_lines() {
        let long = "a".repeat(60);
        let text = line("super::m", vec![&long, "b", &long]);
        assert_eq!(text, format!("import super::m::{{\n    {long},\n    {long}, b,\n}};"));
    }
}

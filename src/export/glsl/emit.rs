//! A WGSL text → the same program in GLSL ES 3.00, as its author wrote it.

use rustc_hash::{FxHashMap, FxHashSet};

use super::helpers::Helpers;
use super::names::Names;
use super::order::{Step, order, reached};
use super::values;
use super::write::{Refusal, Writer, Written};
use crate::export::typed::{
    Decl, DeclKind, ExprKind, Meaning, Statement, StatementKind, Tok, Ty, Typed, parse, type_check,
};
use crate::syntax::{TokenKind, is_line_break};

/// What is to be written, and into what it goes.
pub(super) struct Request<'a> {
    /// The whole text: places in it are told in errors.
    pub(super) text: &'a str,
    /// Where what is written starts, past the text's own header.
    pub(super) start: usize,
    /// Where the first module starts: helpers come before it.
    pub(super) modules: usize,
    /// naga's module of the text.
    pub(super) module: &'a naga::Module,
    /// The fragment entry point.
    pub(super) entry: &'a str,
    /// Whether the entry point does no more than call a scene's picture: it is left out then.
    pub(super) is_scene: bool,
    /// Names that what surrounds the file keeps for itself.
    pub(super) reserved: &'a [&'a str],
    /// What is written for a variable of the module, by its name.
    pub(super) instead: FxHashMap<String, String>,
    /// Whether y grows upward here and downward in WGSL.
    pub(super) flipped: bool,
    /// Where in the text the scene's own fragment stands.
    pub(super) scene: std::ops::Range<usize>,
}

/// What was written.
#[derive(Debug)]
pub(super) struct Emitted {
    /// All but the function that the file's host calls.
    pub(super) text: String,
    /// Every name that is spelled otherwise than its author did, with its new spelling.
    pub(super) renamed: Vec<(String, String)>,
    /// The function that gives the picture, by its name in the file.
    pub(super) function: String,
    /// What the entry point takes and gives.
    pub(super) interface: super::entry::Interface,
    /// What is written for the variables of `instead` that are read.
    pub(super) read: Vec<String>,
    /// The text in pieces, in its order.
    pub(super) pieces: Vec<Piece>,
}

/// A declaration with what stands above it, helpers, or the like.
#[derive(Debug)]
pub(super) struct Piece {
    /// Where it ends in the text; it begins where the one before it ends.
    pub(super) end: usize,
    /// Whether it is of the scene, reads what only the host's own function may, or calls what does.
    pub(super) of_image: bool,
}

/// Writes what `request` asks for.
pub(super) fn emit(request: &Request<'_>) -> Written<Emitted> {
    let mut typed = type_check(parse(request.text)?)?;
    let types = std::mem::take(&mut typed.types);
    let Some(entry) = typed.by_name.get(request.entry).copied() else {
        return Err(Refusal { what: "this entry point".into(), span: crate::source::Span::new(0, 0) });
    };
    let picture = if request.is_scene { only_calls(&typed, entry) } else { None };
    let mut wanted = reached(&typed, entry);
    if picture.is_some() {
        wanted[entry as usize] = false;
    }
    let mut instead = FxHashMap::default();
    let mut read = Vec::new();
    for (index, decl) in typed.tree.declarations.iter().enumerate() {
        let word = typed.tree.word(decl.name);
        if let (DeclKind::Var { .. }, Some(text)) = (&decl.kind, request.instead.get(word)) {
            if wanted[index] {
                read.push(text.clone());
            }
            instead.insert(index as u32, text.clone());
            wanted[index] = false;
        }
    }
    let steps = order(&typed, &wanted);
    let of_image = of_image(&typed, &instead, &request.scene);
    let mut pieces = Vec::new();
    let mut writer = Writer {
        names: Names::new(declared(&typed).into_iter(), request.reserved),
        typed: &typed,
        types,
        out: String::with_capacity(request.text.len() + request.text.len() / 8),
        cursor: 0,
        helpers: Helpers::default(),
        own_names: FxHashMap::default(),
        places: FxHashMap::default(),
        roots: FxHashMap::default(),
        later: Vec::new(),
        as_place: false,
        stray: stray(&typed),
        instead,
        values: values::of(request.module, &typed),
        loops: Vec::new(),
        again: Vec::new(),
        rows: Vec::new(),
        result: Ty::Nothing,
        flipped: request.flipped,
    };
    let ends = ends(&typed);
    let start = (0..typed.tree.tokens.len())
        .find(|tok| typed.tree.tokens.span(*tok).start as usize >= request.start)
        .unwrap_or(0) as Tok;
    let before = |index: u32| match index.checked_sub(1) {
        Some(previous) => ends[previous as usize].max(start),
        None => start,
    };
    let mut helpers_at = None;
    for step in steps {
        let (index, end) = match step {
            Step::Write { index, .. } | Step::Rest(index) => (index, ends[index as usize]),
            Step::Announce(index) => (index, 0),
        };
        let decl = &typed.tree.declarations[index as usize];
        let from = before(index);
        let in_modules = typed.tree.tokens.span(decl.first as usize).start as usize >= request.modules;
        let in_turn = matches!(step, Step::Write { in_turn: true, .. } | Step::Rest(_));
        if in_turn && in_modules && helpers_at.is_none() {
            helpers_at = Some(pieces.len());
        }
        match step {
            Step::Announce(index) => {
                let text = writer.prototype(index)?;
                writer.put("\n");
                writer.put(text.trim_end());
            }
            Step::Rest(index) => {
                // A scene's entry point is no part of the file, nor are variables that the host has.
                let is_gone = writer.instead.contains_key(&index) || picture.is_some() && index == entry;
                if !is_gone {
                    writer.cursor = from;
                    writer.upto(own_comments(&typed, from, decl));
                }
            }
            Step::Write { index, in_turn } => {
                writer.cursor = if in_turn { from } else { own_comments(&typed, from, decl) };
                if !in_turn {
                    writer.put("\n\n");
                }
                writer.declaration(index)?;
                writer.upto(end);
            }
        }
        pieces.push(Piece { end: writer.out.len(), of_image: of_image[index as usize] });
    }
    writer.cursor = ends.last().copied().unwrap_or(start).max(start);
    let rest = typed.tree.tokens.len() as Tok;
    writer.upto(rest);
    let helpers = writer.preamble()?;
    pieces.push(Piece { end: writer.out.len(), of_image: true });
    if !helpers.is_empty() {
        let index = helpers_at.unwrap_or(0);
        let at = index.checked_sub(1).map_or(0, |before| pieces[before].end);
        let text = format!("\n\n// ---- what WGSL has and GLSL ES 3.00 lacks ----\n\n{}", helpers.trim_end());
        writer.out.insert_str(at, &text);
        pieces.insert(index, Piece { end: at, of_image: false });
        pieces[index..].iter_mut().for_each(|piece| piece.end += text.len());
    }
    let picture = picture.unwrap_or(entry);
    let interface = super::entry::interface(&mut writer, entry)?;
    Ok(Emitted {
        function: writer.global_name(picture),
        text: writer.out,
        renamed: writer.names.changes(),
        interface,
        read,
        pieces,
    })
}

impl Writer<'_, '_> {
    /// What comes before the first module: functions that WGSL has, and structs around arrays in arrays.
    fn preamble(&mut self) -> Written<String> {
        let mut text = String::new();
        for (ty, name) in self.rows.clone() {
            let mut inner = ty;
            while let Ty::Array(index) = inner {
                inner = self.types.of_array(index).0;
            }
            let span = crate::source::Span::new(0, 0);
            if inner.scalar().is_none() {
                return self.refuse("an array of arrays of structs", span);
            }
            text.push_str(&format!("struct {name} {{\n    {} row;\n}};\n", self.type_of(ty, span)?));
        }
        text.push_str(&self.helpers.text());
        Ok(text)
    }
}

/// All names that the text declares.
fn declared<'a>(typed: &Typed<'a>) -> Vec<&'a str> {
    let mut names: Vec<&str> = typed.by_name.keys().copied().collect();
    names.extend(typed.locals.iter().map(|local| typed.tree.word(local.name)));
    for decl in &typed.tree.declarations {
        if let DeclKind::Struct { members, .. } = &decl.kind {
            names.extend(members.iter().map(|member| typed.tree.word(member.name)));
        }
    }
    names
}

/// Of each declaration, the first token behind it and what stands on the rest of its line.
fn ends(typed: &Typed<'_>) -> Vec<Tok> {
    let tree = &typed.tree;
    let rest_of_line = |decl: &Decl| {
        let mut end = decl.last + 1;
        let mut next = end;
        while (next as usize) < tree.tokens.len() && tree.kind(next).is_trivia() {
            if tree.word(next).contains(is_line_break) {
                break;
            }
            next += 1;
            if tree.kind(next - 1) != TokenKind::Blank {
                end = next; // blank space before a line break stays with what follows
            }
        }
        end
    };
    tree.declarations.iter().map(rest_of_line).collect()
}

/// Semicolons between declarations.
fn stray(typed: &Typed<'_>) -> FxHashSet<Tok> {
    let tree = &typed.tree;
    let mut stray = FxHashSet::default();
    let mut from = 0;
    for decl in
        tree.declarations.iter().map(|decl| (decl.first, decl.last)).chain([(tree.tokens.len() as Tok, 0)])
    {
        stray.extend((from..decl.0).filter(|tok| tree.kind(*tok) == TokenKind::Semicolon));
        from = decl.1 + 1;
    }
    stray
}

/// Where the comments that belong to `decl` start: past the last empty line before it.
fn own_comments(typed: &Typed<'_>, from: Tok, decl: &Decl) -> Tok {
    let tree = &typed.tree;
    let is_empty_line = |tok: &Tok| {
        tree.kind(*tok) == TokenKind::Blank && tree.word(*tok).chars().filter(|c| *c == '\n').count() > 1
    };
    (from..decl.first).rev().find(is_empty_line).map_or(from, |tok| tok + 1).min(decl.first)
}

/// The function that `entry` calls with its position and whose value it returns, if it does nothing else.
fn only_calls(typed: &Typed<'_>, entry: u32) -> Option<u32> {
    let DeclKind::Function(function) = &typed.tree.declarations[entry as usize].kind else { return None };
    let [Statement { kind: StatementKind::Return(Some(value)), .. }] = function.body.statements.as_slice()
    else {
        return None;
    };
    let ExprKind::Call { callee, arguments } = &typed.tree.expr(*value).kind else { return None };
    let [argument] = arguments.as_slice() else { return None };
    let ExprKind::Member { base, name } = typed.tree.expr(*argument).kind else { return None };
    let is_parameter = matches!(typed.meaning(base), Meaning::Local(_)) && typed.tree.word(name) == "xy";
    match typed.meaning(*callee) {
        Meaning::Global(index) if is_parameter => Some(index),
        _ => None,
    }
}

/// Of each declaration, whether it belongs beside the function that the host calls.
fn of_image(
    typed: &Typed<'_>,
    instead: &FxHashMap<u32, String>,
    scene: &std::ops::Range<usize>,
) -> Vec<bool> {
    let stands_in_scene =
        |decl: &Decl| scene.contains(&(typed.tree.tokens.span(decl.first as usize).start as usize));
    let mut of_image: Vec<bool> = typed.tree.declarations.iter().map(stands_in_scene).collect();
    loop {
        let mut changed = false;
        for (index, references) in typed.references.iter().enumerate() {
            let needs = references.iter().any(|one| instead.contains_key(one) || of_image[*one as usize]);
            changed |= needs && !of_image[index];
            of_image[index] |= needs;
        }
        if !changed {
            return of_image;
        }
    }
}

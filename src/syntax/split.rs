//! The split of a decided file into top-level declarations, with the names that each refers to.
//!
//! [`Fragment`] and the truth of its conditions → [`Module`]: every byte that is in belongs to exactly one
//! [`Declaration`] (its comments above it and the rest of its line included), or to the file's head or tail. Names are
//! resolved as far as one file can tell: local variables and function parameters are kept apart from module-scope names
//! by following WGSL's scopes through the tokens.

use rustc_hash::FxHashMap;

use super::declaration::{Declaration, DeclarationKind, Module, Reference, Stage, Symbol};
use super::directive::DirectiveError;
use super::fragment::{Branches, Fragment, after_line_break};
use super::lexer::is_line_break;
use super::token::TokenKind;
use crate::source::Span;

/// Splits `fragment` into declarations, with its conditions decided by `truth`.
pub fn split(fragment: &Fragment, truth: &[bool]) -> Module {
    let mut splitter = Splitter {
        text: &fragment.text,
        module: Module::default(),
        symbols: FxHashMap::default(),
        visible: Vec::new(),
        piece_start: 0,
        first_piece: 0,
        doing: None,
        previous: TokenKind::Semicolon,
        close_at_line_end: false,
        after_blank_line: true,
    };
    let mut branches = Branches::default();
    let mut directives = fragment.directives.iter().peekable();
    for (index, (kind, span)) in fragment.take_tokens().iter().enumerate() {
        if kind == TokenKind::Directive {
            let Some(placed) = directives.next_if(|placed| placed.token == index) else { continue };
            let before = branches.active();
            let is_condition = branches.pass(placed, truth);
            match (before, branches.active()) {
                (true, true) => {
                    if !is_condition && splitter.doing.is_some() {
                        let name = placed.directive.kind.name();
                        let span = placed.directive.span;
                        splitter.module.errors.push(DirectiveError::Inside { name, span });
                    }
                    splitter.cut(placed.removed);
                }
                (true, false) => splitter.cut_open(placed.removed.start),
                (false, true) => splitter.piece_start = placed.removed.end,
                (false, false) => {}
            }
        } else if branches.active() {
            splitter.token(kind, span);
        }
    }
    if !branches.active() {
        splitter.piece_start = fragment.text.len() as u32;
    }
    splitter.finish(fragment.text.len() as u32)
}

/// The declaration that is being read.
struct Doing {
    kind: DeclarationKind,
    name: Option<(Symbol, Span)>,
    stage: Option<Stage>,
    span: Span,
    references: usize,
    locals: usize,
    braces: u32,
    /// `(` and `[`
    round: u32,
    templates: u32,
    /// The keyword is past.
    begun: bool,
    /// A function's header, or a struct's inside, where names with a `:` are declared.
    members: bool,
    /// The next identifier is a name that is being declared: of the declaration itself, a member, a variable.
    naming: Naming,
    attribute: Attribute,
    /// A variable whose statement has not ended: its name is visible only after it.
    pending: Option<(Symbol, u32, u32)>,
    scopes: Vec<Scope>,
    /// Names visible now, innermost last.
    open: Vec<Symbol>,
    /// The `<…>` of a `var`: its words are no names.
    skip_template: bool,
    /// The reference that the last token was.
    fresh: Option<usize>,
    /// The reference that the last token, a dot, follows.
    dotted: Option<usize>,
}

#[derive(PartialEq)]
enum Naming {
    No,
    Own,
    Member,
    Local,
}

#[derive(PartialEq)]
enum Attribute {
    No,
    /// Its name comes next.
    Name,
    /// The name has come: brackets may.
    Opens {
        named_words: bool,
    },
    /// Inside its brackets, `round` deep.
    Inside {
        round: u32,
        named_words: bool,
    },
}

struct Scope {
    /// How many names were visible when it opened.
    open: usize,
    /// A `for`: how deep its brackets were, until its body opens.
    header: Option<u32>,
    /// The body of a `for`: the header's scope ends with it.
    body: bool,
}

struct Splitter<'a> {
    text: &'a str,
    module: Module,
    symbols: FxHashMap<&'a str, Symbol>,
    /// For each symbol, how many open scopes of the current function declare it.
    visible: Vec<u32>,
    piece_start: u32,
    first_piece: usize,
    doing: Option<Doing>,
    previous: TokenKind,
    /// A declaration is complete; the rest of its line still belongs to it.
    close_at_line_end: bool,
    /// Where text was last cut, there was a blank line (or nothing) before.
    after_blank_line: bool,
}

impl<'a> Splitter<'a> {
    fn symbol(&mut self, span: Span) -> Symbol {
        let next = self.module.names.len() as Symbol;
        let symbol = *self.symbols.entry(&self.text[span.range()]).or_insert(next);
        if symbol == next {
            self.module.names.push(span);
            self.visible.push(0);
        }
        symbol
    }

    fn cut_open(&mut self, at: u32) {
        if self.close_at_line_end && at >= self.piece_start {
            self.end_chunk(at);
        }
        self.keep_until(at);
        self.piece_start = at;
    }

    fn keep_until(&mut self, at: u32) {
        if at > self.piece_start {
            let piece = Span { start: self.piece_start, end: at };
            self.after_blank_line = ends_with_blank_line(&self.text[piece.range()]);
            self.module.pieces.push(piece);
        }
    }

    /// Takes `removed` out, and with it a blank line that would be left over.
    fn cut(&mut self, removed: Span) {
        let text_since = removed.start > self.piece_start;
        self.cut_open(removed.start);
        if self.doing.is_some() {
            self.piece_start = removed.end;
            return;
        }
        if text_since && self.module.declarations.is_empty() && self.module.head.is_empty() {
            self.end_head();
        }
        let mut end = removed.end as usize;
        if self.after_blank_line {
            let rest = &self.text[end..];
            let blank = rest.len() - rest.trim_start_matches([' ', '\t']).len();
            let after = after_line_break(self.text, end + blank);
            if after > end + blank {
                end = after;
            }
        }
        self.piece_start = end as u32;
    }

    /// What has come so far is the file's head.
    fn end_head(&mut self) {
        self.module.head = 0..self.module.pieces.len();
        self.first_piece = self.module.pieces.len();
    }

    fn end_chunk(&mut self, at: u32) {
        self.keep_until(at);
        self.piece_start = at;
        let pieces = self.first_piece..self.module.pieces.len();
        self.first_piece = pieces.end;
        if let Some(last) = self.module.declarations.last_mut() {
            last.pieces = pieces;
        }
        self.close_at_line_end = false;
    }

    fn token(&mut self, kind: TokenKind, span: Span) {
        if kind.is_trivia() {
            return self.trivia(kind, span);
        }
        if self.close_at_line_end {
            if kind == TokenKind::Semicolon && self.doing.is_none() {
                return; // `struct S { … };`
            }
            self.end_chunk(span.start);
        }
        if self.doing.is_none() {
            if kind == TokenKind::Semicolon {
                return;
            }
            self.begin(span);
        }
        let Some(mut doing) = self.doing.take() else { return };
        doing.span.end = span.end;
        let done = self.advance(&mut doing, kind, span);
        self.previous = kind;
        if done { self.complete(doing) } else { self.doing = Some(doing) }
    }

    fn trivia(&mut self, kind: TokenKind, span: Span) {
        if kind != TokenKind::Blank {
            return;
        }
        let piece = &self.text[span.range()];
        if self.close_at_line_end
            && let Some(at) = piece.find(is_line_break)
        {
            self.end_chunk(after_line_break(self.text, span.start as usize + at) as u32);
        }
        // The comment at the top of the file, set off by a blank line.
        if self.doing.is_none()
            && self.module.declarations.is_empty()
            && self.module.head.is_empty()
            && self.module.pieces.is_empty()
            && span.start > 0
            && ends_with_blank_line(&self.text[..span.end as usize])
        {
            self.cut_open(span.end);
            self.end_head();
        }
    }

    fn begin(&mut self, span: Span) {
        self.previous = TokenKind::Semicolon;
        self.doing = Some(Doing {
            kind: DeclarationKind::Other,
            name: None,
            stage: None,
            span,
            references: self.module.references.len(),
            locals: self.module.locals.len(),
            braces: 0,
            round: 0,
            templates: 0,
            begun: false,
            members: false,
            naming: Naming::No,
            attribute: Attribute::No,
            pending: None,
            scopes: Vec::new(),
            open: Vec::new(),
            skip_template: false,
            fresh: None,
            dotted: None,
        });
    }

    fn complete(&mut self, doing: Doing) {
        for symbol in doing.open {
            self.visible[symbol as usize] -= 1;
        }
        self.module.declarations.push(Declaration {
            kind: doing.kind,
            name: doing.name,
            stage: doing.stage,
            span: doing.span,
            pieces: 0..0, // known when its line ends
            references: doing.references..self.module.references.len(),
            locals: doing.locals..self.module.locals.len(),
        });
        self.close_at_line_end = true;
    }

    fn finish(mut self, end: u32) -> Module {
        if let Some(doing) = self.doing.take() {
            self.complete(doing);
        }
        if self.close_at_line_end {
            self.end_chunk(end);
        }
        self.keep_until(end);
        self.module.tail = self.first_piece..self.module.pieces.len();
        let module = &mut self.module; // it is kept
        module.declarations.shrink_to_fit();
        module.references.shrink_to_fit();
        module.pieces.shrink_to_fit();
        module.locals.shrink_to_fit();
        module.names.shrink_to_fit();
        self.module
    }

    /// Takes one token into the declaration; true when it is the last one.
    fn advance(&mut self, doing: &mut Doing, kind: TokenKind, span: Span) -> bool {
        use TokenKind as K;
        let fresh = doing.fresh.take();
        if kind != K::Ident {
            doing.dotted = fresh.filter(|_| kind == K::Dot);
        }
        match kind {
            K::Ident => self.ident(doing, span),
            K::At => doing.attribute = Attribute::Name,
            K::ParenOpen | K::BracketOpen => {
                doing.round += 1;
                if let Attribute::Opens { named_words } = doing.attribute {
                    doing.attribute = Attribute::Inside { round: doing.round, named_words };
                } else if doing.kind == DeclarationKind::Function && doing.braces == 0 && doing.round == 1 {
                    doing.members = true;
                    doing.naming = Naming::Member;
                }
            }
            K::ParenClose | K::BracketClose => {
                if matches!(doing.attribute, Attribute::Inside { round, .. } if round == doing.round) {
                    doing.attribute = Attribute::No;
                } else if doing.members && doing.kind == DeclarationKind::Function && doing.round == 1 {
                    doing.members = false;
                    doing.naming = Naming::No;
                }
                doing.round = doing.round.saturating_sub(1);
            }
            K::TemplateOpen => doing.templates += 1,
            K::TemplateClose => {
                doing.templates = doing.templates.saturating_sub(1);
                doing.skip_template &= doing.templates > 0;
            }
            K::Comma => {
                let inside = matches!(doing.attribute, Attribute::Inside { .. });
                let level = u32::from(doing.kind == DeclarationKind::Function);
                if doing.members && !inside && doing.templates == 0 && doing.round == level {
                    doing.naming = Naming::Member;
                }
            }
            K::Colon if doing.naming == Naming::Member => doing.naming = Naming::No,
            K::BraceOpen => {
                doing.braces += 1;
                if doing.kind == DeclarationKind::Struct && doing.braces == 1 {
                    doing.members = true;
                    doing.naming = Naming::Member;
                }
                if doing.kind == DeclarationKind::Function {
                    self.open_scope(doing);
                }
            }
            K::BraceClose => {
                doing.braces = doing.braces.saturating_sub(1);
                if doing.kind == DeclarationKind::Function {
                    self.close_scope(doing);
                }
                return doing.braces == 0;
            }
            K::Semicolon => {
                if let Some((symbol, braces, round)) = doing.pending
                    && braces == doing.braces
                    && round == doing.round
                {
                    self.show(doing, symbol);
                    doing.pending = None;
                }
                return doing.braces == 0 && doing.round == 0;
            }
            _ => {}
        }
        if let Attribute::Opens { .. } = doing.attribute
            && kind != K::Ident
            && kind != K::At
        {
            doing.attribute = Attribute::No; // an attribute without brackets
        }
        false
    }

    fn show(&mut self, doing: &mut Doing, symbol: Symbol) {
        doing.open.push(symbol);
        self.visible[symbol as usize] += 1;
    }

    fn open_scope(&mut self, doing: &mut Doing) {
        let mut body = false;
        if let Some(scope) = doing.scopes.last_mut()
            && scope.header == Some(doing.round)
        {
            scope.header = None;
            body = true;
        }
        doing.scopes.push(Scope { open: doing.open.len(), header: None, body });
        if doing.braces == 1 {
            for index in doing.locals..self.module.locals.len() {
                let symbol = self.module.locals[index].0;
                self.show(doing, symbol); // the parameters
            }
        }
    }

    fn close_scope(&mut self, doing: &mut Doing) {
        let Some(scope) = doing.scopes.pop() else { return };
        let mut keep = scope.open;
        if scope.body
            && let Some(header) = doing.scopes.pop()
        {
            keep = header.open;
        }
        for symbol in doing.open.drain(keep.min(doing.open.len())..) {
            self.visible[symbol as usize] -= 1;
        }
        doing.pending = None;
    }

    fn ident(&mut self, doing: &mut Doing, span: Span) {
        let text = &self.text[span.range()];
        match doing.attribute {
            Attribute::Name => {
                doing.stage = match text {
                    "vertex" => Some(Stage::Vertex),
                    "fragment" => Some(Stage::Fragment),
                    "compute" => Some(Stage::Compute),
                    _ => doing.stage,
                };
                let named_words = matches!(text, "builtin" | "interpolate" | "diagnostic" | "if");
                doing.attribute = Attribute::Opens { named_words };
                return;
            }
            Attribute::Opens { .. } => doing.attribute = Attribute::No,
            Attribute::Inside { named_words: true, .. } => return,
            _ => {}
        }
        let in_attribute = matches!(doing.attribute, Attribute::Inside { .. });
        if !doing.begun && !in_attribute {
            return self.keyword(doing, text);
        }
        if doing.skip_template && doing.templates > 0 {
            return;
        }
        if self.previous == TokenKind::Dot {
            let member = self.symbol(span);
            if let Some(owner) = doing.dotted.take() {
                self.module.references[owner].member = Some((member, span));
            }
            return;
        }
        match doing.naming {
            Naming::Own => {
                doing.naming = Naming::No;
                doing.skip_template = false;
                let symbol = self.symbol(span);
                doing.name = Some((symbol, span));
                self.refer(doing, symbol, span);
                return;
            }
            Naming::Member if !in_attribute && doing.templates == 0 => {
                doing.naming = Naming::No;
                if doing.kind == DeclarationKind::Function {
                    let symbol = self.symbol(span);
                    self.module.locals.push((symbol, span));
                }
                return;
            }
            Naming::Local => {
                doing.naming = Naming::No;
                doing.skip_template = false;
                let symbol = self.symbol(span);
                self.module.locals.push((symbol, span));
                doing.pending = Some((symbol, doing.braces, doing.round));
                return;
            }
            _ => {}
        }
        if doing.kind == DeclarationKind::Function && doing.braces > 0 {
            match text {
                "let" | "const" => {
                    doing.naming = Naming::Local;
                    return;
                }
                "var" => {
                    doing.naming = Naming::Local;
                    doing.skip_template = true;
                    return;
                }
                "for" => {
                    let (open, header) = (doing.open.len(), Some(doing.round));
                    doing.scopes.push(Scope { open, header, body: false });
                    return;
                }
                "if" | "else" | "return" | "while" | "loop" | "switch" | "case" | "default" | "break"
                | "continue" | "continuing" | "discard" | "true" | "false" => return,
                _ => {}
            }
        }
        let symbol = self.symbol(span);
        if self.visible[symbol as usize] == 0 {
            self.refer(doing, symbol, span);
        }
    }

    fn refer(&mut self, doing: &mut Doing, symbol: Symbol, span: Span) {
        doing.fresh = Some(self.module.references.len());
        self.module.references.push(Reference { symbol, span, member: None });
    }

    fn keyword(&mut self, doing: &mut Doing, text: &str) {
        use DeclarationKind as D;
        doing.begun = true;
        doing.kind = match text {
            "fn" => D::Function,
            "struct" => D::Struct,
            "const" => D::Const,
            "override" => D::Override,
            "var" => D::Var,
            "alias" => D::Alias,
            "const_assert" => D::ConstAssert,
            "enable" => D::Enable,
            "requires" => D::Requires,
            "diagnostic" => D::Diagnostic,
            _ => D::Other,
        };
        doing.skip_template = doing.kind == D::Var;
        if !matches!(doing.kind, D::ConstAssert | D::Enable | D::Requires | D::Diagnostic | D::Other) {
            doing.naming = Naming::Own;
        }
    }
}

/// Whether `text` ends in a line with nothing on it.
fn ends_with_blank_line(text: &str) -> bool {
    let Some(text) = text.trim_end_matches([' ', '\t']).strip_suffix('\n') else { return text.is_empty() };
    let text = text.strip_suffix('\r').unwrap_or(text).trim_end_matches([' ', '\t']);
    text.is_empty() || text.ends_with('\n')
}

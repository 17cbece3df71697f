//! What every name in a WGSL module means: its tokens → [`Scopes`].
//!
//! The text is one that naga has accepted: nothing is reported here. Whatever is not understood stays a word, and words
//! are never touched.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::source::Span;
use crate::syntax::{TokenKind, Tokens};

/// What a token is to those who rename.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    /// No name of the module's own: a keyword, WGSL's own name, an attribute, no identifier at all.
    Word,
    /// By number in [`Scopes::globals`].
    Global(u32),
    /// By number in [`Scopes::locals`].
    Local(u32),
    /// By number in [`Scopes::members`].
    Member(u32),
}

/// A declaration of module scope.
#[derive(Debug, Default)]
pub(super) struct Global<'a> {
    pub(super) name: &'a str,
    /// How often it is written, its declaration included.
    pub(super) uses: u32,
    /// The host knows it by name: an entry point, an override, a variable that is bound.
    pub(super) is_host: bool,
    /// Functions that name it, by number; sorted.
    pub(super) functions: Vec<u32>,
    is_entry: bool,
    is_bound: bool,
    /// A struct or an alias.
    pub(super) is_type: bool,
    /// What its declaration names, in [`Walk::candidates`].
    names: std::ops::Range<usize>,
    /// Of a struct.
    members: Vec<u32>,
}

/// A parameter or a variable of a function.
#[derive(Debug)]
pub(super) struct Local {
    pub(super) uses: u32,
    /// Its function, by number.
    pub(super) function: u32,
    /// Where it is visible, in tokens.
    pub(super) range: std::ops::Range<u32>,
}

/// A name of struct members. Types are naga's business: members of one name are one here, in whichever struct.
#[derive(Debug)]
pub(super) struct Member<'a> {
    pub(super) name: &'a str,
    pub(super) uses: u32,
    /// It is in a struct that the host lays out.
    pub(super) is_host: bool,
    /// The structs that have it; sorted.
    pub(super) structs: Vec<u32>,
}

/// All names of a module.
#[derive(Debug, Default)]
pub(super) struct Scopes<'a> {
    /// By solid token: those that are neither blank nor a comment.
    pub(super) meanings: Vec<Meaning>,
    pub(super) globals: Vec<Global<'a>>,
    pub(super) locals: Vec<Local>,
    pub(super) members: Vec<Member<'a>>,
    /// Identifiers that stay as they are.
    pub(super) words: FxHashSet<&'a str>,
    /// How many functions there are.
    pub(super) functions: u32,
    /// Whether there is an entry point: without one, the module is a library, and its names are what it is for.
    pub(super) has_entry: bool,
}

/// A token that is neither blank nor a comment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Solid {
    pub(super) kind: TokenKind,
    pub(super) span: Span,
}

/// The tokens that count.
pub(super) fn solid(tokens: &Tokens) -> Vec<Solid> {
    let solid = tokens.iter().filter(|(kind, _)| !kind.is_trivia());
    solid.map(|(kind, span)| Solid { kind, span }).collect()
}

/// Resolves all names of the module in `text`.
pub(super) fn resolve<'a>(text: &'a str, tokens: &[Solid]) -> Scopes<'a> {
    let mut walk = Walk {
        text,
        tokens,
        at: 0,
        scopes: Scopes { meanings: vec![Meaning::Word; tokens.len()], ..Scopes::default() },
        candidates: Vec::new(),
        dotted: Vec::new(),
        members: FxHashMap::default(),
        visible: FxHashMap::default(),
        function: None,
        templates: Vec::new(),
    };
    while walk.at < tokens.len() {
        let before = walk.at;
        walk.declaration();
        if walk.at == before {
            walk.at += 1; // not understood: a word
        }
    }
    walk.finish()
}

/// A name that no function declares: a global's, or WGSL's own.
struct Candidate {
    token: usize,
    function: Option<u32>,
}

/// A `{`, or the header of a `for`, which ends with the body's `}`.
struct Scope<'a> {
    opened: Vec<&'a str>,
    /// How many round brackets were open at a `for` whose body is yet to come.
    header: Option<u32>,
    ends_header: bool,
}

impl Scope<'_> {
    fn new(header: Option<u32>, ends_header: bool) -> Self {
        Self { opened: Vec::new(), header, ends_header }
    }
}

struct Walk<'a, 't> {
    text: &'a str,
    tokens: &'t [Solid],
    at: usize,
    scopes: Scopes<'a>,
    candidates: Vec<Candidate>,
    /// Tokens behind a dot.
    dotted: Vec<usize>,
    members: FxHashMap<&'a str, u32>,
    /// Locals by name, the innermost last.
    visible: FxHashMap<&'a str, Vec<u32>>,
    function: Option<u32>,
    /// What stands before the template lists that are open.
    templates: Vec<&'a str>,
}

impl<'a> Walk<'a, '_> {
    fn kind(&self, at: usize) -> Option<TokenKind> {
        self.tokens.get(at).map(|token| token.kind)
    }

    fn word(&self, at: usize) -> &'a str {
        self.tokens.get(at).map_or("", |token| &self.text[token.span.range()])
    }

    /// One declaration of module scope, with its attributes.
    fn declaration(&mut self) {
        let names = self.candidates.len();
        let mut global = Global::default();
        while self.kind(self.at) == Some(TokenKind::At) {
            let word = self.attribute();
            global.is_entry |= matches!(word, "vertex" | "fragment" | "compute");
            global.is_bound |= matches!(word, "group" | "binding");
        }
        let keyword = self.word(self.at);
        match keyword {
            "enable" | "requires" | "diagnostic" => {
                while !matches!(self.kind(self.at), None | Some(TokenKind::Semicolon)) {
                    self.at += 1;
                }
                return;
            }
            "fn" | "struct" | "var" | "const" | "override" | "alias" => {}
            _ => return self.until_semicolon(), // `const_assert …;`
        }
        self.at += 1;
        if keyword == "var" {
            self.skip_template();
        }
        if self.kind(self.at) != Some(TokenKind::Ident) {
            return;
        }
        let number = self.scopes.globals.len() as u32;
        global.name = self.word(self.at);
        global.uses = 1;
        global.is_host = global.is_entry || global.is_bound || keyword == "override";
        global.is_type = matches!(keyword, "struct" | "alias");
        self.scopes.has_entry |= global.is_entry;
        self.scopes.meanings[self.at] = Meaning::Global(number);
        self.at += 1;
        match keyword {
            "fn" => self.a_function(),
            "struct" => global.members = self.a_struct(number),
            _ => self.until_semicolon(),
        }
        global.names = names..self.candidates.len();
        self.scopes.globals.push(global);
    }

    /// `@name` or `@name(…)`: gives the name.
    fn attribute(&mut self) -> &'a str {
        let name = self.word(self.at + 1);
        self.at += 2;
        if self.kind(self.at) == Some(TokenKind::ParenOpen) {
            let are_words = matches!(name, "builtin" | "interpolate" | "diagnostic");
            let mut round = 0u32;
            while let Some(kind) = self.kind(self.at) {
                match kind {
                    TokenKind::ParenOpen => round += 1,
                    TokenKind::ParenClose => round = round.saturating_sub(1),
                    _ if are_words => {}
                    _ => self.name(),
                }
                self.at += 1;
                if round == 0 {
                    break;
                }
            }
        }
        name
    }

    /// The `<…>` of a `var`.
    fn skip_template(&mut self) {
        if self.kind(self.at) == Some(TokenKind::TemplateOpen) {
            while !matches!(self.kind(self.at), None | Some(TokenKind::TemplateClose)) {
                self.at += 1;
            }
            self.at += 1;
        }
    }

    /// Names up to the semicolon, which ends every declaration without braces.
    fn until_semicolon(&mut self) {
        while let Some(kind) = self.kind(self.at) {
            if kind == TokenKind::Semicolon {
                return;
            }
            self.name();
            self.at += 1;
        }
    }

    /// The token where it stands, as a name that is used.
    fn name(&mut self) {
        let Some(Solid { kind, .. }) = self.tokens.get(self.at).copied() else { return };
        match kind {
            TokenKind::TemplateOpen => self.templates.push(self.word(self.at.saturating_sub(1))),
            TokenKind::TemplateClose => drop(self.templates.pop()),
            TokenKind::Ident => {
                let word = self.word(self.at);
                if self.at > 0 && self.kind(self.at - 1) == Some(TokenKind::Dot) {
                    self.dotted.push(self.at);
                } else if self.templates.last().is_some_and(|head| is_enumerant(head, word)) {
                } else if let Some(local) = self.visible.get(word).and_then(|all| all.last()) {
                    self.scopes.locals[*local as usize].uses += 1;
                    self.scopes.meanings[self.at] = Meaning::Local(*local);
                } else {
                    self.candidates.push(Candidate { token: self.at, function: self.function });
                }
            }
            _ => {}
        }
    }

    fn a_struct(&mut self, number: u32) -> Vec<u32> {
        let mut members = Vec::new();
        self.at += 1; // `{`
        loop {
            match self.kind(self.at) {
                None => return members,
                Some(TokenKind::BraceClose) => {
                    self.at += 1;
                    return members;
                }
                Some(TokenKind::At) => {
                    self.attribute();
                }
                Some(TokenKind::Ident) if self.kind(self.at + 1) == Some(TokenKind::Colon) => {
                    let name = self.word(self.at);
                    let next = self.scopes.members.len() as u32;
                    let member = *self.members.entry(name).or_insert(next);
                    if member == next {
                        let structs = Vec::new();
                        self.scopes.members.push(Member { name, uses: 0, is_host: false, structs });
                    }
                    self.scopes.members[member as usize].uses += 1;
                    self.scopes.members[member as usize].structs.push(number);
                    self.scopes.meanings[self.at] = Meaning::Member(member);
                    members.push(member);
                    self.at += 1;
                }
                Some(_) => {
                    self.name();
                    self.at += 1;
                }
            }
        }
    }

    /// From the opening bracket of its parameters to the end of its body.
    fn a_function(&mut self) {
        let function = self.scopes.functions;
        self.scopes.functions += 1;
        self.function = Some(function);
        let start = self.at as u32;
        let mut parameters = Vec::new();
        let mut round = 0u32;
        while let Some(kind) = self.kind(self.at) {
            match kind {
                TokenKind::BraceOpen => break,
                TokenKind::At => {
                    self.attribute();
                    continue;
                }
                TokenKind::ParenOpen => round += 1,
                TokenKind::ParenClose => round = round.saturating_sub(1),
                TokenKind::Ident if round == 1 && self.kind(self.at + 1) == Some(TokenKind::Colon) => {
                    parameters.push((self.word(self.at), self.local(function, start)));
                }
                _ => self.name(),
            }
            self.at += 1;
        }
        let mut open = vec![Scope::new(None, false)];
        for (name, local) in parameters {
            self.show(&mut open, name, local);
        }
        self.body(function, open);
        self.function = None;
    }

    /// The identifier where it stands declares a local, from token `start` on.
    fn local(&mut self, function: u32, start: u32) -> u32 {
        let number = self.scopes.locals.len() as u32;
        self.scopes.locals.push(Local { uses: 1, function, range: start..self.tokens.len() as u32 });
        self.scopes.meanings[self.at] = Meaning::Local(number);
        number
    }

    fn show(&mut self, open: &mut [Scope<'a>], name: &'a str, local: u32) {
        self.visible.entry(name).or_default().push(local);
        if let Some(scope) = open.last_mut() {
            scope.opened.push(name);
        }
    }

    fn close(&mut self, open: &mut Vec<Scope<'a>>) -> bool {
        let Some(scope) = open.pop() else { return false };
        for name in &scope.opened {
            if let Some(local) = self.visible.get_mut(name).and_then(Vec::pop) {
                self.scopes.locals[local as usize].range.end = self.at as u32;
            }
        }
        scope.ends_header
    }

    /// A function's body. `open` has the scope of its parameters.
    fn body(&mut self, function: u32, mut open: Vec<Scope<'a>>) {
        let mut round = 0u32;
        // Declared, and visible from the end of its statement on.
        let mut pending = None;
        while let Some(kind) = self.kind(self.at) {
            match kind {
                TokenKind::ParenOpen => round += 1,
                TokenKind::ParenClose => round = round.saturating_sub(1),
                TokenKind::At => {
                    self.attribute();
                    continue;
                }
                TokenKind::BraceOpen => {
                    let is_body = open.last().is_some_and(|scope| scope.header == Some(round));
                    if is_body && let Some(scope) = open.last_mut() {
                        scope.header = None;
                    }
                    open.push(Scope::new(None, is_body));
                }
                TokenKind::BraceClose => {
                    if self.close(&mut open) {
                        self.close(&mut open);
                    }
                    if open.len() <= 1 {
                        self.close(&mut open);
                        self.at += 1;
                        return;
                    }
                }
                TokenKind::Semicolon => {
                    if let Some((name, local)) = pending.take() {
                        self.show(&mut open, name, local);
                    }
                }
                TokenKind::Ident => match self.word(self.at) {
                    "for" => open.push(Scope::new(Some(round), false)),
                    word @ ("let" | "const" | "var") => {
                        self.at += 1;
                        if word == "var" {
                            self.skip_template();
                        }
                        if self.kind(self.at) != Some(TokenKind::Ident) {
                            continue;
                        }
                        pending = Some((self.word(self.at), self.local(function, self.at as u32)));
                    }
                    _ => self.name(),
                },
                _ => self.name(),
            }
            self.at += 1;
        }
    }

    /// Globals may be used before they are declared, and members before their structs: they are known only now.
    fn finish(mut self) -> Scopes<'a> {
        let globals: FxHashMap<&str, u32> =
            self.scopes.globals.iter().zip(0..).map(|(global, number)| (global.name, number)).collect();
        for candidate in &self.candidates {
            let word = self.word(candidate.token);
            let Some(number) = globals.get(word) else {
                self.scopes.words.insert(word);
                continue;
            };
            self.scopes.meanings[candidate.token] = Meaning::Global(*number);
            let global = &mut self.scopes.globals[*number as usize];
            global.uses += 1;
            if let Some(function) = candidate.function
                && global.functions.last() != Some(&function)
            {
                global.functions.push(function); // functions are walked in order
            }
        }
        for token in std::mem::take(&mut self.dotted) {
            if let Some(number) = self.members.get(self.word(token)) {
                self.scopes.members[*number as usize].uses += 1;
                self.scopes.meanings[token] = Meaning::Member(*number);
            }
        }
        self.mark_host();
        self.scopes
    }

    /// The host lays out what is bound: it may know all fields inside by name.
    fn mark_host(&mut self) {
        let bound = self.scopes.globals.iter().zip(0..).filter(|(global, _)| global.is_bound);
        let mut stack: Vec<u32> = bound.map(|(_, number)| number).collect();
        let mut seen: FxHashSet<u32> = stack.iter().copied().collect();
        while let Some(number) = stack.pop() {
            let global = &self.scopes.globals[number as usize];
            for member in &global.members {
                self.scopes.members[*member as usize].is_host = true;
            }
            for candidate in &self.candidates[global.names.clone()] {
                if let Meaning::Global(inner) = self.scopes.meanings[candidate.token]
                    && self.scopes.globals[inner as usize].is_type
                    && seen.insert(inner)
                {
                    stack.push(inner);
                }
            }
        }
    }
}

/// Whether `word`, in the template list of `head`, is one of WGSL's address spaces, access modes or texel formats.
fn is_enumerant(head: &str, word: &str) -> bool {
    const SPACES: [&str; 5] = ["function", "private", "workgroup", "uniform", "storage"];
    const ACCESSES: [&str; 3] = ["read", "write", "read_write"];
    match head {
        "var" => true,
        "ptr" => SPACES.contains(&word) || ACCESSES.contains(&word),
        _ => head.starts_with("texture_storage_"),
    }
}

//! The lexer and the split: nothing is lost, whatever comes in, and names are told apart as WGSL's scopes tell them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use orogen::Library;
use orogen::syntax::{TokenKind as K, Tokens, lex, parse_directive, parse_fragment, split};
use proptest::prelude::*;

/// So many cases; with `CASES=20` in the environment, twenty times as many.
fn cases(some: u32) -> ProptestConfig {
    let times = std::env::var("CASES").ok().and_then(|times| times.parse::<u32>().ok()).unwrap_or(1);
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(some * times) }
}

fn again(text: &str, tokens: &Tokens) -> String {
    tokens.iter().map(|(_, span)| &text[span.range()]).collect()
}

/// Every token but blank ones, as it is spelled.
fn words(text: &str) -> Vec<&str> {
    let tokens = lex(text);
    tokens.iter().filter(|(kind, _)| !kind.is_trivia()).map(|(_, span)| &text[span.range()]).collect()
}

/// What stands between the brackets of each template list, outermost brackets first.
fn templates(text: &str) -> Vec<String> {
    let mut open = Vec::new();
    let mut lists = Vec::new();
    for (kind, span) in lex(text).iter() {
        match kind {
            K::TemplateOpen => open.push((lists.len(), span.end)),
            K::TemplateClose => {
                let (_, start) = open.pop().unwrap();
                lists.push((start, text[start as usize..span.start as usize].to_owned()));
            }
            _ => {}
        }
    }
    assert!(open.is_empty(), "a template list opens and does not close in {text:?}");
    lists.sort();
    lists.into_iter().map(|(_, list)| list).collect()
}

fn library() -> Vec<String> {
    let library = Library::standard();
    library.modules().iter().map(|path| library.find(path).unwrap().text.to_string()).collect()
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn tokens_of_any_text_are_the_text(text in any::<String>()) {
        prop_assert_eq!(again(&text, &lex(&text)), text);
    }

    #[test]
    fn tokens_of_any_bytes_read_as_text_are_the_text(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let text = String::from_utf8_lossy(&bytes);
        prop_assert_eq!(again(&text, &lex(&text)), text);
    }

    #[test]
    fn tokens_of_marks_in_any_order_are_the_text(text in "[ \\n\\r\u{85}\u{2028}#/*<>=!&|(){};:,.@_a0xefuh+-]{0,80}") {
        let tokens = lex(&text);
        prop_assert_eq!(again(&text, &tokens), text.clone());
        let (mut opened, mut closed) = (0, 0);
        for (kind, _) in tokens.iter() {
            opened += usize::from(kind == K::TemplateOpen);
            closed += usize::from(kind == K::TemplateClose);
            prop_assert!(closed <= opened);
        }
        prop_assert_eq!(opened, closed);
        let fragment = parse_fragment(text.as_str().into());
        for truth in [true, false] {
            let module = split(&fragment, &vec![truth; fragment.conditions]);
            let mut end = 0;
            for piece in &module.pieces {
                prop_assert!(piece.start >= end && text.get(piece.range()).is_some());
                end = piece.end;
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn tokens_of_broken_fragments_are_the_text(which: prop::sample::Index, at: prop::sample::Index, len in 0usize..40, put in any::<String>()) {
        let all = library();
        let mut text = all[which.index(all.len())].clone();
        let start = text.floor_char_boundary(at.index(text.len()));
        let end = text.floor_char_boundary((start + len).min(text.len()));
        text.replace_range(start..end, &put);
        prop_assert_eq!(again(&text, &lex(&text)), text);
    }
}

#[test]
fn every_byte_of_the_library_belongs_to_one_declaration() {
    for text in library() {
        let fragment = parse_fragment(text.as_str().into());
        if !fragment.directives.is_empty() {
            continue;
        }
        let module = split(&fragment, &[]);
        let whole: String = module.pieces.iter().map(|span| &text[span.range()]).collect();
        assert_eq!(whole, text);
        let count = |range: &std::ops::Range<usize>| range.len();
        let owned: usize = module.declarations.iter().map(|declaration| count(&declaration.pieces)).sum();
        assert_eq!(owned + count(&module.head) + count(&module.tail), module.pieces.len());
    }
}

#[test]
fn literals_of_all_forms_are_one_token() {
    for literal in [
        "0",
        "123",
        "0u",
        "123i",
        "0x0",
        "0xfFu",
        "0X1Ai",
        "0f",
        "1h",
        "1.5",
        ".5",
        "1.",
        "1.f",
        ".5h",
        "1e3",
        "1E+3",
        "1e-3f",
        "1.5e3",
        "0x1p4",
        "0x1.8p-1f",
        "0x.8p1",
        "0X1.P2h",
        "0xA.fp+3",
        "01.5",
        "0x1.8",
    ] {
        assert_eq!(words(literal), [literal]);
        assert_eq!(lex(literal).kind(0), K::Number, "{literal}");
    }
    assert_eq!(words("1.5.x"), ["1.5", ".", "x"]);
    assert_eq!(words("a.0"), ["a", ".0"]);
    assert_eq!(words("1e"), ["1", "e"]);
    assert_eq!(words("1-2"), ["1", "-", "2"]);
    assert_eq!(words("1.u"), ["1.", "u"]);
    assert_eq!(words("v.x"), ["v", ".", "x"]);
}

#[test]
fn the_longest_operator_wins() {
    assert_eq!(words("a->b a-- - -b"), ["a", "->", "b", "a", "--", "-", "-", "b"]);
    assert_eq!(words("a<<=b>>=c"), ["a", "<<=", "b", ">>=", "c"]);
    assert_eq!(words("a<=b>=c==d!=e"), ["a", "<=", "b", ">=", "c", "==", "d", "!=", "e"]);
    assert_eq!(words("a&&b||!c&d|e^~f"), ["a", "&&", "b", "||", "!", "c", "&", "d", "|", "e", "^", "~", "f"]);
    assert_eq!(words("_ = _a + __b"), ["_", "=", "_a", "+", "__b"]);
    assert_eq!(words("a $ `"), ["a", "$", "`"]);
}

#[test]
fn every_line_break_of_the_specification_ends_a_line() {
    for line_break in ["\n", "\r\n", "\r", "\u{b}", "\u{c}", "\u{85}", "\u{2028}", "\u{2029}"] {
        let text = format!("// one{line_break}a{line_break} #if true // two{line_break}b");
        let kinds: Vec<_> =
            lex(&text).iter().map(|(kind, _)| kind).filter(|kind| *kind != K::Blank).collect();
        assert_eq!(kinds, [K::LineComment, K::Ident, K::Directive, K::Ident], "{line_break:?}");
        let text =
            format!("#if true{line_break}const A = 1;{line_break}#else{line_break}B{line_break}#endif");
        let fragment = parse_fragment(text.as_str().into());
        assert!(fragment.errors.is_empty(), "{line_break:?}");
        let module = split(&fragment, &[true]);
        let left: String = module.pieces.iter().map(|span| &text[span.range()]).collect();
        assert_eq!(left, format!("const A = 1;{line_break}"));
    }
}

#[test]
fn block_comments_nest_and_may_stay_open() {
    assert_eq!(words("a /* /* b */ c /**/ */ d"), ["a", "d"]);
    assert_eq!(words("a /*/ b */ c"), ["a", "c"]);
    assert_eq!(words("a /* /* */ b"), ["a"]);
    assert_eq!(words("a /* é */ b // c */"), ["a", "b"]);
    assert_eq!(words("/* a\n#if true\n*/ b"), ["b"], "a directive in a comment is none");
}

#[test]
fn identifiers_follow_uax_31() {
    assert_eq!(
        words("Δέλτα réflexion Кызыл 𐰓𐰏𐰇 朝焼け سلام"),
        ["Δέλτα", "réflexion", "Кызыл", "𐰓𐰏𐰇", "朝焼け", "سلام"]
    );
    assert_eq!(words("a\u{301}b"), ["a\u{301}b"], "a combining mark goes on, and cannot start");
    assert_eq!(lex("\u{301}").kind(0), K::Unknown);
    assert_eq!(lex("🏔").kind(0), K::Unknown);
}

#[test]
fn template_lists_are_found_as_the_specification_describes() {
    // Its own examples (§3.9), and those around them.
    assert_eq!(templates("array<i32,select(2,3,a>b)>"), ["i32,select(2,3,a>b)"]);
    assert_eq!(templates("A ( B < C, D > ( E ) )"), [" C, D "]);
    assert_eq!(templates("a[b<d]>()"), Vec::<String>::new());
    assert_eq!(templates("a < b || c > d"), Vec::<String>::new());
    assert_eq!(templates("a < b && c > d"), Vec::<String>::new());
    assert_eq!(templates("if a < b { c > d }"), Vec::<String>::new());
    assert_eq!(templates("a < b; c > d"), Vec::<String>::new());
    assert_eq!(templates("case a < b: c > d"), Vec::<String>::new());
    assert_eq!(templates("a < b = c > d"), Vec::<String>::new());
    assert_eq!(templates("a<b != c>()"), ["b != c"]);
    assert_eq!(templates("a<b == c>()"), ["b == c"]);
    assert_eq!(templates("array<vec2<f32>>"), ["vec2<f32>", "f32"]);
    assert_eq!(templates("array<atomic<u32>,(a>>2)>=b"), ["atomic<u32>,(a>>2)", "u32"]);
    assert_eq!(templates("vec2<f32>/**/>x"), ["f32"]);
    assert_eq!(templates("f /* c */ <i32>(x)"), ["i32"]);
    assert_eq!(templates("1 < 2 > 3"), Vec::<String>::new());
    assert_eq!(templates("a << b >> c"), Vec::<String>::new());
    assert_eq!(templates("a <= b >= c"), Vec::<String>::new());
    assert_eq!(words("a >> b"), ["a", ">>", "b"]);
    assert_eq!(words("x<y>>z"), ["x", "<", "y", ">", ">", "z"]);
    assert_eq!(words("var<storage,read_write>x"), ["var", "<", "storage", ",", "read_write", ">", "x"]);
}

#[test]
fn megabytes_of_the_same_mark_take_one_pass() {
    // Not timed: in quadratic time, none of these would end. No recursion either, or the stack would.
    const MANY: usize = 1 << 20;
    for mark in [
        "(", ")", "<", ">", "a<", "a<(", "/*", "*/", "{", "}", "[", "@", "#\n", "é", "\u{2028}", ";",
        "///\n", "/*\n",
    ] {
        let many = if ["(", "<", "/*"].contains(&mark) { MANY } else { MANY / 8 };
        let text = mark.repeat(many / mark.len());
        let tokens = lex(&text);
        assert!(tokens.len() <= text.len());
        let fragment = parse_fragment(text.as_str().into());
        let module = split(&fragment, &[]);
        assert!(module.pieces.len() <= tokens.len() + 1, "{mark}");
    }
    for text in [
        format!("#if {}", "(".repeat(MANY)),
        format!("#if {}", "!".repeat(MANY)),
        format!("#if {}a", "a && ".repeat(MANY / 5)),
    ] {
        let fragment = parse_fragment(text.as_str().into());
        assert!(!fragment.errors.is_empty());
    }
    let deep = format!("#if {}true{}", "(".repeat(MANY), ")".repeat(MANY));
    assert!(parse_directive(&deep, 0, "").is_ok());
    let nested = "#if true\n".repeat(MANY / 16) + &"#endif\n".repeat(MANY / 16);
    let fragment = parse_fragment(nested.as_str().into());
    assert!(fragment.errors.is_empty());
    assert!(split(&fragment, &vec![true; fragment.conditions]).pieces.is_empty());
}

/// The names of module scope that `text`'s functions use, and the locals that they declare.
fn names(text: &str) -> (BTreeSet<&str>, Vec<&str>) {
    let fragment = parse_fragment(text.into());
    assert!(fragment.errors.is_empty());
    let module = split(&fragment, &vec![true; fragment.conditions]);
    let references = module.references.iter().map(|reference| &text[reference.span.range()]);
    let locals = module.locals.iter().map(|(_, span)| &text[span.range()]);
    (references.collect(), locals.collect())
}

fn check_names(text: &str, uses: &[&str], locals: &[&str]) {
    let (found, found_locals) = names(text);
    assert_eq!(found, uses.iter().copied().collect(), "names of module scope in {text}");
    assert_eq!(found_locals, locals, "locals of {text}");
}

#[test]
fn a_local_is_visible_from_its_end_to_the_end_of_its_block() {
    check_names("fn f() { let x = x; g(x); }", &["f", "x", "g"], &["x"]);
    check_names("fn f() { var x = 1; { let x = x; } x++; }", &["f"], &["x", "x"]);
    check_names("fn f() { { let a = 1; } b(a); }", &["f", "b", "a"], &["a"]);
    check_names("fn f(a: A, b: B) -> C { return a + b; }", &["f", "A", "B", "C"], &["a", "b"]);
    check_names("fn f(a: A) {} fn g() { a(); }", &["f", "A", "g", "a"], &["a"]);
    check_names(
        "fn f() { const n = N; var v: array<T, n>; v[n] = n; }",
        &["f", "N", "array", "T"],
        &["n", "v"],
    );
    check_names("fn f() { var<function> private_like = 1; }", &["f"], &["private_like"]);
    check_names("fn f() { if c { let a = 1; } else if a { } else { a(); } }", &["f", "c", "a"], &["a"]);
}

#[test]
fn a_loop_s_variable_is_its_own() {
    check_names(
        "fn f() { for (var i = i; i < n; i++) { let j = i; } i = j; }",
        &["f", "i", "n", "j"],
        &["i", "j"],
    );
    check_names("fn f() { for (;;) { } for (var a = 0; ; ) { } a(); }", &["f", "a"], &["a"]);
    check_names("fn f() { for (var i = g(1, (2)); i < h[0]; i += 1) { i; } }", &["f", "g", "h"], &["i"]);
    check_names("fn f() { while a { let a = 1; } a; }", &["f", "a"], &["a"]);
    check_names(
        "fn f() { loop { let t = 1; continuing { let u = t; break if t > u; } } t; u; }",
        &["f", "t", "u"],
        &["t", "u"],
    );
    check_names("fn f() { for (var i = 0; i < 3; i++) { for (var i = i; ; ) { } i; } }", &["f"], &["i", "i"]);
}

#[test]
fn cases_use_names_and_open_blocks() {
    check_names(
        "fn f() { switch s { case A, B: { let A = 1; } default: { A(); } } }",
        &["f", "s", "A", "B"],
        &["A"],
    );
    check_names(
        "fn f() { switch (s) { case 1 { let t = 1; } case default, t { } } }",
        &["f", "s", "t"],
        &["t"],
    );
}

#[test]
fn members_are_no_names() {
    check_names("fn f(s: S) -> f32 { return s.x + t.y.z + g().w; }", &["f", "S", "f32", "t", "g"], &["s"]);
    check_names(
        "struct S { a: A, @size(N) b: array<B, M>, c: ptr<function, C>, }",
        &["S", "A", "N", "array", "B", "M", "ptr", "function", "C"],
        &[],
    );
    check_names("struct S { x: f32 } fn f() { let s = S(x); s.x = 1; }", &["S", "f32", "f", "x"], &["s"]);
}

#[test]
fn attributes_use_names_only_in_brackets() {
    check_names(
        "@compute @workgroup_size(W, H + 1) fn f(@builtin(position) p: V, @location(L) @interpolate(flat) q: U) -> @location(0) R { }",
        &["W", "H", "f", "V", "L", "U", "R"],
        &["p", "q"],
    );
    check_names("@id(I) override o: T = D;", &["I", "o", "T", "D"], &[]);
    check_names(
        "@group(G) @binding(B) var<storage, read_write> v: array<T>;",
        &["G", "B", "v", "array", "T"],
        &[],
    );
    check_names("@must_use fn f() { @diagnostic(off, rule) if c { } }", &["f", "c"], &[]);
    check_names("@diagnostic(off, a.b) fn f() { }", &["f"], &[]);
}

#[test]
fn declarations_of_all_kinds_say_their_names() {
    let text = "enable f16; requires x; diagnostic(off, y); const A = B; alias C = D; const_assert E > F; var<private> G: H = I; struct J { k: L }; override M: N;";
    let (uses, _) = names(text);
    assert_eq!(uses.into_iter().collect::<String>(), "ABCDEFGHIJLMNf16offxy");
    let fragment = parse_fragment(text.into());
    let module = split(&fragment, &[]);
    let own: Vec<_> =
        module.declarations.iter().map(|d| d.name.map_or("", |(_, span)| &text[span.range()])).collect();
    assert_eq!(own, ["", "", "", "A", "C", "", "G", "J", "M"]);
}

#[test]
fn what_stands_behind_a_dot_is_kept_with_its_name() {
    let text = "fn f() { let a = sun.azimuth + sun . elevation + sun.color.x + sun; }";
    let fragment = parse_fragment(text.into());
    let module = split(&fragment, &[]);
    let members: Vec<_> = module
        .references
        .iter()
        .filter(|reference| &text[reference.span.range()] == "sun")
        .map(|reference| reference.member.map(|(_, span)| &text[span.range()]))
        .collect();
    assert_eq!(members, [Some("azimuth"), Some("elevation"), Some("color"), None]);
}

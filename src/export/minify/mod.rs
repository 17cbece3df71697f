//! The same shader in fewer bytes: [`Shader`] → [`Minified`] → WGSL, GLSL ES 3.00 or Shadertoy.
//!
//! Comments and blank space go, names get short scope by scope, numbers lose the digits that say nothing. Declarations stay
//! in their order, so that naga reads the same module from the result, but for names.
//!
//! What a host knows by name keeps it: entry points, overrides, variables that are bound and the fields of what is in
//! them, and live parameters that are variables. A module without an entry point is there for its names: it keeps all of
//! module scope and its members, and only locals change.

mod number;
mod scopes;
mod short;
mod squeeze;
mod write;

use rustc_hash::FxHashSet;
use serde::Serialize;

use super::error::ExportError;
use super::export_entry;
use super::target::Target;
use crate::bake::{Baked, Facts, Segment, SourceMap, Storage};
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::{Span, Templates};
use crate::syntax::lex;
use crate::template;

/// A shader whose text is minified.
pub struct Minified {
    shader: Shader,
    header: String,
}

#[derive(Serialize)]
struct Context<'a> {
    #[serde(flatten)]
    facts: &'a Facts,
    /// The licence that most files are under.
    main_licence: &'a str,
}

/// Writes `shader` in fewer bytes, and checks the result as it was checked itself.
///
/// # Errors
/// Where the template of the licence line cannot be rendered.
pub fn minify(shader: &Shader, templates: &Templates) -> Result<Minified, Error> {
    let baked = &shader.checked().baked;
    let facts = Facts::of(&baked.composition);
    let context = Context { facts: &facts, main_licence: facts.main_licence() };
    let rendered = template::render(templates, "minified.jinja", context)?;
    // A backslash at the end would join the next line to the comment, where there is a preprocessor.
    let lines = rendered.trim().lines().map(|line| line.trim_end().trim_end_matches('\\'));
    let header = lines.collect::<Vec<_>>().join("\n");
    let (text, map) = text(baked, &header);
    let smaller = Baked {
        text,
        map,
        interface: baked.interface.clone(),
        storage: baked.storage.clone(),
        composition: baked.composition.clone(),
    };
    let shader = shader.with(smaller).map_err(|error| {
        let why = error.diagnostics().first().map_or_else(String::new, |first| first.message.clone());
        Error::from(ExportError::Minifier { why })
    })?;
    Ok(Minified { shader, header })
}

/// `wgsl` in fewer bytes, where it is a text of the host's own: a whole module that a compiler accepts. No licence line is
/// put in. What is no WGSL comes back as something that is none either.
pub fn minify_text(wgsl: &str) -> String {
    let mut out = String::with_capacity(wgsl.len() / 2);
    squeezed(wgsl, &|_| false, &mut out);
    out
}

impl Minified {
    /// The shader: its WGSL, its interface, which is what it was, and a map that leads to the authors' files.
    pub fn shader(&self) -> &Shader {
        &self.shader
    }

    /// The file for `target`, with the fragment entry point that GLSL or Shadertoy is to get, or the first.
    ///
    /// # Errors
    /// As [`export_entry`], and for targets that are not text which others compile.
    pub fn export(
        &self,
        target: Target,
        entry_point: Option<&str>,
        templates: &Templates,
    ) -> Result<Vec<u8>, Error> {
        if !target.is_minified() {
            return Err(ExportError::NotMinified { target }.into());
        }
        let bytes = export_entry(&self.shader, target, entry_point, templates)?;
        if target == Target::Wgsl {
            return Ok(bytes);
        }
        let text = String::from_utf8_lossy(&bytes); // it is text: nothing is lost
        Ok(squeeze::squeeze(&text, &self.header).into_bytes())
    }
}

fn text(baked: &Baked, header: &str) -> (String, SourceMap) {
    let variables = baked.composition.parameters.iter().zip(&baked.storage);
    let variables = variables.filter(|(_, storage)| **storage == Storage::Variable);
    let variables: FxHashSet<String> = variables.map(|(parameter, _)| parameter.decl.key.flat()).collect();

    let mut out = String::with_capacity(baked.text.len() / 2);
    out.push_str(header);
    out.push('\n');
    let placed = squeezed(&baked.text, &|name| variables.contains(name), &mut out);
    out.push('\n');

    let mut map = SourceMap::default();
    let mut segments = baked.map.segments().iter().peekable();
    for token in placed {
        while segments.next_if(|segment| segment.out.end <= token.from.start).is_some() {}
        let Some(segment) = segments.peek().filter(|segment| segment.out.start <= token.from.start) else {
            continue;
        };
        let from = if segment.copied {
            let by = token.from.start - segment.out.start;
            let start = segment.from.start + by;
            Span { start, end: (start + token.from.len() as u32).min(segment.from.end) }
        } else {
            segment.from
        };
        let copied = segment.copied && token.copied && from.len() == token.out.len();
        map.push(Segment { out: token.out, from, copied, ..**segment });
    }
    (out, map)
}

/// Appends the module in `text`, minified. `is_kept` says which names stay, beside those that the text itself shows to the
/// host.
fn squeezed(text: &str, is_kept: &dyn Fn(&str) -> bool, out: &mut String) -> Vec<write::Placed> {
    let tokens = scopes::solid(&lex(text));
    let scopes = scopes::resolve(text, &tokens);
    let short = short::names(&scopes, is_kept);
    write::write(text, &tokens, &scopes, &short, out)
}

#[cfg(test)]
mod tests {
    use super::minify_text;

    /// With an entry point behind it that calls `f`, where there is an `f`: a module without one keeps its names.
    fn short(text: &str) -> String {
        const ENTRY: &str = "@compute@workgroup_size(1)fn main(){}";
        let short = minify_text(&format!("{text} {ENTRY}"));
        short.strip_suffix(ENTRY).unwrap_or(&short).to_owned()
    }

    #[test]
    fn each_scope_gets_its_own_short_names() {
        let all = [
            (
                "fn f(first: f32, second: f32) -> f32 { return first * first + second; }",
                "fn a(a:f32,b:f32)->f32{return a*a+b;}",
            ),
            // Two functions use the same names again; the one that is called has to differ inside of the other.
            (
                "fn inner(value: f32) -> f32 { return value; } fn outer(value: f32) -> f32 { return inner(value) + value; }",
                "fn b(a:f32)->f32{return a;}fn a(a:f32)->f32{return b(a)+a;}",
            ),
            // Shadowed: the initialiser still means what is outside.
            (
                "fn f(x: f32) { var y = x; { let x = y + x; y = x; } y = x; }",
                "fn a(a:f32){var b=a;{let c=b+a;b=c;}b=a;}",
            ),
            // Scopes beside each other share names; a loop's variable ends with its body.
            (
                "fn f() { for (var i = 0; i < 3; i++) { let k = i; _ = k; } for (var j = 0; j < 3; j++) { _ = j; } let i = 1; _ = i; }",
                "fn a(){for(var a=0;a<3;a++){let b=a;_=b;}for(var a=0;a<3;a++){_=a;}let a=1;_=a;}",
            ),
            // Of a struct: names of components stay, behind every dot.
            (
                "struct S { value: f32, x: f32, rest: vec2f, } fn f(s: S) -> f32 { return s.value + s.x + s.rest.x; }",
                "struct b{c:f32,x:f32,d:vec2f}fn a(a:b)->f32{return a.c+a.x+a.d.x;}",
            ),
            // What WGSL owns is no name of ours, unless the module declares it.
            ("fn mix(a: f32) -> f32 { return max(a, 1.0); }", "fn a(a:f32)->f32{return max(a,1.);}"),
            (
                "var<private> state: vec2<f32> = vec2<f32>(); fn f() { state.x = .5; }",
                "var<private>a:vec2<f32> =vec2<f32>();fn b(){a.x=.5;}",
            ),
        ];
        for (long, expected) in all {
            assert_eq!(short(long), expected, "{long}");
        }
    }

    #[test]
    fn what_the_host_knows_by_name_keeps_it() {
        let all = [
            "override gain:f32=1.;",
            "struct a{gain:f32,inner:b}struct b{deep:vec4f}@group(0)@binding(0)var<uniform>params:a;",
            "@group(0)@binding(1)var image:texture_storage_2d<rgba8unorm,write>;",
            "@id(7)override scale:f32;",
        ];
        for kept in all {
            assert_eq!(short(kept), kept);
        }
        // Nothing but locals, where nothing is an entry point.
        assert_eq!(
            minify_text(
                "const HALF = 0.50; struct S { size: f32 } fn area(s: S) -> f32 { let side = s.size; return side * side * HALF; }"
            ),
            "const HALF=.5;struct S{size:f32}fn area(b:S)->f32{let a=b.size;return a*a*HALF;}"
        );
    }

    #[test]
    fn what_says_nothing_goes_and_what_would_be_read_otherwise_keeps_its_space() {
        let all = [
            ("fn f(a: f32, b: f32,) -> f32 { return a - -b; }", "fn a(a:f32,b:f32)->f32{return a- -b;}"),
            (
                "fn f(p: ptr<function, f32>) -> f32 { return 2.0 / *p; } /* done */",
                "fn a(a:ptr<function,f32>)->f32{return 2./ *a;}",
            ),
            ("fn f() { ; { } ; for (;;) { break; } ; }", "fn a(){{}for(;;){break;}}"),
            (
                "struct S { a: f32, }; /* gone /* twice */ */ const_assert 1 < 2;",
                "struct a{a:f32}const_assert 1<2;",
            ),
            (
                "fn f(a: bool, b: bool) -> bool { return a && !b; }",
                "fn a(a:bool,b:bool)->bool{return a&&!b;}",
            ),
            (
                "enable f16; diagnostic(off, derivative_uniformity); alias half = f16;",
                "enable f16;diagnostic(off,derivative_uniformity);alias a=f16;",
            ),
        ];
        for (long, expected) in all {
            assert_eq!(short(long), expected, "{long}");
        }
    }
}

//! Large input is composed in time that grows with its size, and hostile input is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use orogen::{Bake, Compose, Error, Library, Preset};

/// Composes and bakes, and leaves naga out.
fn bake(library: &Library, root: &str) -> Result<usize, Error> {
    let baked = Compose::default().bake(library, &Preset::of_module(root), &Bake::live(["*"]))?;
    Ok(baked.text.len())
}

#[test]
fn thousands_of_instances_compose() {
    // A binary tree: every level includes the next one twice, each time as an instance of its own.
    let leaf = "#param leaf.x: f32 = 1.0\nfn f() -> f32 { return leaf.x; }\n";
    let library = (0..12).fold(Library::empty().with_file("tree12.wgsl", leaf), |library, n| {
        let next = n + 1;
        let includes = format!("#include <tree{next}.wgsl> as l\n#include <tree{next}.wgsl> as r\n");
        library.with_file(format!("tree{n}.wgsl"), includes + "fn f() -> f32 { return l_f() + r_f(); }\n")
    });
    assert!(bake(&library, "tree0.wgsl").unwrap() > 100_000);
}

#[test]
fn a_function_with_thousands_of_locals_and_reads_composes() {
    let params: String = (0..3000).map(|n| format!("#param g.p{n}: f32 = 1.0\n")).collect();
    let body: String = (0..3000).map(|n| format!("    let a{n} = g.p{n} + g.p{};\n", 2999 - n)).collect();
    let library = Library::empty().with_file("wide.wgsl", format!("{params}fn f() {{\n{body}}}\n"));
    bake(&library, "wide.wgsl").unwrap();
}

#[test]
fn thousands_of_directives_and_includes_compose() {
    let shared: String =
        (0..3000).map(|n| format!("#option o.o{n} = {n}\n#if o.o{n} == {n}\n#endif\n")).collect();
    let mut library = Library::empty().with_file("shared.wgsl", shared);
    let mut root = String::new();
    for n in 0..3000 {
        library = library.with_file(
            format!("m{n}.wgsl"),
            format!("diagnostic(off, a.r{n});\n#include <shared.wgsl>\nfn f{n}() {{}}\n"),
        );
        root += &format!("#include <m{n}.wgsl>\n");
    }
    root += "@compute @workgroup_size(1) fn main() {\n";
    root += &(0..3000).map(|n| format!("    f{n}();\n")).collect::<String>();
    bake(&library.with_file("root.wgsl", root + "}\n"), "root.wgsl").unwrap();
}

#[test]
fn a_thousand_includes_one_below_the_other_compose() {
    let library =
        Library::empty().with_file("m1000.wgsl", "fn level1000(x: f32) -> f32 {\n    return x;\n}\n");
    let library = (0..1000).fold(library, |library, n| {
        let next = n + 1;
        let call = format!("fn level{n}(x: f32) -> f32 {{\n    return 0.5 * level{next}(x + 1.0);\n}}\n");
        library.with_file(format!("m{n}.wgsl"), format!("#include <m{next}.wgsl>\n\n{call}"))
    });
    let main = "@fragment\nfn main() -> @location(0) vec4f {\n    return vec4f(level0(1.0));\n}\n";
    let library = library.with_file("root.wgsl", format!("#include <m0.wgsl>\n\n{main}"));
    let shader = orogen::compose(&library, &Preset::of_module("root.wgsl"), &Bake::constants()).unwrap();
    assert!(shader.wgsl().contains("fn level1000("));
}

#[test]
fn thousands_of_faults_are_told() {
    let missing: String = (0..20_000).map(|n| format!("#include <missing{n}.wgsl>\n")).collect();
    let unknown: String = (0..5_000).map(|n| format!("#if unknown{n}.option\n#endif\n")).collect();
    let members: String = (0..5_000).map(|n| format!("    _ = g.unlike{n};\n")).collect();
    let knobs: String =
        (0..2_000).map(|n| format!("#param g.parameter{n}: f32 = 1.0\n#option h.option{n} = 1\n")).collect();
    for text in [
        missing,
        format!("{knobs}{unknown}"),
        format!("{knobs}fn f() {{\n{members}}}\n"),
        "#nonsense\n".repeat(50_000),
    ] {
        let error = bake(&Library::empty().with_file("bad.wgsl", text), "bad.wgsl").unwrap_err();
        assert!(error.render(false).len() < 1 << 20);
    }
}

#[test]
fn long_names_do_not_grow_with_depth_without_bound() {
    let name = "n".repeat(100_000);
    let text = format!("#include \"self.wgsl\" as {name}\nconst A = 1;\n");
    let error = bake(&Library::empty().with_file("self.wgsl", text), "self.wgsl").unwrap_err();
    assert_eq!(error.diagnostics()[0].code, "OR0305");
}

#[test]
fn a_fault_in_a_very_long_line_is_told_in_few_words() {
    let many: String = (0..40_000).map(|n| format!("g.x{n}+")).collect();
    let text = format!("#param g.a: f32 = 1.0\nfn f() -> f32 {{ return {many} g.a; }}\n");
    let error = bake(&Library::empty().with_file("long.wgsl", text), "long.wgsl").unwrap_err();
    assert!(error.render(false).len() < 1 << 20, "{}", error.render(false).len());
}

#[test]
fn deeply_nested_expressions_come_back_as_an_error() {
    for text in [
        format!("const A = {}1{};\n", "(".repeat(100_000), ")".repeat(100_000)),
        format!("fn f() {{ {} }}\n", "{".repeat(100_000)),
        format!("const A: {}f32{} = 1;\n", "array<".repeat(100_000), ">".repeat(100_000)),
        format!("const A = {}1;\n", "-".repeat(100_000)),
        format!("const A = 1{};\n", " + 1".repeat(20_000)),
    ] {
        let _ = orogen::compose(&Library::empty(), &Preset::of_text("deep.wgsl", &text), &Bake::constants());
    }
}

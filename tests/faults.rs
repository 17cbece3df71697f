//! The rendered text of every fault of `check`, `export` and `render`: those that an input provokes, and those that only a
//! broken driver, a full machine or a panic of naga would.
//!
//! `tests/errors` has those of all other stages. `UPDATE=1` writes the texts anew; read the change before you commit it.

#![cfg(feature = "render")]

use std::path::Path;

use orogen::build::Bindings;
use orogen::check::Panicked;
use orogen::export::{ExportError, LibraryStyle, Stage, Target, export_entry, library_package};
use orogen::render::RenderError;
use orogen::{Bake, Compose, Error, Library, Prefix, Preset, Templates};

/// Holds the text of `error` against the file of that name.
fn expect(name: &str, error: impl Into<Error>) {
    let (path, text) =
        (Path::new("tests/faults").join(name).with_extension("txt"), error.into().render(false));
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, &text).expect("the folder is there");
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(text, expected, "{} differs; UPDATE=1 writes it anew", path.display());
}

/// What `source` meets on its way to `target`.
fn refused(source: &str, target: Target, entry: Option<&str>) -> Error {
    let mut composer = Compose::default();
    composer.stage = target.stage(None).expect("each target has a stage");
    let preset = Preset::of_text("scene.wgsl", source);
    let shader =
        composer.run(&Library::standard(), &preset, &target.bake(Bake::constants())).expect("it is valid");
    export_entry(&shader, target, entry, &Templates::standard()).expect_err("the target cannot have it")
}

#[test]
fn what_a_target_lacks_is_told_at_its_place() {
    let in_main =
        |value: &str| format!("fn main_image(p: vec2f) -> vec4f {{\n    return vec4f({value});\n}}\n");
    let fragment = |takes: &str| {
        format!("@fragment\nfn main({takes}) -> @location(0) vec4f {{\n    return vec4f(1.0);\n}}\n")
    };
    let texture = "@group(1) @binding(0) var map: texture_2d<f32>;\n\n".to_owned()
        + &in_main("textureLoad(map, vec2u(p), 0).x");
    expect("not-in-es300", refused(&texture, Target::Glsl, None));
    expect("cannot-be-wrapped", refused(&fragment("@location(0) uv: vec2f"), Target::Shadertoy, None));
    let bound = "@group(1) @binding(0) var<uniform> tint: vec4f;\n\n".to_owned() + &in_main("tint.x");
    expect("nothing-is-bound-there", refused(&bound, Target::Shadertoy, None));
    expect("no-entry-point", refused("fn f() {}\n", Target::Glsl, None));
    expect("no-entry-point-of-that-name", refused(&fragment(""), Target::Glsl, Some("mian")));
    let gain = "override gain: f32;\n\n".to_owned() + &in_main("gain");
    expect("an-override-without-a-default", refused(&gain, Target::Spirv, None));
    let storage = "@group(1) @binding(0) var<storage> a: array<vec4f>;\n\n".to_owned() + &in_main("a[0].x");
    expect("no-storage-in-es300", refused(&storage, Target::Glsl, None));
    let why = "feature Features(SUBGROUP_OPERATIONS) is not supported".into();
    expect("naga-cannot-write-it", ExportError::Writer { target: Target::Hlsl, why });
    expect("no-such-target", "glls".parse::<Target>().expect_err("there is none"));
    let why = "index out of bounds".into();
    expect("orogen-failed", ExportError::Fault { target: Target::Glsl, why });
    expect("cannot-be-minified", ExportError::NotMinified { target: Target::Msl });
    let why = "no definition in scope for identifier: `a`".into();
    expect("minified-is-not-valid", ExportError::Minifier { why });
    expect("a-folder-is-not-one-file", refused(&in_main("1.0"), Target::Wesl, None));
    expect("no-such-stage", Target::Glsl.stage(Some(Stage::Compute)).expect_err("there is none"));
}

#[test]
fn what_modules_and_bindings_cannot_be_is_told() {
    let prefixed = {
        let mut composer = Compose::default();
        composer.prefix = Prefix::new("og_").expect("names can start so");
        composer.stage = Stage::MainImage;
        let preset =
            Preset::of_text("scene.wgsl", "fn main_image(p: vec2f) -> vec4f {\n    return vec4f(1.0);\n}\n");
        composer.run(&Library::standard(), &preset, &Bake::constants()).expect("it is valid")
    };
    let export = export_entry(&prefixed, Target::Shadertoy, None, &Templates::standard());
    expect("no-prefix-there", export.expect_err("the target calls by name"));
    let bindings = Bindings::new(Preset::of_text("scene.wgsl", "fn f() {}\n"));
    let written = bindings.write_to("no/such/folder", "scene").err().expect("there is no such folder");
    expect("bindings-cannot-be-written", written);
}

#[test]
fn what_cannot_be_left_open_is_told_at_its_place() {
    let whole = |text: &str| {
        let library = Library::empty().with_file("land.wgsl", text);
        library_package(&library, &LibraryStyle::default(), &Templates::standard())
            .expect_err("WESL cannot say it")
    };
    let cut = "#option land.high = true\n\nfn height() -> f32 {\n    return 1.0\n#if land.high\n        + 2.0\n#endif\n    ;\n}\n";
    expect("a-condition-in-the-middle", whole(cut));
    let head = "#option land.high = true\n\n#if land.high\nfn height() -> f32 {\n#else\nfn depth() -> f32 {\n#endif\n    return 1.0;\n}\n";
    expect("a-condition-around-half-a-function", whole(head));
    let many = "#option land.a = 1, range 1 .. 100\n#option land.b = 1, range 1 .. 100\n\n#if land.a < land.b\nconst HIGH = true;\n#endif\n";
    expect("too-many-values-apart", whole(many));
}

#[test]
fn a_panic_of_nagas_is_told_as_one() {
    let why = "index out of bounds: the len is 3 but the index is 7";
    expect("naga-panics-while-checking", Panicked(why.into()));
    expect("naga-panics-while-writing", ExportError::Panic { target: Target::Msl, why: why.into() });
}

#[test]
fn what_goes_wrong_with_a_gpu_says_what_to_do() {
    let found = ["llvmpipe (LLVM 15.0.6, 256 bits)".into(), "Voodoo 3".into()].into();
    expect("no-such-adapter", RenderError::UnknownAdapter { name: "Voodoo 2".into(), found });
    let why = "the driver is older than its kernel module".to_owned();
    expect("the-adapter-does-not-open", RenderError::Device { adapter: "Voodoo 3".into(), why });
    expect("the-device-is-lost", RenderError::Lost("the driver was reset".into()));
    expect("out-of-memory", RenderError::OutOfMemory);
    expect(
        "refused",
        RenderError::Refused("In Device::create_render_pipeline\n  the target is no colour".into()),
    );
    expect("wgpu-panics", RenderError::Panicked("a lock was poisoned".into()));
    expect("not-encoded", RenderError::Encode("the picture is too large for a PNG".into()));
}

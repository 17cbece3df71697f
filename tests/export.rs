//! What `export` writes, judged by other people's tools: naga reads the WGSL again, glslang the GLSL, spirv-val the SPIR-V.

#![expect(clippy::panic, reason = "a test says what it found")]

use std::path::{Path, PathBuf};
use std::process::Command;

use orogen::export::{Stage, Target, export, export_entry, source_map};
use orogen::source::Span;
use orogen::{Bake, Compose, Error, Library, Preset, Shader, Templates};

const PRESETS: [&str; 3] = ["alpine", "canyon", "dunes"];
const SHADERTOY_PAGE: &str = include_str!("../xtask/src/shadertoy.frag");

fn compose(preset: &Preset, target: Target, bake: Bake) -> Result<Shader, Error> {
    let mut compose = Compose::default();
    compose.stage = target.stage(None)?;
    compose.run(&Library::standard(), preset, &target.bake(bake))
}

fn write(preset: &Preset, target: Target, bake: Bake) -> Result<Vec<u8>, Error> {
    export(&compose(preset, target, bake)?, target, &Templates::standard())
}

fn text_of(source: &str, target: Target) -> Result<String, Error> {
    let bytes = write(&Preset::of_text("test.wgsl", source), target, Bake::default())?;
    Ok(String::from_utf8(bytes).expect("is text"))
}

fn error_of(source: &str, target: Target) -> Error {
    text_of(source, target).expect_err("must be refused")
}

fn code_of(source: &str, target: Target) -> String {
    error_of(source, target).diagnostics()[0].code.to_owned()
}

fn file(name: &str, bytes: &[u8]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("the test's folder can be written to");
    path
}

fn judge(tool: &str, arguments: &[&str], path: &Path) {
    let output = Command::new(tool).args(arguments).arg(path).output().unwrap_or_else(|why| {
        panic!(
            "`{tool}` cannot be run ({why}): install glslang-tools and spirv-tools, or run `cargo xtask test`"
        )
    });
    let said =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{tool} refuses {}:\n{said}", path.display());
}

fn glslang(name: &str, text: &str) {
    judge("glslangValidator", &["-S", "frag"], &file(name, text.as_bytes()));
}

fn on_shadertoy(name: &str, text: &str) {
    glslang(name, &format!("{SHADERTOY_PAGE}#line 1\n{text}"));
}

fn bakes() -> [(&'static str, Bake); 3] {
    [
        ("const", Bake::constants()),
        ("override", Bake::constants().with_overrides(["*"])),
        ("uniform", Bake::live(["*"])),
    ]
}

#[test]
fn every_preset_is_written_for_every_target_and_the_judges_agree() {
    for name in PRESETS {
        for (bake_name, bake) in bakes() {
            for target in Target::ALL.into_iter().filter(|target| target.is_one_file()) {
                let preset = Preset::named(name).expect("is built in");
                let bytes = write(&preset, target, bake.clone()).expect("is written");
                let file_name = format!("{name}.{bake_name}.{}", target.extension());
                let path = file(&file_name, &bytes);
                let text = || String::from_utf8(bytes.clone()).expect("is text");
                match target {
                    Target::Glsl => judge("glslangValidator", &["-S", "frag"], &path),
                    Target::Spirv => judge("spirv-val", &["--target-env", "vulkan1.1"], &path),
                    Target::Shadertoy => on_shadertoy(&format!("{file_name}.page.frag"), &text()),
                    Target::Json => {
                        drop(serde_json::from_str::<serde_json::Value>(&text()).expect("is JSON"))
                    }
                    Target::Isf | Target::ComputeToys => {} // tests/glsl_hosts.rs knows what surrounds them
                    Target::Wesl => {}                      // tests/wesl compiles it
                    Target::Wgsl | Target::Hlsl | Target::Msl | Target::Rust => {
                        assert!(text().starts_with(&format!("// {name}: ")));
                        assert!(!text().contains("\n\n\n"), "{file_name} has two empty lines in a row");
                        assert!(text().ends_with('\n'));
                    }
                }
            }
        }
    }
}

#[test]
fn the_header_keeps_to_its_width_and_states_every_licence() {
    let text = String::from_utf8(
        write(&Preset::named("alpine").expect("is built in"), Target::Wgsl, Bake::default())
            .expect("is written"),
    )
    .expect("is text");
    let header: Vec<&str> = text.lines().take_while(|line| line.starts_with("//")).collect();
    assert!(header.iter().all(|line| line.chars().count() <= 120), "{header:#?}");
    let header = header.join("\n");
    assert!(header.contains("MIT OR Apache-2.0: "), "{header}");
    assert!(header.contains("quality = high"), "{header}");
    assert!(!header.contains("not stated"), "{header}");
}

#[test]
fn a_glsl_file_starts_with_its_version() {
    let text =
        text_of("fn main_image(p: vec2f) -> vec4f { return p.xyxy; }", Target::Glsl).expect("is written");
    assert!(text.starts_with("#version 300 es\n// test.wgsl\n"), "{text}");
}

#[test]
fn a_target_is_found_by_its_name_and_a_wrong_one_gets_the_nearest() {
    for target in Target::ALL {
        assert_eq!(target.name().parse::<Target>().expect("is one"), target);
    }
    let error = "glls".parse::<Target>().expect_err("is none");
    assert_eq!(error.diagnostics()[0].code, "OR0803");
    assert_eq!(error.diagnostics()[0].help.as_deref(), Some("did you mean `glsl`?"));
    let stage = Target::Glsl.stage(Some(Stage::Compute)).expect_err("has none");
    assert_eq!(stage.diagnostics()[0].code, "OR0804");
}

#[test]
fn what_es300_lacks_is_refused_at_the_authors_place() {
    let cases = [
        ("`textureLoad`", "textureLoad(map, vec2u(p), 0).x"),
        ("a variable in `storage`", "numbers.a"),
        ("an array whose length is not fixed", "rows[0]"),
    ];
    let bound = "@group(0) @binding(0) var map: texture_2d<f32>;\n\
        struct Numbers { a: f32 }\n\
        @group(0) @binding(1) var<storage> numbers: Numbers;\n\
        @group(0) @binding(2) var<storage> rows: array<f32>;\n";
    for (what, value) in cases {
        let source = format!(
            "{bound}fn inner(p: vec2f) -> f32 {{\n    return {value};\n}}\nfn main_image(p: vec2f) -> vec4f {{ return vec4f(inner(p)); }}"
        );
        let error = error_of(&source, Target::Glsl);
        let diagnostic = &error.diagnostics()[0];
        assert_eq!(diagnostic.code, "OR0806", "{error}");
        assert!(diagnostic.message.contains(what) && diagnostic.help.is_some(), "{error}");
        assert_eq!(code_of(&source, Target::Shadertoy), "OR0808", "it cannot bind anything");
        let unused = format!(
            "{bound}fn unused(p: vec2f) -> f32 {{ return {value}; }}\nfn main_image(p: vec2f) -> vec4f {{ return p.xyxy; }}"
        );
        assert!(text_of(&unused, Target::Glsl).is_ok(), "what is not reached does not matter");
    }
}

#[test]
fn what_es300_has_is_written_so_that_glslang_agrees() {
    let values = [
        "sinh(p.x) + cosh(p.x) + tanh(p.x) + asinh(p.x) + acosh(p.x) + atanh(p.x)",
        "atan2(p.x, p.y) + fma(p.x, 2.0, 1.0) + sign(p.x) + trunc(p.x) + round(p.x)",
        "modf(p.x).whole + saturate(p.x) + degrees(p.x) + inverseSqrt(p.x) + step(0.5, p.x)",
        "select(p, vec2f(1.0), p < vec2f(1.0)).x + select(1.0, 2.0, p.x < 1.0)",
        "f32(select(1, 2, p.x < 1.0)) + f32(pack2x16snorm(p)) + unpack2x16unorm(u32(p.x)).x",
        "f32(abs(vec2i(p)).x) + f32(min(vec2i(p), vec2i(3)).y) + f32(dot(vec2i(p), vec2i(1)))",
        "f32(clamp(vec3u(p.xyx), vec3u(1), vec3u(9)).x % 3u) + (p.x % 2.0) + f32(i32(p.x) / i32(p.y))",
        "determinant(mat3x3f(p.xyx, p.yxy, p.xxy)) + transpose(mat2x2f(p, p))[0].y + outer(p)",
        "bitcast<f32>(bitcast<u32>(p.x) >> 1u) + f32(~u32(p.x)) + f32(any(p > vec2f()))",
        "refract(p, p, 0.5).x + reflect(p, p).x + faceForward(p, p, p).y + length(p) + distance(p, p)",
    ];
    for (index, value) in values.into_iter().enumerate() {
        let source = format!(
            "fn outer(p: vec2f) -> f32 {{ return p.x; }}\nfn main_image(p: vec2f) -> vec4f {{ return vec4f({value}); }}"
        );
        match text_of(&source, Target::Glsl) {
            Ok(text) => glslang(&format!("built_ins_{index}.frag"), &text),
            Err(error) => panic!("{error}"),
        }
    }
}

#[test]
fn names_on_shadertoy_are_the_authors_but_for_those_that_are_taken() {
    let source = "#include <frame.wgsl>\n/// How much.\n#param g.gain2: f32 = 0.5, range 0 .. 1, live\nconst iTime = 3.0;\n\
        fn noise2(p: vec2f) -> f32 { let x1 = p.x + iTime * p.y; return x1 * x1; }\n\
        fn iResolution(fragColor: f32) -> f32 { return fragColor; }\n\
        fn mainImage(float: f32) -> f32 { var mix = float; mix += 1.0; return mix; }\n\
        struct S { x2: f32, in: f32 }\n\
        fn main_image(p: vec2f) -> vec4f { let s = S(p.x, p.y); return vec4f(noise2(p / frame.resolution), g.gain2, iResolution(s.x2), mainImage(s.in + frame.time + f32(frame.index))); }";
    let text = String::from_utf8(
        write(
            &Preset::of_text("test.wgsl", &source.replace("in:", "input:").replace("s.in", "s.input")),
            Target::Shadertoy,
            Bake::live(["g.*"]),
        )
        .expect("is written"),
    )
    .expect("is text");
    on_shadertoy("names.frag", &text);
    assert!(text.contains("float noise2(vec2 p)"), "{text}");
    assert!(text.contains("\n/// How much.\nfloat g_gain2 = 0.5;  // 0 .. 1\n"), "{text}");
    assert!(text.contains("s.input_ + iTime + float(uint(iFrame))"), "{text}");
    assert!(!text.contains("frame_") && !text.contains("uniform") && !text.contains("#version"), "{text}");
}

#[test]
fn an_entry_point_of_ones_own_is_wrapped_for_shadertoy_or_refused() {
    let good = "@fragment fn main(@builtin(position) at: vec4f) -> @location(0) vec4f { return at / 100.0; }";
    let text = text_of(good, Target::Shadertoy).expect("is written");
    assert!(text.contains("iResolution.y - fragCoord.y"), "{text}");
    on_shadertoy("own_entry.frag", &text);
    let none = "@fragment fn main() -> @location(0) vec4f { return vec4f(1.0); }";
    on_shadertoy("no_position.frag", &text_of(none, Target::Shadertoy).expect("is written"));
    for bad in [
        "@fragment fn main(@location(0) uv: vec2f) -> @location(0) vec4f { return uv.xyxy; }",
        "@fragment fn main() -> @location(0) vec2f { return vec2f(1.0); }",
        "@fragment fn main() -> @location(1) vec4f { return vec4f(1.0); }",
    ] {
        assert_eq!(code_of(bad, Target::Shadertoy), "OR0807", "{bad}");
    }
    let bound = "@group(0) @binding(0) var<uniform> a: vec4f; fn main_image(p: vec2f) -> vec4f { return a; }";
    assert_eq!(code_of(bound, Target::Shadertoy), "OR0808");
    let module = "fn f() {}";
    assert_eq!(code_of(module, Target::Glsl), "OR0805");
    let compute = "@compute @workgroup_size(1) fn main() {}";
    assert_eq!(code_of(compute, Target::Shadertoy), "OR0805");
}

#[test]
fn the_entry_point_is_the_first_or_the_one_that_is_named() {
    let source = "@fragment fn one() -> @location(0) vec4f { return vec4f(1.0); }\n@fragment fn two() -> @location(0) vec4f { return vec4f(2.0); }";
    let shader =
        compose(&Preset::of_text("test.wgsl", source), Target::Glsl, Bake::default()).expect("is composed");
    let write = |name| {
        export_entry(&shader, Target::Glsl, name, &Templates::standard())
            .map(|bytes| String::from_utf8(bytes).expect("is text"))
    };
    assert!(write(None).expect("is written").contains("vec4(1.0)"));
    assert!(write(Some("two")).expect("is written").contains("vec4(2.0)"));
    let error = write(Some("three")).expect_err("there is none");
    assert_eq!(error.diagnostics()[0].help.as_deref(), Some("choose `one` or `two`"), "{error}");
}

#[test]
fn an_override_without_a_default_is_an_error_for_targets_that_have_none() {
    let source = "override gain: f32; @fragment fn main() -> @location(0) vec4f { return vec4f(gain); }";
    for target in [Target::Spirv, Target::Hlsl, Target::Msl] {
        assert_eq!(code_of(source, target), "OR0809", "{target}");
    }
    for target in [Target::Glsl, Target::Shadertoy] {
        assert_eq!(code_of(source, target), "OR0806", "{target}"); // at its place
    }
    assert!(text_of(source, Target::Wgsl).is_ok());
}

#[test]
fn a_file_that_is_wgsl_already_passes_through() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/export/passthrough");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("is there") {
        let path = entry.expect("can be read").path();
        let source = std::fs::read_to_string(&path).expect("is text");
        let preset = Preset::of_file(&path);
        let run = |keep_unused| {
            let mut compose = Compose::default();
            compose.keep_unused = keep_unused;
            compose.run(&Library::standard(), &preset, &Bake::default()).expect("naga accepts it")
        };
        let whole = run(true);
        let header = whole.wgsl().strip_suffix(source.as_str());
        let header =
            header.unwrap_or_else(|| panic!("{} is not as it was:\n{}", path.display(), whole.wgsl()));
        assert!(header.lines().all(|line| line.starts_with("//")) && header.ends_with('\n'), "{header}");
        let (ours, theirs) = (compacted(run(false).wgsl()), compacted(&source));
        let difference = ours.lines().zip(theirs.lines()).find(|(ours, theirs)| ours != theirs);
        assert_eq!(difference, None, "{}", path.display());
        assert_eq!(ours.len(), theirs.len(), "{}", path.display());
        count += 1;
    }
    assert!(count >= 12);
}

/// naga's module of `source` without what no entry point reaches, spans left out.
fn compacted(source: &str) -> String {
    let mut module = naga::front::wgsl::parse_str(source).expect("naga parses it");
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    module.diagnostic_filters = naga::Arena::new(); // their debug text has spans in it
    let text = format!("{module:#?}");
    let is_span = |line: &&str| ["start: ", "end: "].iter().any(|field| line.trim_start().starts_with(field));
    text.lines().filter(|line| !is_span(line)).collect::<Vec<_>>().join("\n")
}

/// One mapping of a decoded source map: line and column in the result; source, line and column, where there is an origin.
type Mapping = (usize, usize, Option<(usize, usize, usize)>);

fn decoded(mappings: &str) -> Vec<Mapping> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut from = [0i64; 3];
    let mut all = Vec::new();
    for (line, segments) in mappings.split(';').enumerate() {
        let mut column = 0;
        for segment in segments.split(',').filter(|segment| !segment.is_empty()) {
            let (mut numbers, mut value, mut shift) = (Vec::new(), 0, 0);
            for digit in segment.chars() {
                let digit = DIGITS.find(digit).expect("is a digit") as i64;
                value |= (digit & 31) << shift;
                shift += 5;
                if digit & 32 == 0 {
                    numbers.push(if value & 1 == 1 { -(value >> 1) } else { value >> 1 });
                    (value, shift) = (0, 0);
                }
            }
            column += numbers[0];
            let origin = (numbers.len() == 4).then(|| {
                from.iter_mut().zip(&numbers[1..]).for_each(|(at, by)| *at += by);
                (from[0] as usize, from[1] as usize, from[2] as usize)
            });
            all.push((line, column as usize, origin));
        }
    }
    all
}

/// The byte at a line and a column in UTF-16 code units, both from 0.
fn byte_at(text: &str, line: usize, column: usize) -> usize {
    let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
    let mut units = 0;
    for (at, c) in text[start..].char_indices() {
        if units == column {
            return start + at;
        }
        units += c.len_utf16();
    }
    assert_eq!(units, column);
    text.len()
}

#[test]
fn the_source_map_agrees_with_the_map_in_memory() {
    let library = Library::standard().with_file(
        "höhe.wgsl",
        "#param h.a: f32 = 1.0\n/* 🏔 */ fn höhe(x: f32) -> f32 { /* 🏔🏔 */ return x * h.a; }\n",
    );
    let text = "#include <höhe.wgsl>\n#include <noise/perlin.wgsl>\n\nfn main_image(p: vec2f) -> vec4f { /* é🏔 */ return vec4f(höhe(perlin_noise2(p, 3u))); }\n";
    let presets = [Preset::of_text("test.wgsl", text), Preset::named("canyon").expect("is built in")];
    for preset in presets {
        let shader = orogen::compose(&library, &preset, &Bake::live(["*"])).expect("is composed");
        let map: serde_json::Value = serde_json::from_str(&source_map(&shader, "out.wgsl")).expect("is JSON");
        assert_eq!((&map["version"], &map["file"]), (&3.into(), &"out.wgsl".into()));
        let mappings = decoded(map["mappings"].as_str().expect("is text"));
        assert!(mappings.len() > 100);
        assert!(mappings.is_sorted_by_key(|(line, column, _)| (*line, *column)));
        let files = &shader.checked().baked.composition.files;
        let step = mappings.len().div_ceil(2000);
        for (line, column, origin) in mappings.iter().step_by(step) {
            let Some((source, from_line, from_column)) = *origin else { continue };
            let at = byte_at(shader.wgsl(), *line, *column);
            let expected = shader.checked().baked.map.origin(Span::new(at, at + 1)).expect("is somebody's");
            let file = files.get(expected.file);
            assert_eq!(map["sources"][source], *file.name);
            let content = map["sourcesContent"][source].as_str().expect("is text");
            assert_eq!(content, &*file.text);
            assert_eq!(byte_at(content, from_line, from_column), expected.span.start as usize);
        }
    }
}

#[test]
fn the_json_names_what_a_host_needs() {
    let bytes = write(&Preset::named("alpine").expect("is built in"), Target::Json, Bake::live(["sun.*"]))
        .expect("is written");
    let json: serde_json::Value = serde_json::from_slice(&bytes).expect("is JSON");
    assert_eq!(json["name"], "alpine");
    assert_eq!(json["options"]["quality"], "high");
    let parameters = json["parameters"].as_array().expect("is a list");
    let elevation = parameters.iter().find(|one| one["key"] == "sun.elevation").expect("is there");
    assert_eq!(elevation["storage"], "uniform");
    assert_eq!(elevation["unit"], "deg");
    assert!(elevation["doc"].as_str().is_some_and(|doc| !doc.is_empty()));
    assert!(json["uniform"]["fields"].as_array().is_some_and(|fields| !fields.is_empty()));
    assert_eq!(json["entry_points"][1]["stage"], "fragment");
}

//! What is judged: which files `orogen` is to write, of each preset, view and module, and who judges them.

use std::path::{Path, PathBuf};

use crate::run::{Outcome, create_folder, read, root, write};

/// Who judges a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Judge {
    /// `tests/judges/tint.mjs`, all its files in one go.
    Tint,
    /// glslangValidator.
    Glslang,
    /// glslangValidator, on the file inside what Shadertoy puts around it.
    GlslangInShadertoy,
    /// spirv-val.
    SpirvVal,
}

/// One file to be written and judged.
#[derive(Debug)]
pub(crate) struct Case {
    pub(crate) judge: Judge,
    /// Where it goes, in the folder of all files that are judged.
    pub(crate) file: PathBuf,
    /// What makes `orogen` write it, less `-o`.
    pub(crate) export: Vec<String>,
}

/// The three bakings: every parameter a constant, an override, or a field of the uniform buffer.
pub(crate) const CONST: (&str, &[&str]) = ("const", &[]);
const OVERRIDE: (&str, &[&str]) = ("override", &["--overrides", "*"]);
pub(crate) const UNIFORM: (&str, &[&str]) = ("uniform", &["--live", "*"]);

/// Everything that is judged of one preset.
pub(crate) fn of_preset(preset: &str) -> Vec<Case> {
    let case = |judge, name: &str, flags: &[&[&str]]| {
        let flags = flags.concat().into_iter().map(str::to_owned);
        let export = ["export".to_owned(), preset.to_owned()].into_iter().chain(flags).collect();
        Case { judge, file: format!("{preset}.{name}").into(), export }
    };
    let mut cases = Vec::new();
    for stage in ["fragment", "compute"] {
        for (baking, flags) in [CONST, OVERRIDE, UNIFORM] {
            cases.push(case(Judge::Tint, &format!("{stage}.{baking}.wgsl"), &[&["--stage", stage], flags]));
        }
    }
    // naga settles overrides before it writes GLSL or SPIR-V: what comes out is the first of these two.
    for (baking, flags) in [CONST, UNIFORM] {
        cases.push(case(Judge::Glslang, &format!("{baking}.frag"), &[&["--target", "glsl"], flags]));
        cases.push(case(Judge::SpirvVal, &format!("{baking}.spv"), &[&["--target", "spirv"], flags]));
    }
    cases.push(case(Judge::GlslangInShadertoy, "shadertoy.frag", &[&["--target", "shadertoy"]]));
    const MINIFY: &[&str] = &["--minify"];
    for (baking, flags) in [CONST, OVERRIDE, UNIFORM] {
        cases.push(case(Judge::Tint, &format!("minified.{baking}.wgsl"), &[MINIFY, flags]));
    }
    cases.push(case(Judge::Glslang, "minified.frag", &[MINIFY, &["--target", "glsl"]]));
    cases.push(case(
        Judge::GlslangInShadertoy,
        "minified.shadertoy.frag",
        &[MINIFY, &["--target", "shadertoy"]],
    ));
    cases
}

/// The preset that a view is judged with: one whose scene has what it shows.
pub(crate) fn seen_in(view: &str) -> &'static str {
    if view.starts_with("cloud_") { "cumulus" } else { "alpine" }
}

/// What is judged of a picture of everything around: WGSL and GLSL.
pub(crate) fn of_projection(projection: &str, preset: &str) -> Vec<Case> {
    let case = |judge, name: &str, flags: &[&str]| {
        let option = format!("camera.projection={projection}");
        let words = ["export", preset, "--set", &option].into_iter().chain(flags.iter().copied());
        Case {
            judge,
            file: format!("{preset}_{projection}.{name}").into(),
            export: words.map(str::to_owned).collect(),
        }
    };
    vec![
        case(Judge::Tint, "fragment.uniform.wgsl", UNIFORM.1),
        case(Judge::GlslangInShadertoy, "shadertoy.frag", &["--target", "shadertoy"]),
    ]
}

/// What is judged of a debug view: that it fits a preset, as constants and live.
pub(crate) fn of_view(view: &str, preset: &str) -> Vec<Case> {
    let case = |(baking, flags): (&str, &[&str])| {
        let words = ["export", preset, "--view", view].into_iter().chain(flags.iter().copied());
        Case {
            judge: Judge::Tint,
            file: format!("{preset}_{view}.fragment.{baking}.wgsl").into(),
            export: words.map(str::to_owned).collect(),
        }
    };
    [CONST, UNIFORM].map(case).into()
}

/// A module of the library, judged on its own. A generic one is judged as an instance whose slots return zero; the file
/// that makes the instance is put into `hosts`.
pub(crate) fn of_module(module: &str, hosts: &Path) -> Outcome<Case> {
    let source = read(&root().join("wgsl").join(module))?;
    let module_or_host = match instance(module, &source) {
        None => format!("<{module}>"),
        Some(text) => {
            let host = hosts.join(module);
            create_folder(host.parent().unwrap_or(hosts))?;
            write(&host, &text)?;
            host.display().to_string()
        }
    };
    let export = vec!["export".to_owned(), module_or_host, "--keep-unused".to_owned()];
    Ok(Case { judge: Judge::Tint, file: Path::new("modules").join(module), export })
}

/// A file that makes an instance of `module` with functions that return zero; `None` where it declares no slots.
fn instance(module: &str, source: &str) -> Option<String> {
    let (with, functions): (Vec<String>, Vec<String>) = source.lines().filter_map(zero_for_slot).unzip();
    if with.is_empty() {
        return None;
    }
    Some(format!("#include <{module}> as judged with {}\n\n{}", with.join(", "), functions.concat()))
}

/// `#slot name: fn(p: vec2f) -> f32` → `name = zero_name` and the function; `None` on any other line.
fn zero_for_slot(line: &str) -> Option<(String, String)> {
    let (name, signature) = line.trim().strip_prefix("#slot ")?.split_once(':')?;
    let signature = signature.split("//").next()?.trim().strip_prefix("fn")?;
    let name = name.trim();
    let function = match signature.split_once("->") {
        None => format!("fn zero_{name}{signature} {{}}\n"),
        Some((parameters, result)) => {
            let (parameters, result) = (parameters.trim(), result.trim());
            format!("fn zero_{name}{parameters} -> {result} {{ return {result}(); }}\n")
        }
    };
    Some((format!("{name} = zero_{name}"), function))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preset_is_judged_in_every_baking_and_both_stages() {
        let cases = of_preset("alpine");
        let count = |judge| cases.iter().filter(|case| case.judge == judge).count();
        assert_eq!(count(Judge::Tint), 9, "two stages and minified, in three bakings");
        assert_eq!(
            (count(Judge::Glslang), count(Judge::SpirvVal), count(Judge::GlslangInShadertoy)),
            (3, 2, 2)
        );
        let live = cases
            .iter()
            .find(|case| case.file == Path::new("alpine.compute.uniform.wgsl"))
            .expect("is there");
        assert_eq!(live.export, ["export", "alpine", "--stage", "compute", "--live", "*"]);
    }

    #[test]
    fn a_view_is_judged_with_a_preset_around_it() {
        let cases = of_view("steps", "alpine");
        assert_eq!(cases[0].export, ["export", "alpine", "--view", "steps"]);
        assert_eq!(cases[1].export[4..], ["--live", "*"]);
    }

    #[test]
    fn a_picture_of_everything_around_is_judged_as_wgsl_and_on_shadertoy() {
        let cases = of_projection("cube", "lake");
        assert_eq!(cases[0].export[..4], ["export", "lake", "--set", "camera.projection=cube"]);
        assert_eq!(cases[1].export[4..], ["--target", "shadertoy"]);
    }

    #[test]
    fn views_of_clouds_are_judged_where_there_are_some() {
        assert_eq!(["steps", "cloud_steps"].map(seen_in), ["alpine", "cumulus"]);
    }

    #[test]
    fn every_file_has_a_name_of_its_own() {
        let views = ["steps", "depth"].iter().flat_map(|view| of_view(view, "alpine"));
        let around =
            ["equirectangular", "cube"].iter().flat_map(|projection| of_projection(projection, "alpine"));
        let cases: Vec<Case> = of_preset("alpine").into_iter().chain(views).chain(around).collect();
        let mut files: Vec<&PathBuf> = cases.iter().map(|case| &case.file).collect();
        files.sort();
        files.dedup();
        assert_eq!(files.len(), cases.len());
    }

    #[test]
    fn a_module_without_slots_stands_alone() {
        assert_eq!(
            instance("noise/pcg.wgsl", "// #slot is what this has not\nfn pcg(v: u32) -> u32 { return v; }"),
            None
        );
    }

    #[test]
    fn a_generic_module_gets_functions_that_return_zero() {
        let source = "/// Noise.\n\
                      #slot noise2: fn(p: vec2f, seed: u32) -> vec3f // (value, gradient)\n\
                      #slot note: fn(p: vec2f)\n";
        let expected = "#include <fractal/fbm.wgsl> as judged with noise2 = zero_noise2, note = zero_note\n\n\
                        fn zero_noise2(p: vec2f, seed: u32) -> vec3f { return vec3f(); }\n\
                        fn zero_note(p: vec2f) {}\n";
        assert_eq!(instance("fractal/fbm.wgsl", source).as_deref(), Some(expected));
    }
}

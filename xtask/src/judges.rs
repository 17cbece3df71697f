//! The judges: other people's compilers, on everything that `orogen` writes for its presets, views and modules.
//!
//! Tint reads the WGSL, glslangValidator the GLSL, spirv-val the SPIR-V; a browser draws them. That naga finds a file good is
//! not enough: it accepts WGSL that browsers refuse, and writes GLSL that is none.

use std::fs;
use std::path::Path;

use crate::browser;
use crate::cases::{Case, Judge, of_module, of_preset, of_projection, of_view, seen_in};
use crate::install::{self, Install};
use crate::run::{
    Failure, Outcome, capture, cargo, command, create_folder, in_parallel, read, run, shown, target,
    tested_orogen, write,
};

/// What Shadertoy puts before a shader. Its names are taken: a shader that declares one does not compile there.
const SHADERTOY_PAGE: &str = include_str!("shadertoy.frag");

/// What compute.toys puts before a shader.
const TOYS_PAGE: &str = include_str!("toys.wgsl");

/// Gets the judges and `orogen`, then has everything judged, or only what is written for `presets`.
pub(crate) fn judge_alone(install: Install, presets: &[String]) -> Outcome {
    install::driver(install)?;
    install::judges(install)?;
    run(&mut cargo("build"))?;
    judge(presets)
}

/// Has everything judged that the built `orogen` writes, or, where some `only` are named, those presets. Goes on after a
/// complaint, so that all are heard at once.
pub(crate) fn judge(only: &[String]) -> Outcome {
    let folder = target()?.join("judges");
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|cause| Failure::File { path: folder.clone(), cause })?;
    }
    let (presets, views, modules) = if only.is_empty() {
        (list("presets")?, list("views")?, list("modules")?)
    } else {
        (only.to_vec(), Vec::new(), Vec::new())
    };
    let mut cases: Vec<Case> = presets.iter().flat_map(|preset| of_preset(preset)).collect();
    cases.extend(views.iter().flat_map(|view| of_view(view, seen_in(view))));
    if only.is_empty() {
        cases.extend(["equirectangular", "cube"].iter().flat_map(|around| of_projection(around, "lake")));
    }
    for module in &modules {
        cases.push(of_module(module, &folder.join("hosts"))?);
    }

    let judged = folder.join("judged");
    println!(
        "{} presets, {} views and {} modules: {} files",
        presets.len(),
        views.len(),
        modules.len(),
        cases.len()
    );
    let refusals =
        in_parallel(&cases, |case| export(case, &judged).and_then(|()| verdict(case, &judged)).err());
    let mut refused = Vec::new();
    for (case, refusal) in cases.iter().zip(refusals) {
        if let Some(failure) = refusal {
            println!("{failure}\n");
            refused.push(case.file.display().to_string());
        }
    }
    if let Err(failure) = run(command("node", &["tests/judges/tint.mjs"]).arg(&judged)) {
        println!("{failure}\n");
        refused.push("what Tint names above".to_owned());
    }
    let others = cases.iter().filter(|case| !matches!(case.judge, Judge::Tint | Judge::TintInToys)).count();
    println!("glslang and spirv-val judged {others} GLSL and SPIR-V files");
    println!("all files lie in {}", judged.display());
    let presets: Vec<&str> = presets.iter().map(String::as_str).collect();
    refused.extend(browser::judge(&presets, &judged, &folder.join("pictures"))?);
    if refused.is_empty() {
        return Ok(());
    }
    Err(Failure::Check(format!("not written, or refused by a judge:\n  {}", refused.join("\n  "))))
}

/// The names that `orogen list WHAT` gives. There are always some.
fn list(what: &str) -> Outcome<Vec<String>> {
    let mut command = tested_orogen(&["list", what])?;
    let names = names(&capture(&mut command)?);
    if names.is_empty() {
        Err(Failure::Check(format!("`{}` names none", shown(&command))))
    } else {
        Ok(names)
    }
}

/// What stands before the tab, line by line.
fn names(list: &str) -> Vec<String> {
    let before_tab = |line: &str| line.split('\t').next().unwrap_or_default().trim().to_owned();
    list.lines().map(before_tab).filter(|name| !name.is_empty()).collect()
}

/// Has `orogen` write the case's file.
fn export(case: &Case, judged: &Path) -> Outcome {
    let file = judged.join(&case.file);
    create_folder(file.parent().unwrap_or(judged))?;
    let words: Vec<&str> = case.export.iter().map(String::as_str).collect();
    capture(tested_orogen(&words)?.arg("-o").arg(file)).map(drop)
}

/// What the case's judge says; Tint has its say on all its files at the end.
fn verdict(case: &Case, judged: &Path) -> Outcome {
    let file = judged.join(&case.file);
    match case.judge {
        Judge::Tint => Ok(()),
        Judge::TintInToys => {
            write(&file.with_extension("page.wgsl"), &format!("{TOYS_PAGE}{}", read(&file)?))
        }
        Judge::Glslang => glslang(&file),
        Judge::GlslangInShadertoy => {
            let page = file.with_extension("page.frag");
            write(&page, &in_shadertoy(&read(&file)?))?;
            glslang(&page)
        }
        Judge::SpirvVal => capture(command("spirv-val", &["--target-env", "vulkan1.1"]).arg(&file)).map(drop),
    }
}

fn glslang(file: &Path) -> Outcome {
    capture(command("glslangValidator", &["-S", "frag"]).arg(file)).map(drop)
}

/// `shader` as Shadertoy compiles it. Its own lines keep their numbers.
fn in_shadertoy(shader: &str) -> String {
    format!("{SHADERTOY_PAGE}#line 1\n{shader}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_has_its_names_before_the_tabs() {
        let list = "alpine\tSnow-capped range in late light\ndunes\t\n\ncanyon\r\n";
        assert_eq!(names(list), ["alpine", "dunes", "canyon"]);
    }

    #[test]
    fn on_shadertoy_the_shader_comes_last_and_keeps_its_line_numbers() {
        let page = in_shadertoy("void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n");
        assert!(page.starts_with("#version 300 es\n"), "nothing may stand before the version");
        assert!(page.ends_with("#line 1\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n"));
    }
}

//! Where modules lie: `sky/air-light` → `["sky", "air_light"]`, and the way from one to another.

use rustc_hash::FxHashSet;

use crate::syntax::{is_ident, is_reserved};

/// The words that WESL adds to those of WGSL.
const WORDS: [&str; 5] = ["as", "import", "package", "self", "super"];

/// The modules that there are already.
#[derive(Default)]
pub(super) struct Paths {
    taken: FxHashSet<Vec<String>>,
}

impl Paths {
    /// The path of a module that lies at `segments`, as identifiers; another one where that is taken.
    pub(super) fn take<S: AsRef<str>>(&mut self, segments: &[S]) -> Vec<String> {
        let path: Vec<String> = segments.iter().map(|segment| identifier(segment.as_ref())).collect();
        let mut free = path.clone();
        let mut number = 2;
        while !self.taken.insert(free.clone()) {
            free.clone_from(&path);
            if let Some(last) = free.last_mut() {
                *last = format!("{last}_{number}");
            }
            number += 1;
        }
        free
    }
}

/// `name` as an identifier of WESL.
fn identifier(name: &str) -> String {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut name: String = name.chars().map(|c| if fits(c) { c } else { '_' }).collect();
    if name.is_empty() || name.starts_with(|c: char| c.is_ascii_digit() || c == '_') {
        name.insert(0, 'm');
    }
    if !is_ident(&name) || is_reserved(&name) || WORDS.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// `to` as the module `from` says it: `super::noise::perlin`.
pub(super) fn relative(from: &[String], to: &[String]) -> String {
    let shared = from.iter().zip(to).take_while(|(a, b)| a == b).count();
    let mut path: Vec<&str> = vec!["super"; from.len() - shared];
    if path.is_empty() {
        path.push("self");
    }
    path.extend(to[shared..].iter().map(String::as_str));
    path.join("::")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(text: &str) -> Vec<String> {
        text.split("::").map(str::to_owned).collect()
    }

    #[test]
    fn the_way_from_one_module_to_another_goes_up_and_down() {
        let way = |from: &str, to: &str| relative(&path(from), &path(to));
        assert_eq!(way("sky::atmosphere", "sky::medium"), "super::medium");
        assert_eq!(way("sky::atmosphere", "parameters"), "super::super::parameters");
        assert_eq!(way("main", "sky::sky"), "super::sky::sky");
        assert_eq!(way("fractal::fbm::relief", "fractal::octaves"), "super::super::octaves");
        assert_eq!(way("fractal::fbm::relief", "fractal::fbm"), "super");
        assert_eq!(way("sky", "sky::moon"), "self::moon");
    }

    #[test]
    fn every_file_gets_a_path_of_identifiers_of_its_own() {
        let mut paths = Paths::default();
        assert_eq!(paths.take(&["my-land", "3d.old"]), ["my_land", "m3d_old"]);
        assert_eq!(paths.take(&["my_land", "m3d_old"]), ["my_land", "m3d_old_2"]);
        assert_eq!(paths.take(&["super", "loop"]), ["super_", "loop_"]);
        assert_eq!(paths.take(&["_", ""]), ["m_", "m"]);
    }
}

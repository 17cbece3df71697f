//! Paths inside a root: relative, with `/`, and never out of it.

/// Why a path is not one inside its root.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PathError {
    /// Nothing is named.
    #[error("the path is empty")]
    Empty,
    /// It starts at the machine's root or at a drive.
    #[error("an absolute path is not allowed here")]
    Absolute,
    /// It climbs above the root.
    #[error("the path leads out of its root")]
    Outside,
    /// A character that no path of ours holds.
    #[error("the path holds {0:?}, which is not allowed")]
    Character(char),
}

/// `path`, taken from the folder `base` (both inside the root), without `.` and `..`.
///
/// # Errors
/// Where the result is empty, absolute or outside of the root.
pub fn join(base: &str, path: &str) -> Result<String, PathError> {
    if path.is_empty() {
        return Err(PathError::Empty);
    }
    if let Some(bad) = path.chars().find(|c| c.is_control() || matches!(c, '\\' | ':')) {
        return Err(PathError::Character(bad));
    }
    if path.starts_with('/') {
        return Err(PathError::Absolute);
    }
    let mut parts: Vec<&str> = base.split('/').filter(|part| !part.is_empty()).collect();
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop().ok_or(PathError::Outside)?),
            part => parts.push(part),
        }
    }
    if parts.is_empty() { Err(PathError::Empty) } else { Ok(parts.join("/")) }
}

/// The folder that `path` is in, without a trailing `/`; empty at the root.
pub fn folder(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_stays_inside_its_root() {
        assert_eq!(join("", "noise/perlin.wgsl"), Ok("noise/perlin.wgsl".into()));
        assert_eq!(join("terrain", "../noise/./pcg.wgsl"), Ok("noise/pcg.wgsl".into()));
        assert_eq!(join("", "../../etc/passwd"), Err(PathError::Outside));
        assert_eq!(join("a", "../../x"), Err(PathError::Outside));
        assert_eq!(join("", "/etc/passwd"), Err(PathError::Absolute));
        assert_eq!(join("", "c:x"), Err(PathError::Character(':')));
        assert_eq!(join("", "a\\b"), Err(PathError::Character('\\')));
        assert_eq!(join("", "a\0b"), Err(PathError::Character('\0')));
        assert_eq!(join("", ""), Err(PathError::Empty));
        assert_eq!(join("a", ".."), Err(PathError::Empty));
    }
}

//! What all names of a result start with, so that it can be pasted into another program: `og_` → [`Prefix`].

use std::fmt;

use super::error::ComposeError;
use crate::diagnostic::{Diagnostic, Error};
use crate::syntax::is_ident;

/// What every name of module scope starts with in the result; by default nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub struct Prefix(String);

impl Prefix {
    /// `prefix`, if names can start with it.
    ///
    /// # Errors
    /// `OR0415` where none can: `9_`, `__`, `a-b`.
    pub fn new(prefix: &str) -> Result<Self, Error> {
        // What follows it is a name: that may start with `_`, and two of them are reserved.
        let fits = prefix.is_empty()
            || is_ident(&format!("{prefix}a")) && !prefix.starts_with("__") && prefix != "_";
        if fits {
            Ok(Self(prefix.to_owned()))
        } else {
            Err(Error::bare(Diagnostic::from(ComposeError::Prefix { prefix: prefix.to_owned() })))
        }
    }

    /// Whether names stay as they are.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// `name` with it.
    pub fn before(&self, name: &str) -> String {
        format!("{}{name}", self.0)
    }
}

impl fmt::Display for Prefix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

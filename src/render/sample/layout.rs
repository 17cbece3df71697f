//! naga's type of an expression → its scalar components: what each is called, and how WGSL reaches it.

use naga::{ArraySize, Handle, ScalarKind, Type, TypeInner};

use super::value::Kind;
use crate::check::Checked;

/// A scalar of a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Leaf {
    /// Its column.
    pub(super) name: String,
    /// What stands behind the value to reach it: `.id.x`, `[0].y`; nothing for a scalar.
    pub(super) access: String,
    pub(super) kind: Kind,
}

/// The most scalars that one value may have.
const MOST: usize = 4096;
/// How deep structures and arrays may nest.
const DEEPEST: usize = 64;

const AXES: [&str; 4] = ["x", "y", "z", "w"];

/// The components of the value that the entry point `entry` names `value`; or what it is that has none.
pub(super) fn leaves(checked: &Checked, entry: &str, value: &str) -> Result<Vec<Leaf>, String> {
    const UNKNOWN: &str = "what this gives";
    let found = checked.module.entry_points.iter().position(|point| point.name == entry);
    let index = found.ok_or(UNKNOWN)?;
    let function = &checked.module.entry_points[index].function;
    let named = function.named_expressions.iter().find(|(_, name)| *name == value);
    let (expression, _) = named.ok_or(UNKNOWN)?;
    let resolution = &checked.info.get_entry_point(index)[*expression].ty;
    let mut walk = Walk { checked, leaves: Vec::new() };
    walk.inner(resolution.inner_with(&checked.module.types), String::new(), String::new(), 0)?;
    if let [only] = walk.leaves.as_mut_slice()
        && only.name.is_empty()
    {
        only.name = "value".into();
    }
    Ok(walk.leaves)
}

struct Walk<'a> {
    checked: &'a Checked,
    leaves: Vec<Leaf>,
}

impl Walk<'_> {
    fn handle(&mut self, ty: Handle<Type>, name: String, access: String, depth: usize) -> Result<(), String> {
        let checked = self.checked;
        self.inner(&checked.module.types[ty].inner, name, access, depth + 1)
    }

    fn inner(&mut self, ty: &TypeInner, name: String, access: String, depth: usize) -> Result<(), String> {
        if depth > DEEPEST {
            return Err(format!("a value nested deeper than {DEEPEST}"));
        }
        match ty {
            TypeInner::Scalar(scalar) => self.leaf(*scalar, name, access),
            TypeInner::Vector { size, scalar } => {
                for axis in &AXES[..*size as usize] {
                    self.leaf(*scalar, join(&name, axis), format!("{access}.{axis}"))?;
                }
                Ok(())
            }
            TypeInner::Matrix { columns, rows, scalar } => {
                for column in 0..*columns as usize {
                    for axis in &AXES[..*rows as usize] {
                        let access = format!("{access}[{column}].{axis}");
                        self.leaf(*scalar, join(&name, &format!("c{column}_{axis}")), access)?;
                    }
                }
                Ok(())
            }
            TypeInner::Array { base, size: ArraySize::Constant(size), .. } => {
                for index in 0..size.get() {
                    let access = format!("{access}[{index}]");
                    self.handle(*base, join(&name, &index.to_string()), access, depth)?;
                }
                Ok(())
            }
            TypeInner::Struct { members, .. } => {
                for member in members {
                    let field = member.name.as_deref().unwrap_or_default();
                    self.handle(member.ty, join(&name, field), format!("{access}.{field}"), depth)?;
                }
                Ok(())
            }
            other => Err(what(other).into()),
        }
    }

    fn leaf(&mut self, scalar: naga::Scalar, name: String, access: String) -> Result<(), String> {
        let kind = match (scalar.kind, scalar.width) {
            (ScalarKind::Float, 4) => Kind::F32,
            (ScalarKind::Sint, 4) => Kind::I32,
            (ScalarKind::Uint, 4) => Kind::U32,
            (ScalarKind::Bool, _) => Kind::Bool,
            (_, width) => return Err(format!("a scalar of {} bits", u32::from(width) * 8)),
        };
        if self.leaves.len() == MOST {
            return Err(format!("a value of more than {MOST} scalars"));
        }
        self.leaves.push(Leaf { name, access, kind });
        Ok(())
    }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
}

fn what(ty: &TypeInner) -> &'static str {
    match ty {
        TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. } => "a pointer",
        TypeInner::Array { .. } => "an array whose size is not known when it is compiled",
        TypeInner::Atomic(_) => "an atomic",
        TypeInner::Image { .. } => "a texture",
        TypeInner::Sampler { .. } => "a sampler",
        _ => "a value of this type",
    }
}

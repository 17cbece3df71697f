//! What naga has worked out of constants: for those that GLSL would not take as constant.

use naga::{Expression, Handle, Literal, Module, ScalarKind, TypeInner};
use rustc_hash::FxHashMap;

use super::spelling;
use crate::export::typed::{DeclKind, Typed};

/// Of constants and of what variables of the module start with: the value in GLSL, by number of the declaration.
pub(super) fn of(module: &Module, typed: &Typed<'_>) -> FxHashMap<u32, String> {
    let constants = module.constants.iter().map(|(_, one)| (one.name.as_deref(), Some(one.init)));
    let variables = module.global_variables.iter().map(|(_, one)| (one.name.as_deref(), one.init));
    let mut values = FxHashMap::default();
    for (name, init) in constants.chain(variables) {
        let (Some(name), Some(init)) = (name, init) else { continue };
        let Some(index) = typed.by_name.get(name).copied() else { continue };
        let is_value = matches!(
            typed.tree.declarations[index as usize].kind,
            DeclKind::Const { .. } | DeclKind::Var { .. }
        );
        if is_value && let Some(text) = value(module, init, 0) {
            values.insert(index, text);
        }
    }
    values
}

/// Of numbers and vectors of them.
fn value(module: &Module, handle: Handle<Expression>, depth: u32) -> Option<String> {
    if depth > 4 {
        return None; // a vector of a constant of a constant …
    }
    match &module.global_expressions[handle] {
        Expression::Literal(literal) => literal_text(*literal),
        Expression::Constant(constant) => value(module, module.constants[*constant].init, depth + 1),
        Expression::Splat { size, value: one } => {
            let one = value(module, *one, depth + 1)?;
            let prefix = if one.ends_with('u') {
                "u"
            } else if one.contains(['.', 'e']) {
                ""
            } else {
                "i"
            };
            Some(format!("{prefix}vec{}({one})", *size as u8))
        }
        Expression::Compose { ty, components } => {
            let TypeInner::Vector { size, scalar } = module.types[*ty].inner else { return None };
            let prefix = match scalar.kind {
                ScalarKind::Sint => "i",
                ScalarKind::Uint => "u",
                ScalarKind::Bool => "b",
                _ => "",
            };
            let parts: Option<Vec<_>> = components.iter().map(|one| value(module, *one, depth + 1)).collect();
            Some(format!("{prefix}vec{}({})", size as u8, parts?.join(", ")))
        }
        _ => None,
    }
}

fn literal_text(literal: Literal) -> Option<String> {
    use crate::export::typed::Scalar;
    match literal {
        Literal::F32(value) => value.is_finite().then(|| spelling::float(value)),
        Literal::U32(value) => Some(format!("{value}u")),
        Literal::I32(value) => spelling::number(f64::from(value), Scalar::I32),
        Literal::Bool(value) => Some(value.to_string()),
        _ => None,
    }
}

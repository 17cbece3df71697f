//! What GLSL ES 3.00 has no words for, and naga's writer writes all the same: naga's module → the first such expression.

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Expression, Function, MathFunction, Module, ScalarKind, TypeInner};

use super::error::ExportError;
use crate::source::Span;

/// Refuses what would be written as invalid GLSL. `module` holds only what is reached.
pub(super) fn refuse(module: &Module, info: &ModuleInfo) -> Result<(), ExportError> {
    for (handle, function) in module.functions.iter() {
        refuse_in(module, function, &info[handle])?;
    }
    for (index, entry) in module.entry_points.iter().enumerate() {
        refuse_in(module, &entry.function, info.get_entry_point(index))?;
    }
    Ok(())
}

fn refuse_in(module: &Module, function: &Function, info: &FunctionInfo) -> Result<(), ExportError> {
    for (handle, expression) in function.expressions.iter() {
        let ty = info[handle].ty.inner_with(&module.types);
        let what = match expression {
            Expression::Math { fun, .. } => missing(*fun).map(|name| format!("`{name}`")),
            Expression::Select { .. } => select(ty).map(|ty| format!("`select` of {ty}")),
            _ => None,
        };
        if let Some(what) = what {
            let range = function.expressions.get_span(handle).to_range();
            let span = range.map(|range| Span::new(range.start, range.end));
            return Err(ExportError::NotInEs300 { what, span });
        }
    }
    Ok(())
}

/// The WGSL name of a built-in that only later versions have.
fn missing(function: MathFunction) -> Option<&'static str> {
    use MathFunction as F;
    Some(match function {
        F::CountOneBits => "countOneBits",
        F::CountLeadingZeros => "countLeadingZeros",
        F::CountTrailingZeros => "countTrailingZeros",
        F::FirstLeadingBit => "firstLeadingBit",
        F::FirstTrailingBit => "firstTrailingBit",
        F::ReverseBits => "reverseBits",
        F::ExtractBits => "extractBits",
        F::InsertBits => "insertBits",
        F::Ldexp => "ldexp",
        F::Frexp => "frexp",
        F::Pack4x8snorm => "pack4x8snorm",
        F::Pack4x8unorm => "pack4x8unorm",
        F::Unpack4x8snorm => "unpack4x8snorm",
        F::Unpack4x8unorm => "unpack4x8unorm",
        _ => return None,
    })
}

/// ES 3.00 has `mix` by truth values for floats alone.
fn select(ty: &TypeInner) -> Option<&'static str> {
    let TypeInner::Vector { scalar, .. } = ty else { return None };
    match scalar.kind {
        ScalarKind::Float => None,
        ScalarKind::Bool => Some("vectors of booleans"),
        _ => Some("vectors of integers"),
    }
}

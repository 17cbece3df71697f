//! What naga validates, but cannot make a pipeline of: only there do overrides get their values, and naga then computes what
//! follows from them alone.

use naga::back::pipeline_constants::{PipelineConstantError, process_overrides};
use naga::valid::ModuleInfo;
use naga::{Expression, Function, Handle, MathFunction, Module, Span};

/// Why there can be no pipeline.
pub(super) enum Unsettled {
    /// A variable begins with this call of overrides alone. Some functions naga does not compute, and leaves to the shader;
    /// but in what a variable begins with it has no place for that, and its writers panic (naga 30).
    Uncomputed(Span),
    /// What naga says itself when it puts the overrides' defaults in.
    Refused(Box<PipelineConstantError>),
}

/// Whether naga can give the overrides of `module` their defaults, where all have one.
pub(super) fn settle(module: &Module, info: &ModuleInfo) -> Result<(), Unsettled> {
    if module.overrides.is_empty() {
        return Ok(());
    }
    let functions = module.functions.iter().map(|(_, function)| function);
    let mut functions = functions.chain(module.entry_points.iter().map(|entry| &entry.function));
    if let Some(call) = functions.find_map(uncomputed) {
        return Err(Unsettled::Uncomputed(call));
    }
    if module.overrides.iter().any(|(_, value)| value.init.is_none()) {
        return Ok(()); // the host's own, of whose values nothing is known
    }
    let settled = process_overrides(module, info, None, &Default::default());
    settled.map(|_| ()).map_err(|error| Unsettled::Refused(error.into()))
}

/// What is known of a value.
#[derive(Clone, Copy, Default)]
struct Value {
    overridden: bool,
    uncomputed: Option<Handle<Expression>>,
}

impl Value {
    fn and(self, other: Self) -> Self {
        Self {
            overridden: self.overridden || other.overridden,
            uncomputed: self.uncomputed.or(other.uncomputed),
        }
    }
}

/// The first call in what a variable begins with, of overrides alone, that naga does not compute.
fn uncomputed(function: &Function) -> Option<Span> {
    // Values come after what they are made of.
    let mut values: Vec<Value> = Vec::with_capacity(function.expressions.len());
    for (handle, expression) in function.expressions.iter() {
        let of = |parts: &[Handle<Expression>]| {
            let parts = parts.iter().filter_map(|part| values.get(part.index()));
            parts.fold(Value::default(), |all, part| all.and(*part))
        };
        let mut value = match expression {
            Expression::Override(_) => Value { overridden: true, uncomputed: None },
            Expression::Compose { components, .. } => of(components),
            Expression::Access { base, index } => of(&[*base, *index]),
            Expression::AccessIndex { base, .. } => of(&[*base]),
            Expression::Splat { value, .. } => of(&[*value]),
            Expression::Swizzle { vector, .. } => of(&[*vector]),
            Expression::Unary { expr, .. } | Expression::As { expr, .. } => of(&[*expr]),
            Expression::Binary { left, right, .. } => of(&[*left, *right]),
            Expression::Select { condition, accept, reject } => of(&[*condition, *accept, *reject]),
            Expression::Relational { argument, .. } => of(&[*argument]),
            Expression::Math { arg, arg1, arg2, arg3, .. } => {
                let others: Vec<_> = [Some(*arg), *arg1, *arg2, *arg3].into_iter().flatten().collect();
                of(&others)
            }
            _ => Value::default(), // known only while the shader runs, or a constant
        };
        let computed = match expression {
            Expression::Math { fun, .. } => computes(*fun),
            Expression::As { convert, .. } => convert.is_some(), // else it is a bitcast
            _ => true,
        };
        if value.overridden && !computed {
            value.uncomputed = value.uncomputed.or(Some(handle));
        }
        values.push(value);
    }
    // Where a variable begins with what is known only while the shader runs, naga stores that; there is no `init` then.
    let begun = function.local_variables.iter().filter_map(|(_, variable)| variable.init);
    let first = begun.filter_map(|init| values.get(init.index())?.uncomputed).min()?;
    Some(function.expressions.get_span(first))
}

/// Whether naga computes the function before the shader runs (`proc::ConstantEvaluator`, naga 30).
fn computes(function: MathFunction) -> bool {
    use MathFunction as M;
    !matches!(
        function,
        M::Modf
            | M::Frexp
            | M::Ldexp
            | M::Outer
            | M::FaceForward
            | M::Reflect
            | M::Refract
            | M::Mix
            | M::SmoothStep
            | M::Inverse
            | M::Transpose
            | M::Determinant
            | M::QuantizeToF16
            | M::ExtractBits
            | M::InsertBits
            | M::Pack4x8snorm
            | M::Pack4x8unorm
            | M::Pack2x16snorm
            | M::Pack2x16unorm
            | M::Pack2x16float
            | M::Pack4xI8
            | M::Pack4xU8
            | M::Pack4xI8Clamp
            | M::Pack4xU8Clamp
            | M::Unpack4x8snorm
            | M::Unpack4x8unorm
            | M::Unpack2x16snorm
            | M::Unpack2x16unorm
            | M::Unpack2x16float
            | M::Unpack4xI8
            | M::Unpack4xU8
    )
}

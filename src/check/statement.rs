//! Which statement naga has refused: what it says of a value may point to where the value was declared, far away.

use naga::valid::{CallError, EntryPointError, FunctionError, ValidationError};
use naga::{Expression, Function, Handle, Module, Span, Statement};

/// The statement that is wrong because of a value in it, where `error` is about one.
pub(super) fn refused(module: &Module, error: &ValidationError) -> Option<Span> {
    let (function, error) = match error {
        ValidationError::Function { handle, source, .. } => (&module.functions[*handle], source),
        ValidationError::EntryPoint { stage, name, source: EntryPointError::Function(source) } => {
            let entry = module.entry_points.iter().find(|entry| entry.stage == *stage && entry.name == *name);
            (&entry?.function, source)
        }
        _ => return None,
    };
    let value = value(error)?;
    find(function, |statement| match (statement, error) {
        (Statement::Return { value: Some(returned) }, FunctionError::InvalidReturnType { .. }) => {
            *returned == value
        }
        (Statement::If { condition, .. }, FunctionError::InvalidIfType(_)) => *condition == value,
        (Statement::Store { value: stored, .. }, FunctionError::InvalidStoreTypes { .. }) => *stored == value,
        (Statement::Call { arguments, .. }, FunctionError::InvalidCall { .. }) => arguments.contains(&value),
        _ => false,
    })
}

/// The value that is of a wrong type.
fn value(error: &FunctionError) -> Option<Handle<Expression>> {
    match error {
        FunctionError::InvalidReturnType { expression, .. } => *expression,
        FunctionError::InvalidIfType(condition) => Some(*condition),
        FunctionError::InvalidStoreTypes { value, .. } => Some(*value),
        FunctionError::InvalidCall { error: CallError::ArgumentType { seen_expression, .. }, .. } => {
            Some(*seen_expression)
        }
        _ => None,
    }
}

/// The first statement that `is_it`, in whatever block; its place in the text.
fn find(function: &Function, is_it: impl Fn(&Statement) -> bool) -> Option<Span> {
    let mut open = vec![function.body.span_iter()];
    while let Some(block) = open.last_mut() {
        let Some((statement, span)) = block.next() else {
            open.pop();
            continue;
        };
        if is_it(statement) {
            return Some(*span);
        }
        match statement {
            Statement::Block(inner) => open.push(inner.span_iter()),
            Statement::If { accept, reject, .. } => open.extend([reject.span_iter(), accept.span_iter()]),
            Statement::Switch { cases, .. } => {
                open.extend(cases.iter().rev().map(|case| case.body.span_iter()))
            }
            Statement::Loop { body, continuing, .. } => {
                open.extend([continuing.span_iter(), body.span_iter()]);
            }
            _ => {}
        }
    }
    None
}

//! What surrounds the author's program: the entry point's inputs and outputs, and the function that calls it.

use super::write::{Writer, Written};
use crate::export::typed::{Attribute, DeclKind, ExprId, Field, Scalar, Ty};
use crate::source::Span;

/// What an entry point takes and gives, in GLSL.
#[derive(Debug, Default)]
pub(super) struct Interface {
    /// `in vec2 uv;`, `layout(location = 0) out vec4 color;`
    pub(super) declarations: Vec<String>,
    /// The arguments, one each; `None` for the position.
    pub(super) arguments: Vec<Option<String>>,
    /// The variable that takes the whole result, of this type; none where the result is a struct or nothing.
    pub(super) output: Option<(String, Ty)>,
    /// What is done with the result where it is a struct: its type, and a variable for each member.
    pub(super) outputs: Option<(String, Vec<(String, String)>)>,
}

/// The interface of the entry point `entry`.
pub(super) fn interface(writer: &mut Writer<'_, '_>, entry: u32) -> Written<Interface> {
    let typed = writer.typed;
    let mut interface = Interface::default();
    let DeclKind::Function(function) = &typed.tree.declarations[entry as usize].kind else {
        return Ok(interface);
    };
    for parameter in &function.parameters {
        let ty = typed.ty(parameter.ty);
        let argument = match ty {
            Ty::Struct(index) => {
                let DeclKind::Struct { members, .. } = &typed.tree.declarations[index as usize].kind else {
                    return Ok(interface);
                };
                let mut parts = Vec::with_capacity(members.len());
                for member in members {
                    let input = input(writer, &mut interface, member)?;
                    parts.push(input.unwrap_or_else(|| "gl_FragCoord".to_owned()));
                }
                Some(format!("{}({})", writer.global_name(index), parts.join(", ")))
            }
            _ => input(writer, &mut interface, parameter)?,
        };
        interface.arguments.push(argument);
    }
    let Some(result) = function.result else { return Ok(interface) };
    match typed.ty(result) {
        Ty::Struct(index) => {
            let DeclKind::Struct { members, .. } = &typed.tree.declarations[index as usize].kind else {
                return Ok(interface);
            };
            let mut outputs = Vec::with_capacity(members.len());
            for member in members {
                let name = writer.names.get(typed.tree.word(member.name)).to_owned();
                let variable = output(writer, &mut interface, &member.attributes, member.ty, &name)?;
                outputs.push((variable, name));
            }
            interface.outputs = Some((writer.global_name(index), outputs));
        }
        ty => {
            let variable = output(writer, &mut interface, &function.result_attributes, result, "color")?;
            interface.output = Some((variable, ty));
        }
    }
    Ok(interface)
}

/// The variable that an input comes in; none for the position.
fn input(writer: &mut Writer<'_, '_>, interface: &mut Interface, field: &Field) -> Written<Option<String>> {
    let typed = writer.typed;
    let span = typed.tree.span_of(field.name, field.name);
    if let Some(builtin) = typed.tree.attribute(&field.attributes, "builtin") {
        let word = builtin.arguments.first().map_or("", |id| typed.tree.word(typed.tree.expr(*id).first));
        return match word {
            "position" => Ok(None),
            "front_facing" => Ok(Some("gl_FrontFacing".to_owned())),
            other => writer.refuse(format!("`@builtin({other})`"), span),
        };
    }
    let ty = typed.ty(field.ty);
    let written = writer.type_of(ty, span)?;
    let base = writer.names.get(typed.tree.word(field.name)).to_owned();
    let name = writer.names.fresh_like(&format!("v_{base}"));
    let is_flat = ty.scalar().is_some_and(Scalar::is_integer)
        || typed.tree.attribute(&field.attributes, "interpolate").is_some();
    interface.declarations.push(format!("{}in {written} {name};", if is_flat { "flat " } else { "" }));
    Ok(Some(name))
}

/// The variable that takes an output.
fn output(
    writer: &mut Writer<'_, '_>,
    interface: &mut Interface,
    attributes: &[Attribute],
    ty: ExprId,
    name: &str,
) -> Written<String> {
    let typed = writer.typed;
    let span: Span = typed.tree.span(ty);
    if let Some(builtin) = typed.tree.attribute(attributes, "builtin") {
        let word = builtin.arguments.first().map_or("", |id| typed.tree.word(typed.tree.expr(*id).first));
        return match word {
            "frag_depth" => Ok("gl_FragDepth".to_owned()),
            other => writer.refuse(format!("`@builtin({other})`"), span),
        };
    }
    if typed.tree.attribute(attributes, "blend_src").is_some() {
        return writer.refuse("`@blend_src`", span);
    }
    let location = typed
        .tree
        .attribute(attributes, "location")
        .and_then(|location| typed.integer(*location.arguments.first()?));
    let written = writer.type_of(typed.ty(ty), span)?;
    let name = writer.names.fresh_like(&format!("out_{name}"));
    interface
        .declarations
        .push(format!("layout(location = {}) out {written} {name};", location.unwrap_or(0)));
    Ok(name)
}

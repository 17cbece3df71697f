//! Declarations of the module.

use super::spelling;
use super::write::{Writer, Written};
use crate::export::typed::{DeclKind, Field, Function, Scalar, Tok, Ty};

impl<'w> Writer<'w, '_> {
    /// Declaration `index`; nothing of one that GLSL has no need of.
    pub(super) fn declaration(&mut self, index: u32) -> Written {
        let typed = self.typed;
        let decl = &typed.tree.declarations[index as usize];
        self.upto(decl.first);
        match &decl.kind {
            DeclKind::Directive | DeclKind::Assert | DeclKind::Alias(_) => {
                self.skip_to(decl.last + 1);
                return Ok(());
            }
            DeclKind::Const { value, .. } => self.constant(index, Some(*value))?,
            DeclKind::Override { value, .. } => self.constant(index, *value)?,
            DeclKind::Var { space, value, .. } => self.variable(index, *space, *value)?,
            DeclKind::Struct { open, members, close } => {
                self.upto(decl.name);
                let name = self.global_name(index);
                self.put(&name);
                self.cursor = decl.name + 1;
                self.through(*open);
                for member in members {
                    self.member_of_struct(member, *close)?;
                }
                self.through(*close);
                self.put(";");
            }
            DeclKind::Function(function) => self.function(index, function)?,
        }
        self.through(decl.last);
        Ok(())
    }

    /// `float name = value`, up to the semicolon. What GLSL does not take as constant is given as the number that it is.
    fn constant(&mut self, index: u32, value: Option<crate::export::typed::ExprId>) -> Written {
        let decl = &self.typed.tree.declarations[index as usize];
        let span = self.typed.tree.span_of(decl.name, decl.name);
        let own = self.typed.globals[index as usize].unwrap_or(Ty::Nothing);
        let ty = self.types.concrete(own);
        let Some(value) = value else { return self.refuse("an override without a value", span) };
        let written = self.type_of(ty, span)?;
        self.put(&format!("const {written} {}", self.global_name(index)));
        let asked = self.helpers.asked();
        let fits =
            own.scalar().is_none_or(|scalar| !scalar.is_abstract() || self.fits(value, scalar.concrete()));
        let text = self.apart(|writer| {
            if !fits {
                return Ok(());
            }
            writer.cursor = decl.name + 1;
            writer.skip_to(writer.equals(decl.name, value));
            writer.expr(value, writer.types.scalar(ty))
        })?;
        if self.helpers.asked() == asked && self.typed.is_constant(value) && fits {
            self.put(" ");
            self.put(&text);
        } else {
            let known = self.values.get(&index).cloned();
            match known {
                Some(value) => self.put(&format!(" = {value}")),
                // An abstract integer beyond what it would become: whoever reads it is given the number.
                None if !fits => {
                    self.put(&format!(" = {}", spelling::zero(ty.scalar().unwrap_or(Scalar::F32))))
                }
                None => return self.refuse("a constant that calls what GLSL has no constants of", span),
            }
        }
        self.cursor = decl.last;
        Ok(())
    }

    /// Whether the abstract number `value` is one of `scalar`.
    fn fits(&self, value: crate::export::typed::ExprId, scalar: Scalar) -> bool {
        self.typed.integer(value).is_none_or(|value| spelling::number(value as f64, scalar).is_some())
    }

    /// The `=` before `value`.
    fn equals(&self, name: Tok, value: crate::export::typed::ExprId) -> Tok {
        let mut tok = self.typed.tree.expr(value).first;
        while tok > name && self.typed.tree.word(tok) != "=" {
            tok -= 1;
        }
        tok
    }

    fn variable(
        &mut self,
        index: u32,
        space: Option<Tok>,
        value: Option<crate::export::typed::ExprId>,
    ) -> Written {
        let decl = &self.typed.tree.declarations[index as usize];
        let span = self.typed.tree.span_of(decl.name, decl.name);
        let ty = self.typed.globals[index as usize].unwrap_or(Ty::Nothing);
        let written = self.type_of(ty, span)?;
        let name = self.global_name(index);
        match space.map(|space| self.typed.tree.word(space)) {
            Some("private") => {}
            Some("uniform") => {
                self.std140(ty, span)?;
                let block = self.names.fresh_like(&format!("{name}_block"));
                self.put(&format!("layout(std140) uniform {block} {{ {written} {name}; }}"));
                self.cursor = decl.last;
                return Ok(());
            }
            Some(space) => return self.refuse(format!("a variable in `{space}`"), span),
            None => return self.refuse("this variable", span),
        }
        self.put(&format!("{written} {name}"));
        let asked = self.helpers.asked();
        let text = match value {
            Some(value) => self.apart(|writer| {
                writer.cursor = decl.name + 1;
                writer.skip_to(writer.equals(decl.name, value));
                writer.expr(value, writer.types.scalar(ty))
            })?,
            None => format!("= {}", self.zero(ty, span)?),
        };
        let is_constant = value.is_none_or(|value| self.typed.is_constant(value));
        match self.values.get(&index) {
            Some(value) if self.helpers.asked() != asked || !is_constant => {
                self.put(&format!(" = {}", value.clone()))
            }
            _ => self.put(&format!(" {text}")),
        }
        self.cursor = decl.last;
        Ok(())
    }

    /// WGSL's layout of a uniform buffer is that of `std140`, but for matrices of two rows and for what has a layout of its
    /// own.
    fn std140(&self, ty: Ty, span: crate::source::Span) -> Written {
        match ty {
            Ty::Matrix(_, 2, _) => {
                self.refuse("a matrix of two rows in a uniform buffer of WGSL's layout", span)
            }
            Ty::Array(index) => self.std140(self.types.of_array(index).0, span),
            Ty::Struct(index) => {
                if let DeclKind::Struct { members, .. } = &self.typed.tree.declarations[index as usize].kind {
                    for member in members {
                        let place = self.typed.tree.span_of(member.name, member.name);
                        let own = ["size", "align"]
                            .iter()
                            .any(|name| self.typed.tree.attribute(&member.attributes, name).is_some());
                        if own {
                            return self.refuse("a layout of one's own in a uniform buffer", place);
                        }
                        self.std140(self.typed.ty(member.ty), place)?;
                    }
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn member_of_struct(&mut self, member: &'w Field, close: Tok) -> Written {
        self.upto(member.name);
        let ty = self.typed.ty(member.ty);
        let written = self.type_of(ty, self.typed.tree.span(member.ty))?;
        let name = self.names.get(self.typed.tree.word(member.name)).to_owned();
        self.put(&format!("{written} {name}"));
        self.cursor = member.name + 1;
        self.skip_to(self.typed.tree.expr(member.ty).last + 1);
        let next = self.typed.tree.next(self.cursor - 1);
        if next < close && self.typed.tree.word(next) == "," {
            self.upto(next);
            self.cursor = next + 1;
        }
        self.put(";");
        Ok(())
    }

    fn function(&mut self, index: u32, function: &'w Function) -> Written {
        let decl = &self.typed.tree.declarations[index as usize];
        let span = self.typed.tree.span_of(decl.name, decl.name);
        self.result = self.typed.globals[index as usize].unwrap_or(Ty::Nothing);
        self.keep_apart(index, &function.body);
        let head = format!("{} {}", self.type_of(self.result, span)?, self.global_name(index));
        self.put(&head);
        self.cursor = decl.name + 1;
        self.through(function.open);
        for parameter in &function.parameters {
            self.upto(parameter.name);
            let written = self.parameter(parameter)?;
            self.put(&written);
            self.cursor = parameter.name + 1;
            self.skip_to(self.typed.tree.expr(parameter.ty).last + 1);
        }
        self.close(function.close);
        self.put(" ");
        self.skip_to(function.body.open);
        self.block(&function.body)
    }

    fn parameter(&mut self, parameter: &'w Field) -> Written<String> {
        let ty = self.typed.ty(parameter.ty);
        let written = self.type_of(ty, self.typed.tree.span(parameter.ty))?;
        let inout = if matches!(ty, Ty::Pointer(_)) { "inout " } else { "" };
        Ok(format!("{inout}{written} {}", self.local_name(parameter.number)))
    }

    /// `float name(vec2 p);`
    pub(super) fn prototype(&mut self, index: u32) -> Written<String> {
        let typed = self.typed;
        let decl = &typed.tree.declarations[index as usize];
        let DeclKind::Function(function) = &decl.kind else { return Ok(String::new()) };
        let span = self.typed.tree.span_of(decl.name, decl.name);
        let mut takes = Vec::with_capacity(function.parameters.len());
        for parameter in &function.parameters {
            takes.push(self.parameter(parameter)?);
        }
        let result = self.type_of(self.typed.globals[index as usize].unwrap_or(Ty::Nothing), span)?;
        Ok(format!("{result} {}({});\n", self.global_name(index), takes.join(", ")))
    }
}

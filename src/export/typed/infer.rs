//! What expressions are: [`Tree`] → [`Typed`].

use rustc_hash::FxHashMap;

use super::builtin::{self, Shape};
use super::parse::{DEEPEST, Parsed, Unreadable};
use super::tree::*;
use super::ty::{Opaque, Scalar, Ty, Types};

/// What a name stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::export) enum Meaning {
    /// A local variable or a parameter.
    Local(u32),
    /// A declaration of the module.
    Global(u32),
    /// A type of WGSL's own, or one that an alias names.
    Type(Ty),
    /// `vec3`, whose components are told by what it is made of.
    Inferred(Inferable),
    /// A function of WGSL's own.
    Function,
    /// A word that only its place gives a meaning: `function` in `ptr<function, f32>`.
    Word,
}

/// A constructor without its component type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::export) enum Inferable {
    Vector(u8),
    Matrix(u8, u8),
    Array,
}

/// A local variable.
#[derive(Debug, Clone, Copy)]
pub(in crate::export) struct Local {
    pub(in crate::export) name: Tok,
    pub(in crate::export) ty: Ty,
    pub(in crate::export) binding: Binding,
    /// The function that it is in.
    pub(in crate::export) function: u32,
}

/// A tree, and what is known of it.
pub(in crate::export) struct Typed<'a> {
    pub(in crate::export) tree: Tree<'a>,
    pub(in crate::export) types: Types,
    pub(super) ty: Vec<Ty>,
    pub(super) meaning: Vec<Meaning>,
    pub(super) constant: Vec<bool>,
    pub(in crate::export) locals: Vec<Local>,
    /// Of each declaration: the type of the value, of what the function gives, or the type itself.
    pub(in crate::export) globals: Vec<Option<Ty>>,
    /// Of each declaration, those that it names, each once.
    pub(in crate::export) references: Vec<Vec<u32>>,
    /// Of each declaration, whether calling it does more than give a value.
    pub(in crate::export) effects: Vec<bool>,
    pub(in crate::export) by_name: FxHashMap<&'a str, u32>,
    /// What local constants are set to.
    pub(super) constants: FxHashMap<u32, ExprId>,
}

impl<'a> Typed<'a> {
    /// The type of a value, or the one that a type name names.
    pub(in crate::export) fn ty(&self, id: ExprId) -> Ty {
        self.ty[id.index()]
    }

    /// What the name `id` stands for.
    pub(in crate::export) fn meaning(&self, id: ExprId) -> Meaning {
        self.meaning[id.index()]
    }

    /// Whether it is a constant expression, in GLSL as in WGSL.
    pub(in crate::export) fn is_constant(&self, id: ExprId) -> bool {
        self.constant[id.index()]
    }

    /// Names and types of the members of struct `index`.
    pub(in crate::export) fn members(&self, index: u32) -> impl Iterator<Item = (&'a str, Ty)> {
        let members: &[Field] = match &self.tree.declarations[index as usize].kind {
            DeclKind::Struct { members, .. } => members,
            _ => &[],
        };
        members.iter().map(|member| (self.tree.word(member.name), self.ty(member.ty)))
    }

    /// The types that the function `index` takes.
    pub(in crate::export) fn parameters(&self, index: u32) -> Vec<Ty> {
        match &self.tree.declarations[index as usize].kind {
            DeclKind::Function(function) => {
                function.parameters.iter().map(|field| self.ty(field.ty)).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// Types the whole of `tree`.
pub(in crate::export) fn type_check(tree: Tree<'_>) -> Parsed<Typed<'_>> {
    let (declared, expressions, locals) =
        (tree.declarations.len(), tree.expressions.len(), tree.locals as usize);
    let mut by_name = FxHashMap::default();
    for (index, decl) in tree.declarations.iter().enumerate() {
        if !matches!(decl.kind, DeclKind::Directive | DeclKind::Assert) {
            by_name.insert(tree.word(decl.name), index as u32);
        }
    }
    let nobody = Local { name: 0, ty: Ty::Nothing, binding: Binding::Let, function: 0 };
    let typed = Typed {
        tree,
        types: Types::default(),
        ty: vec![Ty::Nothing; expressions],
        meaning: vec![Meaning::Word; expressions],
        constant: vec![false; expressions],
        locals: vec![nobody; locals],
        globals: vec![None; declared],
        references: vec![Vec::new(); declared],
        effects: vec![false; declared],
        by_name,
        constants: FxHashMap::default(),
    };
    let mut typer = Typer { typed, scopes: Vec::new(), doing: 0, depth: 0 };
    for index in 0..declared as u32 {
        typer.global(index)?;
    }
    for index in 0..declared as u32 {
        typer.function(index)?;
    }
    let mut typed = typer.typed;
    typed.effects = super::effects::effects(&typed);
    Ok(typed)
}

pub(super) struct Typer<'a> {
    pub(super) typed: Typed<'a>,
    pub(super) scopes: Vec<FxHashMap<&'a str, u32>>,
    /// The declaration that is being typed.
    pub(super) doing: u32,
    depth: u32,
}

impl<'a> Typer<'a> {
    pub(super) fn unreadable<T>(
        &self,
        id: ExprId,
        what: impl Into<std::borrow::Cow<'static, str>>,
    ) -> Parsed<T> {
        Err(Unreadable { what: what.into(), span: self.typed.tree.span(id) })
    }

    /// The type of declaration `index`, worked out when first asked for: WGSL's declarations stand in any order.
    fn global(&mut self, index: u32) -> Parsed<Ty> {
        if let Some(known) = self.typed.globals[index as usize] {
            return Ok(known);
        }
        if self.depth > DEEPEST {
            let decl = &self.typed.tree.declarations[index as usize];
            return Err(Unreadable {
                what: "nesting of this depth".into(),
                span: self.typed.tree.span_of(decl.name, decl.name),
            });
        }
        self.depth += 1;
        let outer = std::mem::replace(&mut self.doing, index);
        let scopes = std::mem::take(&mut self.scopes);
        let outcome = self.declared(index);
        self.scopes = scopes;
        self.doing = outer;
        self.depth -= 1;
        let ty = outcome?;
        self.typed.globals[index as usize] = Some(ty);
        Ok(ty)
    }

    fn declared(&mut self, index: u32) -> Parsed<Ty> {
        /// What of a declaration has to be typed, without holding on to it.
        enum Parts {
            Value(Option<ExprId>, Option<ExprId>, bool),
            Fields(Vec<ExprId>),
            Function(Vec<ExprId>, Option<ExprId>),
            Alias(ExprId),
            Nothing,
        }
        let parts = match &self.typed.tree.declarations[index as usize].kind {
            DeclKind::Const { ty, value } => Parts::Value(*ty, Some(*value), false),
            DeclKind::Override { ty, value } | DeclKind::Var { ty, value, .. } => {
                Parts::Value(*ty, *value, true)
            }
            DeclKind::Struct { members, .. } => {
                Parts::Fields(members.iter().map(|member| member.ty).collect())
            }
            DeclKind::Function(function) => {
                Parts::Function(function.parameters.iter().map(|field| field.ty).collect(), function.result)
            }
            DeclKind::Alias(ty) => Parts::Alias(*ty),
            DeclKind::Directive | DeclKind::Assert => Parts::Nothing,
        };
        Ok(match parts {
            Parts::Value(ty, value, concrete) => {
                let own = value.map(|value| self.expr(value)).transpose()?;
                match ty {
                    Some(ty) => self.type_name(ty)?,
                    None if concrete => self.typed.types.concrete(own.unwrap_or(Ty::Nothing)),
                    None => own.unwrap_or(Ty::Nothing),
                }
            }
            Parts::Fields(types) => {
                for ty in types {
                    self.type_name(ty)?;
                }
                Ty::Struct(index)
            }
            Parts::Function(types, result) => {
                for ty in types {
                    self.type_name(ty)?;
                }
                result.map_or(Ok(Ty::Nothing), |result| self.type_name(result))?
            }
            Parts::Alias(ty) => self.type_name(ty)?,
            Parts::Nothing => Ty::Nothing,
        })
    }

    fn lookup(&self, name: &str) -> Option<u32> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name).copied())
    }

    fn global_named(&mut self, name: &str) -> Option<u32> {
        let index = *self.typed.by_name.get(name)?;
        let doing = self.doing as usize;
        if !self.typed.references[doing].contains(&index) {
            self.typed.references[doing].push(index);
        }
        Some(index)
    }

    /// The type that `id` names.
    pub(super) fn type_name(&mut self, id: ExprId) -> Parsed<Ty> {
        let ExprKind::Name { arguments } = &self.typed.tree.expr(id).kind else {
            return self.unreadable(id, "this type");
        };
        let arguments = arguments.clone();
        let name = self.typed.tree.word(self.typed.tree.expr(id).first);
        let (meaning, ty) = match self.global_named(name) {
            Some(index) => {
                let ty = self.global(index)?;
                (Meaning::Global(index), ty)
            }
            None => {
                let ty = self.own_type(id, name, &arguments)?;
                (Meaning::Type(ty), ty)
            }
        };
        self.typed.meaning[id.index()] = meaning;
        self.typed.ty[id.index()] = ty;
        Ok(ty)
    }

    fn own_type(&mut self, id: ExprId, name: &str, arguments: &[ExprId]) -> Parsed<Ty> {
        if let Some((shape, scalar)) = builtin::constructor(name) {
            return match (scalar, arguments) {
                (Some(scalar), []) => Ok(shape.of(scalar)),
                (None, [element]) => match self.type_name(*element)?.scalar() {
                    Some(scalar) => Ok(shape.of(scalar)),
                    None => self.unreadable(id, "this type"),
                },
                _ => self.unreadable(id, "this type"),
            };
        }
        match (name, arguments) {
            ("array", [element]) => {
                let element = self.type_name(*element)?;
                Ok(self.typed.types.array(element, None))
            }
            ("array", [element, len]) => {
                let element = self.type_name(*element)?;
                self.expr(*len)?;
                let Some(count) = self.typed.integer(*len).and_then(|len| u32::try_from(len).ok()) else {
                    return self.unreadable(*len, "the length of this array");
                };
                Ok(self.typed.types.array(element, Some(count)))
            }
            ("ptr", [_, pointee, ..]) => {
                let pointee = self.type_name(*pointee)?;
                Ok(self.typed.types.pointer(pointee))
            }
            ("atomic", _) => Ok(Ty::Opaque(Opaque::Atomic)),
            _ if name.starts_with("texture_") => Ok(Ty::Opaque(Opaque::Texture)),
            _ if name.starts_with("sampler") => Ok(Ty::Opaque(Opaque::Sampler)),
            _ => self.unreadable(id, "this type"),
        }
    }

    /// Types the expression `id` and all in it.
    pub(super) fn expr(&mut self, id: ExprId) -> Parsed<Ty> {
        let (ty, constant) = self.of_expr(id)?;
        // Only what is constant stays abstract: `[1, 2][i]` is an `i32`.
        let ty = if constant { ty } else { self.typed.types.concrete(ty) };
        self.typed.ty[id.index()] = ty;
        self.typed.constant[id.index()] = constant;
        Ok(ty)
    }

    fn of_expr(&mut self, id: ExprId) -> Parsed<(Ty, bool)> {
        /// The parts of an expression, without holding on to the tree.
        enum Parts {
            Literal,
            Name,
            Call(ExprId, Vec<ExprId>),
            Index(ExprId, ExprId),
            Member(ExprId, Tok),
            Unary(ExprId),
            Binary(ExprId, Tok, ExprId),
            Paren(ExprId),
        }
        let parts = match &self.typed.tree.expr(id).kind {
            ExprKind::Literal => Parts::Literal,
            ExprKind::Name { .. } => Parts::Name,
            ExprKind::Call { callee, arguments } => Parts::Call(*callee, arguments.clone()),
            ExprKind::Index { base, index } => Parts::Index(*base, *index),
            ExprKind::Member { base, name } => Parts::Member(*base, *name),
            ExprKind::Unary { operand } => Parts::Unary(*operand),
            ExprKind::Binary { left, operator, right } => Parts::Binary(*left, *operator, *right),
            ExprKind::Paren { inner } => Parts::Paren(*inner),
        };
        let first = self.typed.tree.expr(id).first;
        match parts {
            Parts::Literal => Ok((literal(self.typed.tree.word(first)), true)),
            Parts::Name => self.variable(id, first),
            Parts::Paren(inner) => Ok((self.expr(inner)?, self.typed.is_constant(inner))),
            Parts::Unary(operand) => {
                let ty = self.expr(operand)?;
                let constant = self.typed.is_constant(operand);
                Ok(match self.typed.tree.word(first) {
                    "&" => (self.typed.types.pointer(ty), false),
                    "*" => (self.typed.types.pointee(ty), false),
                    _ => (ty, constant),
                })
            }
            Parts::Binary(left, operator, right) => {
                let (a, b) = (self.expr(left)?, self.expr(right)?);
                let constant = self.typed.is_constant(left) && self.typed.is_constant(right);
                match binary(self.typed.tree.word(operator), a, b, constant) {
                    Some(ty) => Ok((ty, constant)),
                    None => self.unreadable(id, "this operator"),
                }
            }
            Parts::Index(base, index) => {
                let base_ty = self.expr(base)?;
                self.expr(index)?;
                let constant = self.typed.is_constant(base) && self.typed.is_constant(index);
                match self.typed.types.pointee(base_ty) {
                    Ty::Vector(_, scalar) => Ok((Ty::Scalar(scalar), constant)),
                    Ty::Matrix(_, rows, scalar) => Ok((Ty::Vector(rows, scalar), constant)),
                    Ty::Array(array) => Ok((self.typed.types.of_array(array).0, constant)),
                    _ => self.unreadable(id, "this index"),
                }
            }
            Parts::Member(base, name) => {
                let base_ty = self.expr(base)?;
                let ty = self.member(self.typed.types.pointee(base_ty), self.typed.tree.word(name));
                match ty {
                    Some(ty) => Ok((ty, self.typed.is_constant(base))),
                    None => self.unreadable(id, "this member"),
                }
            }
            Parts::Call(callee, arguments) => self.call(id, callee, &arguments),
        }
    }

    fn variable(&mut self, id: ExprId, first: Tok) -> Parsed<(Ty, bool)> {
        let name = self.typed.tree.word(first);
        if let Some(local) = self.lookup(name) {
            self.typed.meaning[id.index()] = Meaning::Local(local);
            let local = self.typed.locals[local as usize];
            return Ok((local.ty, local.binding == Binding::Const));
        }
        if let Some(index) = self.global_named(name) {
            let ty = self.global(index)?;
            self.typed.meaning[id.index()] = Meaning::Global(index);
            let kind = &self.typed.tree.declarations[index as usize].kind;
            return Ok((ty, matches!(kind, DeclKind::Const { .. } | DeclKind::Override { .. })));
        }
        self.unreadable(id, "this name")
    }

    fn member(&self, base: Ty, name: &str) -> Option<Ty> {
        match base {
            Ty::Vector(_, scalar)
                if name.len() <= 4 && name.bytes().all(|byte| b"xyzwrgba".contains(&byte)) =>
            {
                Some(Ty::of(name.len() as u8, scalar))
            }
            Ty::Struct(index) => {
                self.typed.members(index).find(|(known, _)| *known == name).map(|(_, ty)| ty)
            }
            Ty::Modf(n) => Some(Ty::of(n, Scalar::F32)),
            Ty::Frexp(n) => Some(Ty::of(n, if name == "exp" { Scalar::I32 } else { Scalar::F32 })),
            _ => None,
        }
    }

    fn call(&mut self, id: ExprId, callee: ExprId, arguments: &[ExprId]) -> Parsed<(Ty, bool)> {
        let mut types = Vec::with_capacity(arguments.len());
        let mut constant = true;
        for argument in arguments {
            types.push(self.expr(*argument)?);
            constant &= self.typed.is_constant(*argument);
        }
        let name = self.typed.tree.word(self.typed.tree.expr(callee).first);
        if let Some(index) = self.global_named(name) {
            let ty = self.global(index)?;
            self.typed.meaning[callee.index()] = Meaning::Global(index);
            let is_function =
                matches!(self.typed.tree.declarations[index as usize].kind, DeclKind::Function(_));
            return Ok((ty, constant && !is_function));
        }
        let has_list = matches!(&self.typed.tree.expr(callee).kind, ExprKind::Name { arguments } if !arguments.is_empty());
        if name == "bitcast" {
            let ExprKind::Name { arguments } = &self.typed.tree.expr(callee).kind else {
                return self.unreadable(callee, "this call");
            };
            let Some(to) = arguments.first().copied() else { return self.unreadable(callee, "this call") };
            self.typed.meaning[callee.index()] = Meaning::Function;
            return Ok((self.type_name(to)?, constant));
        }
        if has_list || matches!(builtin::constructor(name), Some((_, Some(_)))) {
            return Ok((self.type_name(callee)?, constant));
        }
        if let Some((shape, None)) = builtin::constructor(name) {
            let (scalar, inferred) = match shape {
                Shape::Vector(n) => {
                    (types.iter().filter_map(|ty| ty.scalar()).reduce(Scalar::unify), Inferable::Vector(n))
                }
                Shape::Matrix(c, r) => {
                    let scalar = types.iter().filter_map(|ty| ty.scalar()).reduce(Scalar::unify);
                    let float = if scalar == Some(Scalar::AbstractInt) {
                        Some(Scalar::AbstractFloat)
                    } else {
                        scalar
                    };
                    (float, Inferable::Matrix(c, r))
                }
                Shape::Scalar => return self.unreadable(callee, "this call"),
            };
            self.typed.meaning[callee.index()] = Meaning::Inferred(inferred);
            return Ok((shape.of(scalar.unwrap_or(Scalar::AbstractInt)), constant));
        }
        if name == "array" {
            self.typed.meaning[callee.index()] = Meaning::Inferred(Inferable::Array);
            let element = match types.first() {
                Some(first) if first.scalar().is_some() => builtin::together(&types),
                other => other.copied(),
            };
            let Some(element) = element else { return self.unreadable(id, "this array") };
            return Ok((self.typed.types.array(element, Some(types.len() as u32)), constant));
        }
        self.typed.meaning[callee.index()] = Meaning::Function;
        match builtin::result(name, &types) {
            Some(ty) => Ok((ty, constant && !name.starts_with("dpd") && !name.starts_with("fwidth"))),
            None => self.unreadable(callee, format!("`{name}`")),
        }
    }
}

/// The type of a literal.
fn literal(word: &str) -> Ty {
    if matches!(word, "true" | "false") {
        return Ty::BOOL;
    }
    let is_hex = word.starts_with("0x") || word.starts_with("0X");
    let is_float = if is_hex { word.contains(['.', 'p', 'P']) } else { word.contains(['.', 'e', 'E']) };
    Ty::Scalar(match word.as_bytes().last() {
        Some(b'u') => Scalar::U32,
        Some(b'i') => Scalar::I32,
        Some(b'f') if is_float || !is_hex => Scalar::F32,
        _ if is_float => Scalar::AbstractFloat,
        _ => Scalar::AbstractInt,
    })
}

/// What an operator gives for operands of these types.
fn binary(operator: &str, a: Ty, b: Ty, constant: bool) -> Option<Ty> {
    let together = || builtin::together(&[a, b]);
    Some(match operator {
        "&&" | "||" => Ty::BOOL,
        "==" | "!=" | "<" | "<=" | ">" | ">=" => together()?.with(Scalar::Bool),
        "<<" | ">>" => {
            if constant {
                a
            } else {
                a.with(a.scalar()?.concrete())
            }
        }
        "*" => match (a, b) {
            (Ty::Matrix(_, rows, s), Ty::Vector(_, t)) => Ty::Vector(rows, s.unify(t)),
            (Ty::Vector(_, s), Ty::Matrix(columns, _, t)) => Ty::Vector(columns, s.unify(t)),
            (Ty::Matrix(_, rows, s), Ty::Matrix(columns, _, t)) => Ty::Matrix(columns, rows, s.unify(t)),
            _ => together()?,
        },
        _ => together()?,
    })
}

//! Calls: constructors, conversions, the author's functions, and WGSL's own.

use super::spelling;
use super::write::{Writer, Written};
use super::write_expr::Wanted;
use crate::export::typed::{DeclKind, ExprId, ExprKind, Meaning, Scalar, Tok, Ty};
use crate::syntax::TokenKind;

impl Writer<'_, '_> {
    pub(super) fn call(&mut self, id: ExprId, wanted: Wanted) -> Written {
        let ExprKind::Call { callee, arguments } = &self.typed.tree.expr(id).kind else { return Ok(()) };
        let (callee, arguments) = (*callee, arguments.clone());
        let is_function =
            |index: u32| matches!(self.typed.tree.declarations[index as usize].kind, DeclKind::Function(_));
        match (self.typed.meaning(callee), self.typed.ty(id)) {
            (Meaning::Global(index), _) if is_function(index) => {
                let takes: Vec<Wanted> =
                    self.typed.parameters(index).iter().map(|ty| self.types.scalar(*ty)).collect();
                let name = self.global_name(index);
                // What comes later in the expression around it finds this call done.
                let later = std::mem::take(&mut self.later);
                let outcome = self.named(id, &name, &arguments, |at| takes.get(at).copied().flatten());
                self.later = later;
                outcome
            }
            // By its name, or by that of an alias.
            (Meaning::Global(_) | Meaning::Type(_), Ty::Struct(index)) => {
                if arguments.is_empty() {
                    return self.empty(id);
                }
                let takes: Vec<Wanted> =
                    self.typed.members(index).map(|(_, ty)| self.types.scalar(ty)).collect();
                let name = self.global_name(index);
                self.named(id, &name, &arguments, |at| takes.get(at).copied().flatten())
            }
            (Meaning::Global(_), _) => self.construct(id, &arguments, wanted),
            (Meaning::Type(_) | Meaning::Inferred(_), _) => {
                let is_bitcast = self.typed.tree.word(self.typed.tree.expr(callee).first) == "bitcast";
                if is_bitcast { self.bitcast(id, &arguments) } else { self.construct(id, &arguments, wanted) }
            }
            _ => {
                let name = self.typed.tree.word(self.typed.tree.expr(callee).first);
                if name == "bitcast" {
                    self.bitcast(id, &arguments)
                } else {
                    self.own(id, name, &arguments, wanted)
                }
            }
        }
    }

    /// `name(arguments)`, each as the scalar that `wanted` says.
    fn named(
        &mut self,
        id: ExprId,
        name: &str,
        arguments: &[ExprId],
        wanted: impl Fn(usize) -> Wanted,
    ) -> Written {
        self.put(name);
        self.skip_to(self.opening(id));
        self.list(id, arguments, wanted)
    }

    /// The `(` of a call.
    fn opening(&self, id: ExprId) -> Tok {
        let ExprKind::Call { callee, .. } = self.typed.tree.expr(id).kind else {
            return self.typed.tree.expr(id).first;
        };
        self.typed.tree.next(self.typed.tree.expr(callee).last)
    }

    /// `(arguments)`, without the comma that may stand at their end.
    fn list(&mut self, id: ExprId, arguments: &[ExprId], wanted: impl Fn(usize) -> Wanted) -> Written {
        for (at, argument) in arguments.iter().enumerate() {
            self.upto(self.typed.tree.expr(*argument).first);
            self.before(&arguments[at + 1..], |writer| writer.expr(*argument, wanted(at)))?;
        }
        self.close(self.typed.tree.expr(id).last);
        Ok(())
    }

    /// Up to and with the bracket `last`; a comma before it stays behind.
    pub(super) fn close(&mut self, last: Tok) {
        let next = self.typed.tree.next(self.cursor.saturating_sub(1));
        if next < last && self.typed.tree.kind(next) == TokenKind::Comma {
            self.upto(next);
            self.cursor = next + 1;
        }
        self.through(last);
    }

    /// Zero.
    fn empty(&mut self, id: ExprId) -> Written {
        let ty = self.types.concrete(self.typed.ty(id));
        let zero = self.zero(ty, self.typed.tree.span(id))?;
        self.put(&zero);
        Ok(())
    }

    /// A value of the type that the call names, of parts or from a value of another type.
    fn construct(&mut self, id: ExprId, arguments: &[ExprId], wanted: Wanted) -> Written {
        if arguments.is_empty() {
            return self.empty(id);
        }
        let ty = self.typed.ty(id);
        let scalar = self.settled(ty, wanted);
        if let Ty::Array(index) = ty {
            return self.array(id, index, arguments, scalar);
        }
        if let [only] = arguments
            && scalar.is_integer()
            && self.typed.ty(*only).scalar() == Some(Scalar::F32)
            && !self.typed.is_constant(*only)
        {
            let name = if scalar == Scalar::U32 { "uint" } else { "int" };
            let from = Ty::of(ty.size(), Scalar::F32);
            let name = self.helpers.ask(name, from);
            return self.named(id, &name, arguments, |_| None);
        }
        let from_float = |writer: &Self, argument: ExprId| {
            writer.typed.ty(argument).scalar() == Some(Scalar::AbstractFloat) && scalar.is_integer()
        };
        let kinds: Vec<Wanted> = arguments
            .iter()
            .map(|argument| Some(if from_float(self, *argument) { Scalar::F32 } else { scalar }))
            .collect();
        let name = spelling::numeric(ty.with(scalar));
        let kinds: Vec<Wanted> = if scalar == Scalar::Bool { vec![None; kinds.len()] } else { kinds };
        self.named(id, &name, arguments, |at| kinds.get(at).copied().flatten())
    }

    fn array(&mut self, id: ExprId, index: u32, arguments: &[ExprId], scalar: Scalar) -> Written {
        let span = self.typed.tree.span(id);
        let ty = self.types.concrete(self.typed.ty(id));
        let mut name = self.type_of(ty, span)?;
        let (element, len) = self.types.of_array(index);
        if element.scalar().is_some_and(Scalar::is_abstract) {
            // As many as there are, of the scalar that is wanted.
            name = format!("{}[{}]", spelling::numeric(element.with(scalar)), len.unwrap_or(0));
        }
        let row = self.row(element, span)?;
        self.put(&name);
        self.skip_to(self.opening(id));
        for (at, argument) in arguments.iter().enumerate() {
            self.upto(self.typed.tree.expr(*argument).first);
            if let Some(row) = &row {
                self.put(&format!("{row}("));
            }
            self.before(&arguments[at + 1..], |writer| writer.expr(*argument, Some(scalar)))?;
            if row.is_some() {
                self.put(")");
            }
        }
        self.close(self.typed.tree.expr(id).last);
        Ok(())
    }

    fn bitcast(&mut self, id: ExprId, arguments: &[ExprId]) -> Written {
        let [only] = arguments else { return self.refuse("this conversion", self.typed.tree.span(id)) };
        let (from, to) = (self.typed.ty(*only), self.typed.ty(id));
        if from.size() != to.size() {
            return self.refuse("a `bitcast` between types of different sizes", self.typed.tree.span(id));
        }
        let own = from.scalar().unwrap_or(Scalar::F32);
        // An abstract integer has the bits of whichever integer it fits.
        let (from, to) = (own.concrete(), to.scalar().unwrap_or(Scalar::F32));
        let from = match self.typed.integer(*only) {
            Some(value) if own.is_abstract() && i32::try_from(value).is_err() => Scalar::U32,
            _ => from,
        };
        let name = match (from, to) {
            (Scalar::F32, Scalar::I32) => "floatBitsToInt".to_owned(),
            (Scalar::F32, Scalar::U32) => "floatBitsToUint".to_owned(),
            (Scalar::I32, Scalar::F32) => "intBitsToFloat".to_owned(),
            (Scalar::U32, Scalar::F32) => "uintBitsToFloat".to_owned(),
            _ => spelling::numeric(self.typed.ty(id)),
        };
        self.named(id, &name, arguments, |_| Some(from))
    }

    /// A function of WGSL's own.
    fn own(&mut self, id: ExprId, name: &str, arguments: &[ExprId], wanted: Wanted) -> Written {
        let span = self.typed.tree.span(id);
        let types: Vec<Ty> = arguments.iter().map(|argument| self.typed.ty(*argument)).collect();
        let Some(first) = types.first().copied() else { return self.refuse(format!("`{name}`"), span) };
        let together = types.iter().filter_map(|ty| ty.scalar()).filter(|scalar| *scalar != Scalar::Bool);
        let together = together.reduce(Scalar::unify).unwrap_or(Scalar::Bool);
        // What the abstract arguments become.
        let scalar = match self.typed.ty(id).scalar() {
            _ if !together.is_abstract() => together,
            Some(given) if given.is_abstract() => self.settled(self.typed.ty(id), wanted),
            Some(Scalar::F32) => Scalar::F32,
            _ => together.concrete(),
        };
        let size = types.iter().map(|ty| ty.size()).max().unwrap_or(1);
        let whole = Ty::of(size, scalar);
        let same = |_: usize| Some(scalar);
        let shaped = |writer: &mut Self, name: &str| writer.named(id, name, arguments, same);
        match name {
            "all" | "any" if size == 1 => shaped(self, ""),
            "abs" if scalar == Scalar::U32 => shaped(self, ""),
            "dot" if scalar.is_integer() => {
                let name = self.helpers.ask_shaped("dot", whole);
                shaped(self, &name)
            }
            "inverseSqrt" => shaped(self, "inversesqrt"),
            "faceForward" => shaped(self, "faceforward"),
            "atan2" => shaped(self, "atan"),
            "round" => shaped(self, "roundEven"),
            "dpdx" | "dpdxCoarse" | "dpdxFine" => shaped(self, "dFdx"),
            "dpdy" | "dpdyCoarse" | "dpdyFine" if self.flipped => {
                self.put("(-");
                shaped(self, "dFdy")?;
                self.put(")");
                Ok(())
            }
            "dpdy" | "dpdyCoarse" | "dpdyFine" => shaped(self, "dFdy"),
            "fwidthCoarse" | "fwidthFine" => shaped(self, "fwidth"),
            "saturate" => {
                self.put("clamp");
                self.skip_to(self.opening(id));
                self.through(self.opening(id));
                self.expr(arguments[0], same(0))?;
                self.put(", 0.0, 1.0");
                self.close(self.typed.tree.expr(id).last);
                Ok(())
            }
            "fma" => {
                let [a, b, c] = arguments else { return self.refuse("this call", span) };
                self.put("(");
                for (at, (part, between)) in [(*a, "("), (*b, ") * ("), (*c, ") + (")].into_iter().enumerate()
                {
                    self.put(between);
                    self.skip_to(self.typed.tree.expr(part).first);
                    self.before(&arguments[at + 1..], |writer| writer.sized(part, size, scalar))?;
                }
                self.put("))");
                self.skip_to(self.typed.tree.expr(id).last + 1);
                Ok(())
            }
            "select" => self.select(id, arguments, whole),
            "modf" | "frexp" => {
                let name = if name == "modf" { "modf" } else { "frexp" };
                let name = self.helpers.ask_shaped(name, Ty::of(size, Scalar::F32));
                self.named(id, &name, arguments, |_| Some(Scalar::F32))
            }
            "ldexp" => {
                let name = self.helpers.ask("ldexp", Ty::of(size, Scalar::F32));
                self.named(id, &name, arguments, |at| Some(if at == 0 { Scalar::F32 } else { Scalar::I32 }))
            }
            "quantizeToF16" => self.quantize(id, arguments, size),
            "extractBits" | "insertBits" => {
                let values = if name == "extractBits" { 1 } else { 2 };
                let own = types[..values.min(types.len())]
                    .iter()
                    .filter_map(|ty| ty.scalar())
                    .reduce(Scalar::unify);
                let own = own.unwrap_or(Scalar::U32).concrete();
                let name = if name == "extractBits" { "extract_bits" } else { "insert_bits" };
                let name = self.helpers.ask(name, Ty::of(first.size(), own));
                self.named(id, &name, arguments, |at| Some(if at < values { own } else { Scalar::U32 }))
            }
            "countOneBits" | "countLeadingZeros" | "countTrailingZeros" | "firstLeadingBit"
            | "firstTrailingBit" | "reverseBits" => {
                let name = match name {
                    "countOneBits" => "count_one_bits",
                    "countLeadingZeros" => "count_leading_zeros",
                    "countTrailingZeros" => "count_trailing_zeros",
                    "firstLeadingBit" => "first_leading_bit",
                    "firstTrailingBit" => "first_trailing_bit",
                    _ => "reverse_bits",
                };
                let name = self.helpers.ask(name, whole);
                shaped(self, &name)
            }
            "pack2x16snorm" => shaped(self, "packSnorm2x16"),
            "pack2x16unorm" => shaped(self, "packUnorm2x16"),
            "pack2x16float" => shaped(self, "packHalf2x16"),
            "unpack2x16snorm" => self.named(id, "unpackSnorm2x16", arguments, |_| Some(Scalar::U32)),
            "unpack2x16unorm" => self.named(id, "unpackUnorm2x16", arguments, |_| Some(Scalar::U32)),
            "unpack2x16float" => self.named(id, "unpackHalf2x16", arguments, |_| Some(Scalar::U32)),
            _ => {
                if let Some(helper) = self.helpers.ask_whole(name) {
                    let kind = match name {
                        "pack4x8snorm" | "pack4x8unorm" => Scalar::F32,
                        "pack4xI8" | "pack4xI8Clamp" => Scalar::I32,
                        _ => Scalar::U32,
                    };
                    return self.named(id, &helper, arguments, |_| Some(kind));
                }
                if KEPT.contains(&name) { shaped(self, name) } else { self.refuse(format!("`{name}`"), span) }
            }
        }
    }

    fn quantize(&mut self, id: ExprId, arguments: &[ExprId], size: u8) -> Written {
        let Some(name) = self.helpers.ask_whole("quantize") else { return Ok(()) };
        if size == 1 {
            return self.named(id, &name, arguments, |_| Some(Scalar::F32));
        }
        // Component by component: what is quantized is written into one call for each.
        if self.typed.has_effect(arguments[0]) {
            return self.refuse(
                "`quantizeToF16` of a vector that a call with side effects gives",
                self.typed.tree.span(id),
            );
        }
        let one = self.apart(|writer| {
            writer.cursor = writer.typed.tree.expr(arguments[0]).first;
            writer.expr(arguments[0], Some(Scalar::F32))
        })?;
        let parts: Vec<_> =
            "xyzw".chars().take(size.into()).map(|c| format!("{name}(({one}).{c})")).collect();
        self.put(&format!("vec{size}({})", parts.join(", ")));
        Ok(())
    }

    fn select(&mut self, id: ExprId, arguments: &[ExprId], ty: Ty) -> Written {
        let [no, yes, condition] = arguments else {
            return self.refuse("this call", self.typed.tree.span(id));
        };
        let (no, yes, condition) = (*no, *yes, *condition);
        let scalar = ty.scalar().unwrap_or(Scalar::F32);
        let scalar = if self.typed.ty(no).scalar() == Some(Scalar::Bool) { Scalar::Bool } else { scalar };
        let last = self.typed.tree.expr(id).last;
        let picks_components = self.typed.ty(condition).is_vector();
        let has_effect =
            self.typed.has_effect(no) || self.typed.has_effect(yes) || self.typed.has_effect(condition);
        if picks_components && scalar == Scalar::F32 {
            return self.named(id, "mix", arguments, |at| (at < 2).then_some(scalar));
        }
        if picks_components || has_effect {
            let size = self.typed.ty(no).size();
            if self.typed.ty(no).scalar().is_none() || (has_effect && !picks_components && size > 1) {
                return self.refuse(
                    "`select` of these values from calls with side effects",
                    self.typed.tree.span(id),
                );
            }
            let name = self.helpers.ask("select", Ty::of(size, scalar));
            return self.named(id, &name, arguments, |at| (at < 2).then_some(scalar));
        }
        // Both may be worked out, and one is enough: they do nothing but give a value.
        self.put("(");
        self.part(condition, None)?;
        self.put(" ? ");
        self.part(yes, Some(scalar))?;
        self.put(" : ");
        self.part(no, Some(scalar))?;
        self.put(")");
        self.cursor = last + 1;
        Ok(())
    }

    /// A part that is written out of its order.
    fn part(&mut self, id: ExprId, wanted: Wanted) -> Written {
        self.cursor = self.typed.tree.expr(id).first;
        self.expr(id, wanted) // `?:` binds less than all that WGSL has
    }
}

/// What both languages call the same.
const KEPT: [&str; 44] = [
    "abs",
    "acos",
    "acosh",
    "all",
    "any",
    "asin",
    "asinh",
    "atan",
    "atanh",
    "ceil",
    "clamp",
    "cos",
    "cosh",
    "cross",
    "degrees",
    "determinant",
    "distance",
    "dot",
    "exp",
    "exp2",
    "floor",
    "fract",
    "fwidth",
    "length",
    "log",
    "log2",
    "max",
    "min",
    "mix",
    "normalize",
    "pow",
    "radians",
    "reflect",
    "refract",
    "sign",
    "sin",
    "sinh",
    "smoothstep",
    "sqrt",
    "step",
    "tan",
    "tanh",
    "transpose",
    "trunc",
];

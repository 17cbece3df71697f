//! Expressions. An abstract one is written as the scalar that is wanted of it.

use super::spelling;
use super::write::{Writer, Written};
use crate::export::typed::{Binding, DeclKind, ExprId, ExprKind, Meaning, Number, Scalar, Tok, Ty};

/// The scalar that an abstract expression is wanted as; none for what it becomes by itself.
pub(super) type Wanted = Option<Scalar>;

impl Writer<'_, '_> {
    pub(super) fn expr(&mut self, id: ExprId, wanted: Wanted) -> Written {
        let (first, last) = (self.typed.tree.expr(id).first, self.typed.tree.expr(id).last);
        if self.cursor < first {
            self.upto(first);
        }
        self.cursor = first;
        if let Some(text) = self.folded(id, wanted) {
            self.put(&text);
            self.cursor = last + 1;
            return Ok(());
        }
        let as_place = std::mem::take(&mut self.as_place);
        if !as_place && self.changes_later(id) {
            return self.now(id, wanted);
        }
        match self.typed.tree.expr(id).kind {
            ExprKind::Literal => {
                let text = self.literal(id, wanted)?;
                self.put(&text);
            }
            ExprKind::Name { .. } => self.name(id, wanted)?,
            ExprKind::Paren { inner } => {
                self.through(first);
                self.as_place = as_place;
                self.expr(inner, wanted)?;
                self.upto(last);
                self.through(last);
            }
            ExprKind::Member { base, name } => self.member(id, base, name, wanted)?,
            ExprKind::Index { base, index } => self.index(id, base, index, wanted)?,
            ExprKind::Unary { operand } => self.unary(id, operand, wanted)?,
            ExprKind::Binary { left, operator, right } => self.binary(id, left, operator, right, wanted)?,
            ExprKind::Call { .. } => self.call(id, wanted)?,
        }
        self.cursor = last + 1;
        Ok(())
    }

    fn index(&mut self, id: ExprId, base: ExprId, index: ExprId, wanted: Wanted) -> Written {
        // An array of abstract numbers is declared as what they become by themselves.
        let ty = self.typed.ty(id);
        let settled = self.settled(ty, wanted);
        let of_array = matches!(self.typed.ty(base), Ty::Array(_));
        let converted =
            of_array && ty.scalar().is_some_and(|own| own.is_abstract() && own.concrete() != settled);
        if converted {
            self.put(&format!("{}(", spelling::numeric(ty.with(settled))));
        }
        self.as_place = true;
        self.expr(base, if of_array { None } else { wanted })?;
        self.upto(self.typed.tree.expr(index).first);
        self.expr(index, Some(Scalar::I32))?;
        self.through(self.typed.tree.expr(id).last);
        if matches!(ty, Ty::Array(_)) {
            self.put(".row");
        }
        if converted {
            self.put(")");
        }
        Ok(())
    }

    /// The scalar that an expression of type `ty` is written as.
    pub(super) fn settled(&self, ty: Ty, wanted: Wanted) -> Scalar {
        match self.types.scalar(ty) {
            Some(scalar) if scalar.is_abstract() => match wanted {
                Some(wanted) if wanted != Scalar::Bool => wanted,
                _ => scalar.concrete(),
            },
            Some(scalar) => scalar,
            None => Scalar::F32,
        }
    }

    /// An abstract calculation whose value GLSL would not get to, step by step in the type that is wanted: its value.
    fn folded(&self, id: ExprId, wanted: Wanted) -> Option<String> {
        let ty = self.typed.ty(id);
        let Ty::Scalar(scalar) = ty else { return None };
        if scalar == Scalar::Bool {
            return self.compared(id).map(|holds| holds.to_string());
        }
        let kind = &self.typed.tree.expr(self.typed.tree.bare(id)).kind;
        let is_calculation = matches!(kind, ExprKind::Binary { .. } | ExprKind::Unary { .. });
        if !is_calculation || !(scalar.is_abstract() || self.is_remainder_of_negatives(id)) {
            return None;
        }
        let settled = self.settled(ty, wanted);
        let number = self.typed.number(id)?;
        let (exact, is_kept) = match number {
            Number::Float { exact, single } => {
                let ulp = f64::from(single.abs()) * f64::from(f32::EPSILON);
                (exact, settled == Scalar::F32 && (exact - f64::from(single)).abs() <= ulp)
            }
            Number::Int(value) => (value as f64, self.stays_in_range(id, settled)),
        };
        if is_kept { None } else { spelling::number(exact, settled) }
    }

    /// Whether a comparison of abstract numbers holds, where GLSL would come to another answer or to none.
    fn compared(&self, id: ExprId) -> Option<bool> {
        let ExprKind::Binary { left, operator, right } = self.typed.tree.expr(self.typed.tree.bare(id)).kind
        else {
            return None;
        };
        let is_abstract = |id| self.typed.ty(id).scalar().is_some_and(Scalar::is_abstract);
        if !is_abstract(left) || !is_abstract(right) {
            return None;
        }
        let (a, b) = (self.typed.number(left)?, self.typed.number(right)?);
        let (exact, single) = a.compare(self.typed.tree.word(operator), b)?;
        let stay = [left, right].iter().all(|id| self.stays_in_range(*id, Scalar::I32));
        (exact != single || !stay).then_some(exact)
    }

    /// Whether `id` is what a division leaves of constant integers that GLSL does not define, one of them being negative.
    fn is_remainder_of_negatives(&self, id: ExprId) -> bool {
        let ExprKind::Binary { left, operator, right } = self.typed.tree.expr(self.typed.tree.bare(id)).kind
        else {
            return false;
        };
        let is_negative = |id| self.typed.integer(id).is_some_and(|value| value < 0);
        self.typed.tree.word(operator) == "%" && (is_negative(left) || is_negative(right))
    }

    /// Whether no step of an integer calculation leaves `scalar`, nor rounds in it.
    fn stays_in_range(&self, id: ExprId, scalar: Scalar) -> bool {
        let Some(value) = self.typed.integer(id) else { return true };
        let fits = match scalar {
            Scalar::U32 => u32::try_from(value).is_ok(),
            // The division of integers is not that of floats.
            Scalar::F32 => value.abs() < 1 << 24,
            _ => i32::try_from(value).is_ok(),
        };
        fits && match &self.typed.tree.expr(id).kind {
            ExprKind::Paren { inner } => self.stays_in_range(*inner, scalar),
            ExprKind::Unary { operand } => scalar != Scalar::U32 && self.stays_in_range(*operand, scalar),
            ExprKind::Binary { left, operator, right } => {
                let operator = self.typed.tree.word(*operator);
                let is_plain = matches!(operator, "+" | "-" | "*") || scalar != Scalar::F32;
                is_plain
                    && !self.is_remainder_of_negatives(id)
                    && self.stays_in_range(*left, scalar)
                    && self.stays_in_range(*right, scalar)
            }
            _ => true,
        }
    }

    fn literal(&self, id: ExprId, wanted: Wanted) -> Written<String> {
        let word = self.typed.tree.word(self.typed.tree.expr(id).first);
        if matches!(word, "true" | "false") {
            return Ok(word.to_owned());
        }
        let settled = self.settled(self.typed.ty(id), wanted);
        let is_hex = word.starts_with("0x") || word.starts_with("0X");
        let number = self.typed.number(id);
        let spelled = match (settled, number) {
            (Scalar::F32, Some(Number::Float { exact, .. })) if is_hex => spelling::number(exact, settled),
            (Scalar::F32, Some(Number::Float { .. })) => {
                // GLSL wants a point or an exponent, and has no `h`.
                let bare = word.trim_end_matches(['f', 'h']);
                let is_rounded_down = bare.parse::<f64>().is_ok_and(|value| value > f64::from(f32::MAX));
                Some(if is_rounded_down {
                    spelling::float(f32::MAX) // others take what is above it for infinite
                } else if bare.contains(['.', 'e', 'E']) {
                    bare.to_owned()
                } else {
                    format!("{bare}.0")
                })
            }
            (Scalar::F32, Some(Number::Int(value))) if is_hex => spelling::number(value as f64, settled),
            (Scalar::F32, Some(Number::Int(_))) => Some(format!("{}.0", word.trim_end_matches('f'))),
            (Scalar::U32, Some(Number::Int(value))) if u32::try_from(value).is_ok() => {
                Some(format!("{}u", word.trim_end_matches('u')))
            }
            (Scalar::I32, Some(Number::Int(value))) if i32::try_from(value).is_ok() => {
                Some(word.trim_end_matches('i').to_owned())
            }
            // An integer that floats were made of: `i32(1.5)` is written `int(1.5)`.
            (Scalar::I32 | Scalar::U32, Some(Number::Float { .. })) => Some(word.to_owned()),
            _ => None,
        };
        match spelled {
            Some(text) => Ok(text),
            None => self.refuse(format!("the number `{word}`"), self.typed.tree.span(id)),
        }
    }

    fn name(&mut self, id: ExprId, wanted: Wanted) -> Written {
        let ty = self.typed.ty(id);
        let text = match self.typed.meaning(id) {
            Meaning::Local(number) => match self.places.get(&number) {
                Some(place) => place.clone(),
                None => self.local_name(number),
            },
            Meaning::Global(index) => {
                if let DeclKind::Var { .. } = self.typed.tree.declarations[index as usize].kind
                    && let Some(instead) = self.instead.get(&index)
                {
                    instead.clone()
                } else {
                    self.global_name(index)
                }
            }
            _ => return self.refuse("this name", self.typed.tree.span(id)),
        };
        // An abstract constant is declared as what it becomes by itself.
        let settled = self.settled(ty, wanted);
        match self.types.scalar(ty) {
            Some(scalar) if scalar.is_abstract() && scalar.concrete() != settled => {
                if matches!(ty, Ty::Array(_)) {
                    return self
                        .refuse("an array of abstract numbers read as two types", self.typed.tree.span(id));
                }
                let value = self.typed.integer(id);
                let fits = value.is_none_or(|value| i32::try_from(value).is_ok());
                if let Some(text) = value.and_then(|value| spelling::number(value as f64, settled))
                    && (settled == Scalar::U32 || !fits)
                {
                    self.put(&text); // it may not fit where it is declared
                    return Ok(());
                }
                let name = spelling::numeric(ty.with(settled));
                self.put(&format!("{name}({text})"));
            }
            _ => self.put(&text),
        }
        Ok(())
    }

    fn member(&mut self, id: ExprId, base: ExprId, name: Tok, wanted: Wanted) -> Written {
        self.as_place = true;
        self.expr(base, wanted)?;
        self.upto(name);
        let word = self.typed.tree.word(name);
        let spelled = match self.types.pointee(self.typed.ty(base)) {
            Ty::Struct(_) => self.names.get(word).to_owned(),
            Ty::Modf(_) if word == "fract" => "part".to_owned(),
            Ty::Frexp(_) if word == "fract" => "part".to_owned(),
            Ty::Frexp(_) => "exponent".to_owned(),
            _ => word.to_owned(),
        };
        self.put(&spelled);
        self.cursor = self.typed.tree.expr(id).last + 1;
        Ok(())
    }

    fn unary(&mut self, id: ExprId, operand: ExprId, wanted: Wanted) -> Written {
        let first = self.typed.tree.expr(id).first;
        let start = self.typed.tree.expr(operand).first;
        match self.typed.tree.word(first) {
            "&" | "*" => {
                self.skip_to(start);
                self.as_place = true;
                self.expr(operand, wanted)
            }
            "!" if self.typed.ty(id).is_vector() => {
                self.put("not(");
                self.skip_to(start);
                self.expr(operand, wanted)?;
                self.put(")");
                Ok(())
            }
            _ => {
                self.upto(start);
                self.expr(operand, wanted)
            }
        }
    }

    fn binary(&mut self, id: ExprId, left: ExprId, operator: Tok, right: ExprId, wanted: Wanted) -> Written {
        let (a, b) = (self.typed.ty(left), self.typed.ty(right));
        let word = self.typed.tree.word(operator);
        if matches!(word, "<<" | ">>") {
            let wanted = Some(self.settled(self.typed.ty(id), wanted));
            self.before(&[right], |writer| writer.expr(left, wanted))?;
            self.upto(operator);
            self.through(operator);
            return self.shift_amount(right);
        }
        let scalar = self.common(
            a,
            b,
            if matches!(word, "+" | "-" | "*" | "/" | "%" | "&" | "|" | "^") { wanted } else { None },
        );
        // GLSL leaves open what is left over of negative numbers, also of constant ones.
        let is_known = scalar != Scalar::I32
            || word != "%"
            || [left, right].iter().all(|id| self.typed.integer(*id).is_some_and(|value| value >= 0));
        let is_constant = self.typed.is_constant(id) && is_known;
        let form = self.form(word, a, b, scalar, right, is_constant, self.typed.has_effect(right));
        match form {
            Form::Operator => {
                let short_circuits = matches!(word, "&&" | "||");
                let later = if short_circuits { &[][..] } else { &[right][..] };
                self.before(later, |writer| writer.expr(left, Some(scalar)))?;
                self.upto(operator);
                self.through(operator);
                self.expr(right, Some(scalar))
            }
            Form::Logical(text) => {
                self.put("(");
                self.expr(left, None)?;
                self.upto(operator);
                self.put(text);
                self.cursor = operator + 1;
                self.expr(right, None)?;
                self.put(")");
                Ok(())
            }
            Form::Function(name) => {
                self.put(&name);
                self.put("(");
                self.pair(left, operator, right, scalar)?;
                self.put(")");
                Ok(())
            }
            Form::Remainder => {
                // A constant expression may call no function of ours. Both sides are constant: writing them twice is safe.
                let size = a.size().max(b.size());
                let both = self.apart(|writer| writer.sized(left, size, scalar))?;
                let by = self.apart(|writer| writer.sized(right, size, scalar))?;
                self.put(&format!("(({both}) - ({by}) * trunc(({both}) / ({by})))"));
                Ok(())
            }
        }
    }

    /// `left, right`, both of the same size.
    fn pair(&mut self, left: ExprId, operator: Tok, right: ExprId, scalar: Scalar) -> Written {
        let size = self.typed.ty(left).size().max(self.typed.ty(right).size());
        self.before(&[right], |writer| writer.sized(left, size, scalar))?;
        self.skip_to(operator);
        self.put(",");
        self.cursor = operator + 1;
        self.upto(self.typed.tree.expr(right).first);
        self.sized(right, size, scalar)
    }

    /// As a vector of `size`, if it is to be one.
    pub(super) fn sized(&mut self, id: ExprId, size: u8, scalar: Scalar) -> Written {
        let widens = self.typed.ty(id).size() < size;
        self.cursor = self.typed.tree.expr(id).first;
        if widens {
            self.put(&spelling::numeric(Ty::Vector(size, scalar)));
            self.put("(");
        }
        self.expr(id, Some(scalar))?;
        if widens {
            self.put(")");
        }
        Ok(())
    }

    /// The scalar of two operands.
    fn common(&self, a: Ty, b: Ty, wanted: Wanted) -> Scalar {
        match (a.scalar(), b.scalar()) {
            (Some(a), Some(b)) => match a.unify(b) {
                scalar if scalar.is_abstract() => {
                    wanted.filter(|wanted| *wanted != Scalar::Bool).unwrap_or(scalar.concrete())
                }
                scalar => scalar,
            },
            _ => Scalar::F32,
        }
    }

    /// How the operator `word` is written.
    #[allow(clippy::too_many_arguments, reason = "each says something of its own about the operands")]
    pub(super) fn form(
        &mut self,
        word: &str,
        a: Ty,
        b: Ty,
        scalar: Scalar,
        right: ExprId,
        is_constant: bool,
        right_has_effect: bool,
    ) -> Form {
        let size = a.size().max(b.size());
        let is_vector = size > 1;
        match word {
            "/" | "%" if scalar.is_integer() => {
                if is_constant || self.divides_safely(word, right, scalar) {
                    return Form::Operator;
                }
                let name = if word == "/" { "div" } else { "rem" };
                Form::Function(self.helpers.ask(name, Ty::of(size, scalar)))
            }
            "%" if is_constant => Form::Remainder,
            "%" => Form::Function(self.helpers.ask("rem", Ty::of(size, scalar))),
            "&" | "|" if scalar == Scalar::Bool => {
                if is_vector || right_has_effect {
                    let name = if word == "&" { "and" } else { "or" };
                    return Form::Function(self.helpers.ask(name, Ty::of(size, scalar)));
                }
                Form::Logical(if word == "&" { "&&" } else { "||" })
            }
            "==" if is_vector => Form::Function("equal".to_owned()),
            "!=" if is_vector => Form::Function("notEqual".to_owned()),
            "<" if is_vector => Form::Function("lessThan".to_owned()),
            "<=" if is_vector => Form::Function("lessThanEqual".to_owned()),
            ">" if is_vector => Form::Function("greaterThan".to_owned()),
            ">=" if is_vector => Form::Function("greaterThanEqual".to_owned()),
            _ => Form::Operator,
        }
    }

    /// Whether GLSL defines the result: it leaves open what 0 and -1 divide to, and what is left over of negative numbers.
    fn divides_safely(&self, word: &str, right: ExprId, scalar: Scalar) -> bool {
        match self.typed.integer(right) {
            Some(divisor) if scalar == Scalar::U32 => divisor != 0,
            Some(divisor) => word == "/" && divisor != 0 && divisor != -1,
            None => false,
        }
    }

    /// What is to the right of a shift: WGSL takes the last five bits of it.
    pub(super) fn shift_amount(&mut self, right: ExprId) -> Written {
        if self.typed.integer(right).is_some_and(|amount| (0..32).contains(&amount)) {
            return self.expr(right, Some(Scalar::I32));
        }
        self.upto(self.typed.tree.expr(right).first);
        self.put("(");
        self.expr(right, Some(Scalar::U32))?;
        self.put(" & 31u)");
        Ok(())
    }

    /// The place that `id` names, for writing it more than once or later: what changes on the way is put into variables
    /// first, whose declarations come back beside it.
    pub(super) fn place(&mut self, id: ExprId, base_name: &str) -> Written<(String, String)> {
        match self.typed.tree.expr(id).kind {
            ExprKind::Paren { inner } => self.place(inner, base_name),
            ExprKind::Unary { operand } => self.place(operand, base_name), // `&` and `*`
            ExprKind::Member { base, name } => {
                let (before, mut text) = self.place(base, base_name)?;
                let word = self.typed.tree.word(name);
                let is_struct = matches!(self.types.pointee(self.typed.ty(base)), Ty::Struct(_));
                text.push('.');
                text.push_str(if is_struct { self.names.get(word) } else { word });
                Ok((before, text))
            }
            ExprKind::Index { base, index } => {
                let (mut before, mut text) = self.place(base, base_name)?;
                let written = self.apart(|writer| {
                    writer.cursor = writer.typed.tree.expr(index).first;
                    writer.expr(index, Some(Scalar::I32))
                })?;
                let stays = self.typed.is_constant(index) && self.typed.integer(index).is_some();
                let written = if stays {
                    written
                } else {
                    let name = self.names.fresh_like(&format!("{base_name}_at"));
                    let scalar = self.settled(self.typed.ty(index), Some(Scalar::I32));
                    before
                        .push_str(&format!("{} {name} = {written}; ", spelling::numeric(Ty::Scalar(scalar))));
                    name
                };
                text.push_str(&format!("[{written}]"));
                if matches!(self.typed.ty(id), Ty::Array(_)) {
                    text.push_str(".row");
                }
                Ok((before, text))
            }
            _ => {
                let text = self.apart(|writer| {
                    writer.cursor = writer.typed.tree.expr(id).first;
                    writer.expr(id, None)
                })?;
                Ok((String::new(), text))
            }
        }
    }

    /// Whether a `const` of `binding` can be one in GLSL: what it is set to calls no function of ours.
    pub(super) fn is_const(&self, binding: Binding, value: ExprId, asked_before: usize) -> bool {
        binding == Binding::Const && self.typed.is_constant(value) && self.helpers.asked() == asked_before
    }
}

/// How an operator is written.
pub(super) enum Form {
    /// As it is.
    Operator,
    /// As another one, in parentheses.
    Logical(&'static str),
    /// As a function.
    Function(String),
    /// The remainder of constant floats.
    Remainder,
}

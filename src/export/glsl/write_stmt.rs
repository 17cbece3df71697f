//! Statements and blocks.

use super::write::{Loop, Writer, Written};
use super::write_expr::Form;
use crate::export::typed::{
    Arm, Block, Clause, Continuing, ExprId, ExprKind, LocalDecl, Scalar, Statement, StatementKind, Tok, Ty,
};

impl<'w> Writer<'w, '_> {
    pub(super) fn block(&mut self, block: &'w Block) -> Written {
        self.through(block.open);
        self.statements(&block.statements)?;
        self.through(block.close);
        Ok(())
    }

    fn statements(&mut self, statements: &'w [Statement]) -> Written {
        statements.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &'w Statement) -> Written {
        self.bounded(self.typed.tree.span_of(statement.first, statement.first))?;
        self.upto(statement.first);
        match &statement.kind {
            StatementKind::Block(block) => return self.block(block),
            StatementKind::If { arms, otherwise } => return self.if_chain(arms, otherwise.as_ref()),
            StatementKind::Switch { selector, open, clauses } => {
                self.switch(*selector, *open, clauses)?;
                self.through(statement.last);
                return Ok(());
            }
            StatementKind::Loop { body, continuing } => {
                return self.loop_(statement, body, continuing.as_ref());
            }
            StatementKind::While { condition, body } => {
                self.through(statement.first);
                self.condition(*condition)?;
                return self.body_of_loop(body, None);
            }
            StatementKind::For { open, init, condition, step, close, body } => {
                self.through(*open);
                if let Some(init) = init {
                    self.simple(init)?;
                }
                if let Some(condition) = condition {
                    self.expr(*condition, None)?;
                }
                if let Some(step) = step {
                    self.simple(step)?;
                }
                self.through(*close);
                return self.body_of_loop(body, None);
            }
            StatementKind::Assert => {
                self.skip_to(statement.last + 1);
                return Ok(());
            }
            StatementKind::Continue => self.continue_(statement)?,
            _ => self.simple(statement)?,
        }
        self.through(statement.last);
        Ok(())
    }

    /// One without its semicolon.
    fn simple(&mut self, statement: &'w Statement) -> Written {
        match &statement.kind {
            StatementKind::Local(local) => self.local(statement.first, local),
            StatementKind::Assign { left, operator, right } => {
                self.assign(statement, *left, *operator, *right)
            }
            StatementKind::Phony { right } => {
                self.skip_to(self.typed.tree.expr(*right).first);
                self.expr(*right, None)
            }
            StatementKind::Step { left } => {
                self.expr(*left, None)?;
                Ok(()) // the operator is copied
            }
            StatementKind::Call(call) => self.expr(*call, None),
            StatementKind::Return(Some(value)) => {
                self.through(statement.first);
                self.expr(*value, self.types.scalar(self.result))
            }
            _ => {
                self.through(statement.first);
                Ok(())
            }
        }
    }

    fn local(&mut self, first: Tok, local: &'w LocalDecl) -> Written {
        let facts = self.typed.locals[local.number as usize];
        if let (Ty::Pointer(_), Some(value)) = (facts.ty, local.value) {
            // GLSL has no pointers: whoever reads this one is given what it points to.
            let word = self.names.get(self.typed.tree.word(local.name)).to_owned();
            let (before, place) = self.place(value, &word)?;
            if let Some(root) = self.root(value) {
                self.roots.insert(local.number, root);
            }
            self.put(&format!("{before}/* {word} is {place} */"));
            self.places.insert(local.number, place);
            self.cursor = self.typed.tree.expr(value).last + 1;
            return Ok(());
        }
        let span = self.typed.tree.span_of(first, local.name);
        let ty = self.types.concrete(facts.ty);
        let written = self.type_of(ty, span)?;
        let before = self.helpers.asked();
        let start = self.out.len();
        self.put(&written);
        self.put(" ");
        self.skip_to(local.name);
        let name = self.local_name(local.number);
        self.put(&name);
        self.cursor = local.name + 1;
        if let Some(ty) = local.ty {
            self.skip_to(self.typed.tree.expr(ty).last + 1);
        }
        let Some(value) = local.value else {
            let zero = self.zero(ty, span)?;
            self.put(&format!(" = {zero}"));
            return Ok(());
        };
        self.upto(self.typed.tree.expr(value).first);
        self.expr(value, self.types.scalar(ty))?;
        if self.is_const(local.binding, value, before) {
            self.out.insert_str(start, "const ");
        }
        Ok(())
    }

    fn assign(&mut self, statement: &'w Statement, left: ExprId, operator: Tok, right: ExprId) -> Written {
        let word = self.typed.tree.word(operator);
        let ty = self.types.pointee(self.typed.ty(left));
        let scalar = self.types.scalar(ty).unwrap_or(Scalar::F32);
        let operation = word.strip_suffix('=').unwrap_or_default();
        // The left side is read before the right one is worked out.
        let reads_first =
            !operation.is_empty() && self.root(left).is_some_and(|root| self.changes(right, root));
        if matches!(operation, "<<" | ">>") && !reads_first {
            self.before(&[right], |writer| writer.written_to(left))?;
            self.upto(operator);
            self.through(operator);
            return self.shift_amount(right);
        }
        let form = match operation {
            "" => Form::Operator,
            _ => {
                let has_effect = self.typed.has_effect(right);
                self.form(operation, ty, self.typed.ty(right), scalar, right, false, has_effect)
            }
        };
        if let Form::Operator = form
            && !reads_first
        {
            self.before(&[right], |writer| writer.written_to(left))?;
            self.upto(operator);
            self.through(operator);
            return self.expr(right, Some(scalar));
        }
        // The place is read as well as written.
        let (before, place) = if self.typed.has_effect(left) || reads_first {
            self.place(left, "place")?
        } else {
            let place = self.apart(|writer| {
                writer.cursor = writer.typed.tree.expr(left).first;
                writer.written_to(left)
            })?;
            (String::new(), place)
        };
        let read =
            if reads_first { self.now_of(&place, ty, self.typed.tree.span(left))? } else { place.clone() };
        if !before.is_empty() {
            self.put(&format!("{{ {before}"));
        }
        match form {
            Form::Function(name) => {
                self.put(&format!("{place} = {name}({read}, "));
                self.cursor = operator + 1;
                self.sized(right, ty.size(), scalar)?;
                self.put(")");
            }
            Form::Logical(text) => {
                self.put(&format!("{place} = {read} {text} ("));
                self.cursor = self.typed.tree.expr(right).first;
                self.expr(right, None)?;
                self.put(")");
            }
            Form::Operator => {
                self.put(&format!("{place} = {read} {operation} ("));
                self.cursor = self.typed.tree.expr(right).first;
                if matches!(operation, "<<" | ">>") {
                    self.shift_amount(right)?;
                } else {
                    self.expr(right, Some(scalar))?;
                }
                self.put(")");
            }
            Form::Remainder => {}
        }
        if !before.is_empty() {
            self.put("; }");
        }
        self.cursor = self.cursor.max(statement.first);
        Ok(())
    }

    /// `condition` in parentheses.
    fn condition(&mut self, condition: ExprId) -> Written {
        self.upto(self.typed.tree.expr(condition).first);
        if let ExprKind::Paren { .. } = self.typed.tree.expr(condition).kind {
            return self.expr(condition, None);
        }
        self.put("(");
        self.expr(condition, None)?;
        self.put(")");
        Ok(())
    }

    fn if_chain(&mut self, arms: &'w [Arm], otherwise: Option<&'w Block>) -> Written {
        for arm in arms {
            self.condition(arm.condition)?; // `else if` before it is copied
            self.block(&arm.body)?;
        }
        otherwise.map_or(Ok(()), |block| self.block(block))
    }

    fn switch(&mut self, selector: ExprId, open: Tok, clauses: &'w [Clause]) -> Written {
        self.through(self.typed.tree.expr(selector).first.saturating_sub(1));
        self.condition(selector)?;
        self.through(open);
        let scalar = clauses
            .iter()
            .flat_map(|clause| clause.selectors.iter().flatten())
            .chain([&selector])
            .filter_map(|id| self.typed.ty(*id).scalar())
            .reduce(Scalar::unify)
            .map(Scalar::concrete);
        if let Some(inner) = self.loops.last_mut() {
            inner.switches += 1;
        }
        for clause in clauses {
            self.upto(clause.first);
            for (at, selector) in clause.selectors.iter().enumerate() {
                self.put(if at > 0 { " " } else { "" });
                match selector {
                    Some(selector) => {
                        self.put("case ");
                        self.skip_to(self.typed.tree.expr(*selector).first);
                        self.expr(*selector, scalar)?;
                    }
                    None => self.put("default"),
                }
                self.put(":");
            }
            self.put(" ");
            self.skip_to(clause.body.open);
            self.through(clause.body.open);
            self.statements(&clause.body.statements)?;
            self.end_clause(&clause.body);
            self.through(clause.body.close);
        }
        if let Some(inner) = self.loops.last_mut() {
            inner.switches -= 1;
        }
        Ok(())
    }

    /// GLSL falls through where WGSL does not.
    fn end_clause(&mut self, body: &Block) {
        let ends = body.statements.last().is_some_and(|last| {
            matches!(
                last.kind,
                StatementKind::Return(_)
                    | StatementKind::Break
                    | StatementKind::Continue
                    | StatementKind::Discard
            )
        });
        if ends {
            return;
        }
        // On a line of its own where the block has several.
        let is_open = body.statements.last().is_none_or(|last| self.on_one_line(last.last, body.close));
        if is_open {
            self.upto(body.close);
            if !self.out.ends_with([' ', '\n', '{']) {
                self.put(" ");
            }
            self.put("break; ");
        } else {
            let indent = self.indent_of(body.statements[body.statements.len() - 1].first);
            self.put(&format!("\n{indent}break;"));
        }
    }

    /// Whether no line ends between two tokens.
    fn on_one_line(&self, from: Tok, to: Tok) -> bool {
        (from..to).all(|tok| !self.typed.tree.word(tok).contains(crate::syntax::is_line_break))
    }

    /// The blank space before `tok` on its line.
    fn indent_of(&self, tok: Tok) -> String {
        let start = self.typed.tree.tokens.span(tok as usize).start as usize;
        let line = self.typed.tree.text[..start].rsplit('\n').next().unwrap_or_default();
        line.chars().take_while(|c| matches!(c, ' ' | '\t')).collect()
    }

    fn body_of_loop(&mut self, body: &'w Block, continuing: Option<&'w Continuing>) -> Written {
        self.loops.push(Loop { continuing, switches: 0, again: None });
        let outcome = self.block(body);
        self.loops.pop();
        outcome
    }

    fn loop_(
        &mut self,
        statement: &'w Statement,
        body: &'w Block,
        continuing: Option<&'w Continuing>,
    ) -> Written {
        let continues_in_switch = body.statements.iter().any(|one| continues(one, false));
        let breaks = continuing.is_some_and(|continuing| continuing.break_if.is_some());
        let mut again = None;
        if continues_in_switch && breaks {
            let name = self.names.fresh_like("again");
            self.put(&format!("for (bool {name} = true; {name};) "));
            self.again.push(name);
            again = Some(self.again.len() as u32 - 1);
        } else {
            self.put("for (;;) ");
        }
        self.skip_to(body.open);
        self.through(body.open);
        self.loops.push(Loop { continuing, switches: 0, again });
        let outcome = self.statements(&body.statements);
        self.loops.pop();
        outcome?;
        if let Some(continuing) = continuing {
            self.upto(continuing.first);
            self.cursor = continuing.body.open;
            self.through(continuing.body.open);
            self.statements(&continuing.body.statements)?;
            self.break_if(continuing, None)?;
            self.cursor =
                self.cursor.max(continuing.break_if.map_or(0, |id| self.typed.tree.expr(id).last + 1));
            self.skip_semicolon(continuing);
            self.through(continuing.body.close);
        }
        self.through(statement.last);
        Ok(())
    }

    /// Behind the `;` of `break if …;`.
    fn skip_semicolon(&mut self, continuing: &Continuing) {
        if continuing.break_if.is_some() {
            while self.cursor < continuing.body.close && self.typed.tree.word(self.cursor) != ";" {
                self.cursor += 1;
            }
            self.cursor += 1;
        }
    }

    /// `if (condition) { break; }`, or what tells the loop's head to end it.
    fn break_if(&mut self, continuing: &'w Continuing, again: Option<&str>) -> Written {
        let Some(condition) = continuing.break_if else { return Ok(()) };
        // Blank space and comments before `break`.
        let mut at = self.typed.tree.expr(condition).first - 1;
        while self.typed.tree.word(at) != "break" {
            at -= 1;
        }
        self.upto(at);
        self.put("if (");
        self.cursor = self.typed.tree.expr(condition).first;
        self.expr(condition, None)?;
        match again {
            Some(again) => self.put(&format!(") {{ {again} = false; }}")),
            None => self.put(") { break; }"),
        }
        Ok(())
    }

    /// What stands in `continuing` comes before the jump.
    fn continue_(&mut self, statement: &'w Statement) -> Written {
        let Some(Loop { continuing: Some(continuing), switches, again }) = self.loops.last().copied() else {
            self.through(statement.first);
            return Ok(());
        };
        let again = again.filter(|_| switches > 0).map(|index| self.again[index as usize].clone());
        self.put("{ ");
        let written = self.apart(|writer| {
            writer.cursor = continuing.body.open + 1;
            let outer = std::mem::take(&mut writer.loops);
            let outcome = writer.statements(&continuing.body.statements);
            let outcome = outcome.and_then(|()| writer.break_if(continuing, again.as_deref()));
            writer.loops = outer;
            outcome
        })?;
        self.put(written.trim());
        self.put(" continue; }");
        self.cursor = statement.last + 1;
        Ok(())
    }

    /// Gives names of their own to local variables that GLSL would take for one another, in the function `index`.
    pub(super) fn keep_apart(&mut self, index: u32, body: &'w Block) {
        let mut clashing = Vec::new();
        let everything = body.statements.iter().any(|statement| repeats(self.typed, statement));
        if everything {
            let mut seen: Vec<&str> = Vec::new();
            for (number, local) in self
                .typed
                .locals
                .iter()
                .enumerate()
                .filter(|(_, local)| local.function == index && local.name > 0)
            {
                let word = self.typed.tree.word(local.name);
                if seen.contains(&word) {
                    clashing.push(number as u32);
                } else {
                    seen.push(word);
                }
            }
        }
        for statement in &body.statements {
            self.heads(statement, &mut clashing);
        }
        for number in clashing {
            let word = self.typed.tree.word(self.typed.locals[number as usize].name);
            let base = self.names.get(word).to_owned();
            let name = self.names.fresh(&base);
            self.own_names.insert(number, name);
        }
    }

    /// Variables in the body of a `for` that are called like the one in its head: GLSL has one scope for both. And those
    /// that are set to what they hide, about which compilers differ.
    fn heads(&self, statement: &'w Statement, clashing: &mut Vec<u32>) {
        let each = |block: &'w Block, clashing: &mut Vec<u32>| {
            block.statements.iter().for_each(|statement| self.heads(statement, clashing));
        };
        match &statement.kind {
            StatementKind::Local(local) => {
                let word = self.typed.tree.word(local.name);
                if local.value.is_some_and(|value| self.mentions(value, word)) {
                    clashing.push(local.number);
                }
            }
            StatementKind::For { init, body, .. } => {
                if let Some(StatementKind::Local(head)) = init.as_deref().map(|init| &init.kind) {
                    let word = self.typed.tree.word(head.name);
                    for inner in &body.statements {
                        if let StatementKind::Local(local) = &inner.kind
                            && self.typed.tree.word(local.name) == word
                        {
                            clashing.push(local.number);
                        }
                    }
                }
                each(body, clashing);
            }
            StatementKind::Block(body) | StatementKind::While { body, .. } => each(body, clashing),
            StatementKind::If { arms, otherwise } => {
                arms.iter().for_each(|arm| each(&arm.body, clashing));
                otherwise.iter().for_each(|block| each(block, clashing));
            }
            StatementKind::Switch { clauses, .. } => {
                clauses.iter().for_each(|clause| each(&clause.body, clashing))
            }
            StatementKind::Loop { body, continuing } => {
                each(body, clashing);
                continuing.iter().for_each(|continuing| each(&continuing.body, clashing));
            }
            _ => {}
        }
    }

    /// Whether `id` names `word`.
    fn mentions(&self, id: ExprId, word: &str) -> bool {
        let expr = self.typed.tree.expr(id);
        (expr.first..=expr.last).any(|tok| {
            self.typed.tree.word(tok) == word && (tok == 0 || self.typed.tree.word(tok - 1) != ".")
        })
    }
}

/// Whether a function has something that is written in another place than where it stands, where a name may be hidden: what
/// pointers point to, and `continuing`.
fn repeats(typed: &crate::export::typed::Typed<'_>, statement: &Statement) -> bool {
    let any = |block: &Block| block.statements.iter().any(|statement| repeats(typed, statement));
    match &statement.kind {
        StatementKind::Local(local) => matches!(typed.locals[local.number as usize].ty, Ty::Pointer(_)),
        StatementKind::Block(block)
        | StatementKind::While { body: block, .. }
        | StatementKind::For { body: block, .. } => any(block),
        StatementKind::If { arms, otherwise } => {
            arms.iter().any(|arm| any(&arm.body)) || otherwise.as_ref().is_some_and(any)
        }
        StatementKind::Switch { clauses, .. } => clauses.iter().any(|clause| any(&clause.body)),
        StatementKind::Loop { body, continuing } => any(body) || continuing.is_some(),
        _ => false,
    }
}

/// Whether a loop's body has a `continue` of that loop inside of a `switch`.
fn continues(statement: &Statement, in_switch: bool) -> bool {
    let any =
        |block: &Block, in_switch| block.statements.iter().any(|statement| continues(statement, in_switch));
    match &statement.kind {
        StatementKind::Continue => in_switch,
        StatementKind::Block(block) => any(block, in_switch),
        StatementKind::If { arms, otherwise } => {
            arms.iter().any(|arm| any(&arm.body, in_switch))
                || otherwise.as_ref().is_some_and(|block| any(block, in_switch))
        }
        StatementKind::Switch { clauses, .. } => clauses.iter().any(|clause| any(&clause.body, true)),
        _ => false,
    }
}

//! What is written, and in which order: what an entry point reaches, each type and value before it is used.

use super::super::typed::{DeclKind, Typed};

/// One step of writing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    /// The declaration. In its turn, with all that stands above it; before it, with its own comments alone.
    Write { index: u32, in_turn: bool },
    /// A function's head, since it is called before it is written.
    Announce(u32),
    /// Of what is not written, or was written before its turn: what stands above it on its own, headings of modules.
    Rest(u32),
}

/// What the declaration `entry` reaches, itself included, by number.
pub(super) fn reached(typed: &Typed<'_>, entry: u32) -> Vec<bool> {
    let mut reached = vec![false; typed.tree.declarations.len()];
    let mut open = vec![entry];
    while let Some(index) = open.pop() {
        if !std::mem::replace(&mut reached[index as usize], true) {
            open.extend(&typed.references[index as usize]);
        }
    }
    reached
}

/// The steps that write all that is `wanted`, in the text's order as far as GLSL allows: it wants definitions before use.
pub(super) fn order(typed: &Typed<'_>, wanted: &[bool]) -> Vec<Step> {
    let mut order =
        Order { typed, wanted, done: vec![State::Open; wanted.len()], turn: 0, steps: Vec::new() };
    for index in 0..wanted.len() as u32 {
        order.turn = index;
        let is_done = order.done[index as usize] == State::Written;
        if wanted[index as usize] && !is_done {
            order.write(index);
        } else {
            order.steps.push(Step::Rest(index));
        }
    }
    order.steps
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Open,
    Announced,
    Written,
}

struct Order<'t, 'a> {
    typed: &'t Typed<'a>,
    wanted: &'t [bool],
    done: Vec<State>,
    /// Whose turn it is.
    turn: u32,
    steps: Vec<Step>,
}

impl Order<'_, '_> {
    fn is_function(&self, index: u32) -> bool {
        matches!(self.typed.tree.declarations[index as usize].kind, DeclKind::Function(_))
    }

    /// What `index` needs is written before it, as deep as that goes; functions are only announced.
    fn write(&mut self, index: u32) {
        let mut open = vec![(index, 0)];
        while let Some((index, next)) = open.pop() {
            if self.done[index as usize] == State::Written {
                continue;
            }
            let needed = self.typed.references[index as usize].get(next).copied();
            let Some(needed) = needed else {
                self.finish(index);
                continue;
            };
            open.push((index, next + 1));
            if !self.wanted[needed as usize] || self.done[needed as usize] != State::Open || needed == index {
                continue;
            }
            if self.is_function(needed) {
                self.announce(needed);
            } else {
                open.push((needed, 0));
            }
        }
    }

    fn announce(&mut self, index: u32) {
        // The types in its head come before it; they are no functions, so this goes one level deep.
        let DeclKind::Function(function) = &self.typed.tree.declarations[index as usize].kind else { return };
        let named = function.parameters.iter().map(|field| field.ty).chain(function.result);
        let types: Vec<u32> = named.filter_map(|ty| self.typed.declared_in(ty)).collect();
        for ty in types {
            if self.wanted[ty as usize] && self.done[ty as usize] == State::Open {
                self.write(ty);
            }
        }
        self.done[index as usize] = State::Announced;
        self.steps.push(Step::Announce(index));
    }

    fn finish(&mut self, index: u32) {
        self.done[index as usize] = State::Written;
        self.steps.push(Step::Write { index, in_turn: index == self.turn });
    }
}

impl Typed<'_> {
    /// The struct or alias that the type name `id` names, or that its elements are.
    fn declared_in(&self, id: super::super::typed::ExprId) -> Option<u32> {
        use super::super::typed::{ExprKind, Meaning};
        match (self.meaning(id), &self.tree.expr(id).kind) {
            (Meaning::Global(index), _) => Some(index),
            (_, ExprKind::Name { arguments }) => {
                arguments.iter().find_map(|argument| self.declared_in(*argument))
            }
            _ => None,
        }
    }
}

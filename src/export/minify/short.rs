//! Short names: [`Scopes`] → a new name for each declaration and each member that may have one.
//!
//! The more often a name is written, the earlier it chooses, and it takes the shortest that is free where it is visible: a
//! local variable must differ from what is visible beside it and from every global that its function names, and from
//! nothing else. Types are an exception: no local is called like one, since in GLSL `let s = f();` names the type of `s`.

use std::ops::Range;
use std::sync::LazyLock;

use rustc_hash::FxHashSet;

use super::scopes::{Member, Scopes};

/// What GLSL's writers would have to rename.
static GLSL: LazyLock<FxHashSet<&str>> =
    LazyLock::new(|| include_str!("../glsl_words.txt").split_whitespace().collect());
static WGSL: LazyLock<FxHashSet<&str>> =
    LazyLock::new(|| naga::keywords::wgsl::RESERVED.iter().copied().collect());

/// New names by number; none where the old one stays.
pub(super) struct Short {
    pub(super) globals: Vec<Option<String>>,
    pub(super) locals: Vec<Option<String>>,
    pub(super) members: Vec<Option<String>>,
}

/// Gives every name that the host does not know a short one. The host knows those that `is_kept` says, too.
pub(super) fn names(scopes: &Scopes<'_>, is_kept: &dyn Fn(&str) -> bool) -> Short {
    let (globals, locals) = variables(scopes, is_kept);
    Short { globals, locals, members: members(scopes, is_kept) }
}

/// Names in the order of their length, without those that are taken.
struct Spellings<'a> {
    is_taken: &'a dyn Fn(&str) -> bool,
    next: usize,
    list: Vec<String>,
}

impl<'a> Spellings<'a> {
    fn new(is_taken: &'a dyn Fn(&str) -> bool) -> Self {
        Self { is_taken, next: 0, list: Vec::new() }
    }

    /// The name numbered `number`.
    fn get(&mut self, number: usize) -> String {
        while self.list.len() <= number {
            let name = spelled(self.next);
            self.next += 1;
            if !GLSL.contains(name.as_str()) && !WGSL.contains(name.as_str()) && !(self.is_taken)(&name) {
                self.list.push(name);
            }
        }
        self.list[number].clone()
    }
}

/// `a` … `z`, `A` … `Z`, `aa`, `ba`, … `a9`: all names of letters and digits, the short ones first.
fn spelled(number: usize) -> String {
    const LETTERS: &[u8] = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    const FIRST: usize = 52;
    let mut name = String::from(char::from(LETTERS[number % FIRST]));
    let mut rest = number / FIRST;
    while rest > 0 {
        rest -= 1;
        name.push(char::from(LETTERS[rest % LETTERS.len()]));
        rest /= LETTERS.len();
    }
    name
}

/// A set of small numbers.
#[derive(Default, Clone)]
struct Bits(Vec<u64>);

impl Bits {
    fn insert(&mut self, bit: usize) {
        if self.0.len() <= bit / 64 {
            self.0.resize(bit / 64 + 1, 0);
        }
        self.0[bit / 64] |= 1 << (bit % 64);
    }

    fn has(&self, bit: usize) -> bool {
        self.0.get(bit / 64).is_some_and(|word| word >> (bit % 64) & 1 == 1)
    }

    fn add(&mut self, other: &Self) {
        if self.0.len() < other.0.len() {
            self.0.resize(other.0.len(), 0);
        }
        self.0.iter_mut().zip(&other.0).for_each(|(all, more)| *all |= more);
    }

    fn first_missing(&self) -> usize {
        let word = self.0.iter().position(|word| *word != u64::MAX).unwrap_or(self.0.len());
        word * 64 + self.0.get(word).map_or(0, |bits| bits.trailing_ones() as usize)
    }
}

/// What has been chosen in a function.
#[derive(Default)]
struct Function {
    /// How many locals it has.
    locals: u32,
    /// By the globals that it names.
    of_globals: Bits,
    /// By its locals: for each number, where those are visible that have chosen it.
    ranges: Vec<Vec<Range<u32>>>,
    /// Before this number none is free anywhere.
    floor: usize,
}

/// In a function with more locals than this, no two share a name: nobody wrote that by hand, and it must not take long.
const MANY: u32 = 2000;

impl Function {
    /// Whether no local has chosen `number`.
    fn is_free(&self, number: usize) -> bool {
        self.ranges.get(number).is_none_or(Vec::is_empty)
    }

    /// The first number for a local that is visible in `range`.
    fn choose(&mut self, range: Range<u32>, of_types: &Bits) -> usize {
        let are_many = self.locals > MANY;
        let overlaps = |other: &Range<u32>| other.start < range.end && range.start < other.end;
        let is_taken = |number: usize| {
            let others = self.ranges.get(number).map_or(&[][..], Vec::as_slice);
            self.of_globals.has(number)
                || of_types.has(number)
                || others.iter().any(|other| are_many || overlaps(other))
        };
        let number = (self.floor..).find(|number| !is_taken(*number)).unwrap_or_default();
        if are_many {
            self.floor = number + 1;
        }
        if self.ranges.len() <= number {
            self.ranges.resize(number + 1, Vec::new());
        }
        self.ranges[number].push(range);
        number
    }
}

/// Who chooses.
#[derive(Clone, Copy)]
enum Chooser {
    Global(usize),
    Local(usize),
}

fn variables(
    scopes: &Scopes<'_>,
    is_kept: &dyn Fn(&str) -> bool,
) -> (Vec<Option<String>>, Vec<Option<String>>) {
    let stays = |name: &str, is_host: bool| !scopes.has_entry || is_host || is_kept(name);
    let kept: FxHashSet<&str> = scopes
        .globals
        .iter()
        .filter(|global| stays(global.name, global.is_host))
        .map(|global| global.name)
        .collect();
    let is_taken = |name: &str| kept.contains(name) || scopes.words.contains(name) || is_kept(name);
    let mut spellings = Spellings::new(&is_taken);

    let globals = scopes.globals.iter().enumerate().filter(|(_, global)| !kept.contains(global.name));
    let globals = globals.map(|(index, global)| (global.uses, Chooser::Global(index)));
    let locals = scopes.locals.iter().enumerate().map(|(index, local)| (local.uses, Chooser::Local(index)));
    let mut choosers: Vec<_> = globals.chain(locals).collect();
    choosers.sort_by_key(|(uses, _)| std::cmp::Reverse(*uses)); // stable: the same on every machine

    let mut new_globals = vec![None; scopes.globals.len()];
    let mut new_locals = vec![None; scopes.locals.len()];
    let (mut of_globals, mut of_types, mut of_locals) = (Bits::default(), Bits::default(), Bits::default());
    let mut functions: Vec<Function> = (0..scopes.functions).map(|_| Function::default()).collect();
    scopes.locals.iter().for_each(|local| functions[local.function as usize].locals += 1);
    for (_, chooser) in choosers {
        match chooser {
            Chooser::Global(index) => {
                let global = &scopes.globals[index];
                let is_free = |number: &usize| {
                    let mut all = global.functions.iter();
                    !of_globals.has(*number)
                        && (!global.is_type || !of_locals.has(*number))
                        && all.all(|one| functions[*one as usize].is_free(*number))
                };
                let number = (of_globals.first_missing()..).find(is_free).unwrap_or_default();
                of_globals.insert(number);
                if global.is_type {
                    of_types.insert(number);
                }
                global.functions.iter().for_each(|one| functions[*one as usize].of_globals.insert(number));
                new_globals[index] = Some(spellings.get(number));
            }
            Chooser::Local(index) => {
                let local = &scopes.locals[index];
                let number = functions[local.function as usize].choose(local.range.clone(), &of_types);
                of_locals.insert(number);
                new_locals[index] = Some(spellings.get(number));
            }
        }
    }
    (new_globals, new_locals)
}

/// Members that are named like components of a vector stay: behind a dot, only types can tell the two apart.
fn members(scopes: &Scopes<'_>, is_kept: &dyn Fn(&str) -> bool) -> Vec<Option<String>> {
    let stays = |member: &Member<'_>| {
        !scopes.has_entry
            || member.is_host
            || is_kept(member.name)
            || is_swizzle(member.name)
            || OF_RESULTS.contains(&member.name)
    };
    let kept: FxHashSet<&str> = scopes.members.iter().filter(|one| stays(one)).map(|one| one.name).collect();
    let is_taken = |name: &str| kept.contains(name) || is_swizzle(name) || OF_RESULTS.contains(&name);
    let mut spellings = Spellings::new(&is_taken);
    let mut order: Vec<usize> =
        (0..scopes.members.len()).filter(|index| !kept.contains(scopes.members[*index].name)).collect();
    order.sort_by_key(|index| std::cmp::Reverse(scopes.members[*index].uses));
    let mut new = vec![None; scopes.members.len()];
    let mut of_structs = vec![Bits::default(); scopes.globals.len()];
    for index in order {
        let structs = &scopes.members[index].structs;
        let mut taken = Bits::default();
        structs.iter().for_each(|number| taken.add(&of_structs[*number as usize]));
        let number = taken.first_missing();
        structs.iter().for_each(|one| of_structs[*one as usize].insert(number));
        new[index] = Some(spellings.get(number));
    }
    new
}

/// Members of what WGSL's own functions give back.
const OF_RESULTS: [&str; 5] = ["fract", "whole", "exp", "old_value", "exchanged"];

fn is_swizzle(name: &str) -> bool {
    let of = |letters: &str| name.chars().all(|c| letters.contains(c));
    name.len() <= 4 && (of("xyzw") || of("rgba"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_spelled_the_short_ones_first_and_each_once() {
        let all: Vec<_> = (0..52 + 52 * 62 + 100).map(spelled).collect();
        assert_eq!([&all[0], &all[51], &all[52], &all[53]], ["a", "Z", "aa", "ba"]);
        assert!(all.is_sorted_by_key(String::len));
        assert_eq!(all.iter().collect::<FxHashSet<_>>().len(), all.len());
        assert!(all.iter().all(|name| crate::syntax::is_ident(name)));
    }

    #[test]
    fn the_first_number_that_is_missing_is_found_past_full_words() {
        let mut bits = Bits::default();
        (0..130).for_each(|bit| bits.insert(bit));
        assert_eq!((Bits::default().first_missing(), bits.first_missing()), (0, 130));
    }
}

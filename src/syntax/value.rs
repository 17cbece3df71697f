//! Types and values of parameters and options, and the declarations that carry them.

use crate::source::Span;

/// What a parameter can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Type {
    /// `bool`
    Bool,
    /// `i32`
    I32,
    /// `u32`
    U32,
    /// `f32`
    F32,
    /// `vec2f`
    Vec2f,
    /// `vec3f`
    Vec3f,
    /// `vec4f`
    Vec4f,
}

impl Type {
    /// Every type, as WGSL spells it.
    pub const ALL: [Self; 7] =
        [Self::Bool, Self::I32, Self::U32, Self::F32, Self::Vec2f, Self::Vec3f, Self::Vec4f];

    /// As WGSL spells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bool => "bool",
            Self::I32 => "i32",
            Self::U32 => "u32",
            Self::F32 => "f32",
            Self::Vec2f => "vec2f",
            Self::Vec3f => "vec3f",
            Self::Vec4f => "vec4f",
        }
    }

    /// How many scalars it holds.
    pub fn components(self) -> usize {
        match self {
            Self::Vec2f => 2,
            Self::Vec3f => 3,
            Self::Vec4f => 4,
            _ => 1,
        }
    }

    /// The type of one of its scalars.
    pub fn scalar(self) -> Self {
        if self.components() > 1 { Self::F32 } else { self }
    }

    /// Whether it is made of floats.
    pub fn is_float(self) -> bool {
        self.scalar() == Self::F32
    }
}

impl std::fmt::Display for Type {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// A parameter's value. Floats are finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// `bool`
    Bool(bool),
    /// `i32`
    I32(i32),
    /// `u32`
    U32(u32),
    /// `f32`
    F32(f32),
    /// `vec2f`
    Vec2f([f32; 2]),
    /// `vec3f`
    Vec3f([f32; 3]),
    /// `vec4f`
    Vec4f([f32; 4]),
}

impl Value {
    /// Its type.
    pub fn ty(&self) -> Type {
        match self {
            Self::Bool(_) => Type::Bool,
            Self::I32(_) => Type::I32,
            Self::U32(_) => Type::U32,
            Self::F32(_) => Type::F32,
            Self::Vec2f(_) => Type::Vec2f,
            Self::Vec3f(_) => Type::Vec3f,
            Self::Vec4f(_) => Type::Vec4f,
        }
    }

    /// The floats that it is made of; none for the other types.
    pub fn floats(&self) -> &[f32] {
        match self {
            Self::F32(v) => std::slice::from_ref(v),
            Self::Vec2f(v) => v,
            Self::Vec3f(v) => v,
            Self::Vec4f(v) => v,
            _ => &[],
        }
    }

    /// The float value of type `ty` made of `floats`; none where their number does not fit.
    pub fn from_floats(ty: Type, floats: &[f32]) -> Option<Self> {
        match (ty, floats) {
            (Type::F32, [x]) => Some(Self::F32(*x)),
            (Type::Vec2f, list) => list.try_into().ok().map(Self::Vec2f),
            (Type::Vec3f, list) => list.try_into().ok().map(Self::Vec3f),
            (Type::Vec4f, list) => list.try_into().ok().map(Self::Vec4f),
            _ => None,
        }
    }

    /// Its numbers as f64, to hold against a range; none for `bool`.
    pub fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Bool(_) => Vec::new(),
            Self::I32(v) => vec![f64::from(*v)],
            Self::U32(v) => vec![f64::from(*v)],
            floats => floats.floats().iter().map(|v| f64::from(*v)).collect(),
        }
    }
}

/// `group.name`, or a name alone.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Key {
    /// Empty for an option that stands without a group.
    pub group: String,
    /// Its name in the group.
    pub name: String,
}

impl Key {
    /// The identifier that the host sees: `group_name`.
    pub fn flat(&self) -> String {
        if self.group.is_empty() { self.name.clone() } else { format!("{}_{}", self.group, self.name) }
    }
}

impl std::fmt::Display for Key {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.group.is_empty() {
            f.write_str(&self.name)
        } else {
            write!(f, "{}.{}", self.group, self.name)
        }
    }
}

/// `#param terrain.peak_height: f32 = 1800.0, range 0 .. 8000, unit m`
#[derive(Debug, Clone, PartialEq)]
pub struct ParamDecl {
    /// Its name.
    pub key: Key,
    /// Where the name stands.
    pub key_span: Span,
    /// Its type.
    pub ty: Type,
    /// Its value where no preset sets one, in the declared unit.
    pub default: Value,
    /// Least and greatest value, for every component, in the declared unit.
    pub range: Option<(f64, f64)>,
    /// `m`, `deg`, …
    pub unit: Option<String>,
    /// It is a linear sRGB colour.
    pub color: bool,
    /// A slider for it is best logarithmic.
    pub log: bool,
    /// It is worth keeping live.
    pub live: bool,
    /// The doc comment above it.
    pub doc: String,
}

impl ParamDecl {
    /// The first number of `value` outside of the range. The range's ends are rounded as the value was: `0.1` is inside of
    /// `0 .. 0.1`, though as an f32 it lies above it.
    pub fn outside(&self, value: &Value) -> Option<f64> {
        let (low, high) = self.range?;
        let rounded = |end: f64| if self.ty.is_float() { f64::from(end as f32) } else { end };
        value.numbers().into_iter().find(|number| *number < rounded(low) || *number > rounded(high))
    }
}

/// What an option can be set to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum OptionKind {
    /// `#option terrain.basis = perlin { value, perlin, simplex }`; in order.
    Choice(Vec<String>),
    /// `#option water.waves = true`
    Bool,
    /// `#option march.steps = 8, range 1 .. 16`
    Integer(Option<(i64, i64)>),
}

/// An option's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum OptionValue {
    /// The choice of that number.
    Choice(usize),
    /// On or off.
    Bool(bool),
    /// A number, inside i32.
    Integer(i64),
}

/// `#option terrain.basis = perlin { value, perlin, simplex }`
#[derive(Debug, Clone, PartialEq)]
pub struct OptionDecl {
    /// Its name.
    pub key: Key,
    /// Where the name stands.
    pub key_span: Span,
    /// What it can be.
    pub kind: OptionKind,
    /// Its value where no preset sets one.
    pub default: OptionValue,
    /// The doc comment above it.
    pub doc: String,
}

impl OptionDecl {
    /// What it can be set to: `{ value, perlin }`, `{ true, false }`, `1 .. 16`.
    pub fn possible(&self) -> String {
        match &self.kind {
            OptionKind::Choice(names) => format!("{{ {} }}", names.join(", ")),
            OptionKind::Bool => "{ true, false }".into(),
            OptionKind::Integer(Some((low, high))) => format!("{low} .. {high}"),
            OptionKind::Integer(None) => "a whole number".into(),
        }
    }

    /// `value` as a preset writes it.
    pub fn show(&self, value: OptionValue) -> String {
        match (&self.kind, value) {
            (OptionKind::Choice(names), OptionValue::Choice(index)) => {
                names.get(index).cloned().unwrap_or_default()
            }
            (_, OptionValue::Bool(on)) => on.to_string(),
            (_, OptionValue::Integer(n)) => n.to_string(),
            (_, OptionValue::Choice(_)) => String::new(),
        }
    }
}

//! Points in, table out: typed scalars in rows.

use std::fmt;

use super::error::SampleError;

/// The type of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `f32`
    F32,
    /// `i32`
    I32,
    /// `u32`
    U32,
    /// `bool`; of results only.
    Bool,
}

/// A value of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scalar {
    /// `f32`
    F32(f32),
    /// `i32`
    I32(i32),
    /// `u32`
    U32(u32),
    /// `bool`
    Bool(bool),
}

/// A column of points: a scalar of that name in the expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// An identifier.
    pub name: String,
    /// Its type.
    pub kind: Kind,
}

/// Where an expression is evaluated. Without columns, once.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Points {
    /// What each point gives.
    pub columns: Vec<Column>,
    /// The values, point by point, each in the order of the columns.
    pub values: Vec<Scalar>,
}

/// What came out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// `value` for a scalar; `x`, `y`, … for a vector; `c0_x`, … for a matrix; `0`, … for an array; and paths of fields,
    /// `id.x`, for a structure.
    pub columns: Vec<String>,
    /// The values, row by row.
    pub values: Vec<Scalar>,
}

impl Table {
    /// A row for each point, in their order.
    pub fn rows(&self) -> impl Iterator<Item = &[Scalar]> {
        self.values.chunks(self.columns.len().max(1))
    }
}

impl Column {
    /// A column as a CSV's header names it: `name` (f32), `name:u32` or `name:i32`.
    ///
    /// # Errors
    /// Where the type is another one. Whether the name can be one of WGSL is seen when it is used.
    pub fn parse(header: &str) -> Result<Self, crate::Error> {
        let (name, kind) = header.trim().split_once(':').unwrap_or((header.trim(), "f32"));
        let kind = match kind.trim() {
            "f32" => Kind::F32,
            "i32" => Kind::I32,
            "u32" => Kind::U32,
            other => {
                let why = format!("`{other}` is no type that a column can have");
                return Err(SampleError::Column { name: name.trim().into(), why }.into());
            }
        };
        Ok(Self { name: name.trim().to_owned(), kind })
    }
}

impl Kind {
    /// As WGSL names it.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::I32 => "i32",
            Self::U32 => "u32",
            Self::Bool => "bool",
        }
    }

    /// The value that `text` spells, `inf` and `nan` among the floats; none where it spells none of this type.
    pub fn parse(self, text: &str) -> Option<Scalar> {
        let text = text.trim();
        match self {
            Self::F32 => text.parse().ok().filter(|value| is_as_spelled(*value, text)).map(Scalar::F32),
            Self::I32 => text.parse().ok().map(Scalar::I32),
            Self::U32 => text.parse().ok().map(Scalar::U32),
            Self::Bool => text.parse().ok().map(Scalar::Bool),
        }
    }

    /// What is wrong with a `text` that [`Kind::parse`] does not take: `is not of type u32`, `is out of the range of u32`.
    pub fn refusal(self, text: &str) -> String {
        let text = text.trim();
        let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
        let is_number = match self {
            Self::F32 => text.parse::<f32>().is_ok(),
            Self::I32 | Self::U32 => !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()),
            Self::Bool => false,
        };
        let how = if is_number { "is out of the range of" } else { "is not of type" };
        format!("{how} {}", self.name())
    }
}

/// Whether `value` is what `text` spells: `1e39` reads as infinity, and means none.
fn is_as_spelled(value: f32, text: &str) -> bool {
    value.is_finite() || !text.bytes().any(|byte| byte.is_ascii_digit())
}

impl Scalar {
    /// Its type.
    pub fn kind(self) -> Kind {
        match self {
            Self::F32(_) => Kind::F32,
            Self::I32(_) => Kind::I32,
            Self::U32(_) => Kind::U32,
            Self::Bool(_) => Kind::Bool,
        }
    }

    /// As it travels to the GPU.
    pub(super) fn bits(self) -> u32 {
        match self {
            Self::F32(value) => value.to_bits(),
            Self::I32(value) => value.cast_unsigned(),
            Self::U32(value) => value,
            Self::Bool(value) => value.into(),
        }
    }

    pub(super) fn from_bits(kind: Kind, bits: u32) -> Self {
        match kind {
            Kind::F32 => Self::F32(f32::from_bits(bits)),
            Kind::I32 => Self::I32(bits.cast_signed()),
            Kind::U32 => Self::U32(bits),
            Kind::Bool => Self::Bool(bits != 0),
        }
    }
}

/// The shortest digits that read back as the same value; `inf`, `-inf` and `NaN` among the floats.
impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::F32(value) => write!(f, "{value:?}"),
            Self::I32(value) => write!(f, "{value}"),
            Self::U32(value) => write!(f, "{value}"),
            Self::Bool(value) => write!(f, "{value}"),
        }
    }
}

/// The most columns that points may have.
const MOST_COLUMNS: usize = 256;
/// Names of WGSL's own that the generated fragment spells.
const SPELLED: [&str; 9] =
    ["bitcast", "select", "arrayLength", "f32", "i32", "u32", "vec2f", "vec3f", "vec4f"];

/// Sees to it that the columns can be names in the expression, and that the values fit them.
pub(super) fn check(points: &Points) -> Result<(), SampleError> {
    for (index, column) in points.columns.iter().enumerate() {
        let name = column.name.as_str();
        let is_reserved = naga::keywords::wgsl::RESERVED.contains(&name) || SPELLED.contains(&name);
        let why = if !crate::syntax::is_ident(name) || name.starts_with("__") {
            "it is no WGSL identifier".to_owned()
        } else if is_reserved {
            "it is a word of WGSL's own".to_owned()
        } else if name.starts_with("orogen") {
            "names that start with `orogen` are Orogen's own".to_owned()
        } else if name == "p" {
            "`p` is the vector that the columns x, y, z and w make".to_owned()
        } else if points.columns[..index].iter().any(|other| other.name == name) {
            "there are two columns of that name".to_owned()
        } else if column.kind == Kind::Bool {
            "a column is f32, u32 or i32".to_owned()
        } else {
            continue;
        };
        return Err(SampleError::Column { name: name.into(), why });
    }
    let width = points.columns.len();
    if width > MOST_COLUMNS {
        let why = format!("there are {width} columns, and there may be {MOST_COLUMNS}");
        return Err(SampleError::Points { why });
    }
    if width == 0 && !points.values.is_empty() || width > 0 && !points.values.len().is_multiple_of(width) {
        let why = format!("{} values do not make rows of {width}", points.values.len());
        return Err(SampleError::Points { why });
    }
    for (index, value) in points.values.iter().enumerate() {
        let column = &points.columns[index % width];
        if value.kind() != column.kind {
            let (name, kind, found) = (&column.name, column.kind.name(), value.kind().name());
            let row = index / width + 1;
            let why = format!("row {row} gives the column `{name}` of type {kind} a value of type {found}");
            return Err(SampleError::Points { why });
        }
    }
    Ok(())
}

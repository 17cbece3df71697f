//! WGSL's types, as far as shaders of pure functions need them.

/// What a number or a truth value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::export) enum Scalar {
    Bool,
    I32,
    U32,
    F32,
    AbstractInt,
    AbstractFloat,
}

impl Scalar {
    pub(in crate::export) fn is_abstract(self) -> bool {
        matches!(self, Self::AbstractInt | Self::AbstractFloat)
    }

    pub(in crate::export) fn is_integer(self) -> bool {
        matches!(self, Self::I32 | Self::U32 | Self::AbstractInt)
    }

    /// What it becomes where nothing else is asked for.
    pub(in crate::export) fn concrete(self) -> Self {
        match self {
            Self::AbstractInt => Self::I32,
            Self::AbstractFloat => Self::F32,
            concrete => concrete,
        }
    }

    /// What two operands are together: the abstract one gives way.
    pub(in crate::export) fn unify(self, other: Self) -> Self {
        match (self, other) {
            (Self::AbstractInt, other) => other,
            (this, Self::AbstractInt) => this,
            (Self::AbstractFloat, other) => other,
            (this, _) => this,
        }
    }
}

/// What cannot be written in GLSL ES 3.00, by what it is called there or in WGSL.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::export) enum Opaque {
    Texture,
    Sampler,
    Atomic,
}

/// A type. Arrays and pointers are numbers of [`Types`], structs of the tree's declarations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::export) enum Ty {
    /// Of a call that gives nothing.
    Nothing,
    Scalar(Scalar),
    Vector(u8, Scalar),
    /// Columns, rows.
    Matrix(u8, u8, Scalar),
    Array(u32),
    Struct(u32),
    Pointer(u32),
    /// What `modf` gives, of so many components.
    Modf(u8),
    /// What `frexp` gives, of so many components.
    Frexp(u8),
    Opaque(Opaque),
}

impl Ty {
    pub(in crate::export) const BOOL: Self = Self::Scalar(Scalar::Bool);
    pub(in crate::export) const I32: Self = Self::Scalar(Scalar::I32);
    pub(in crate::export) const U32: Self = Self::Scalar(Scalar::U32);

    /// `n` components of `scalar`: a scalar itself where `n` is 1.
    pub(in crate::export) fn of(n: u8, scalar: Scalar) -> Self {
        if n == 1 { Self::Scalar(scalar) } else { Self::Vector(n, scalar) }
    }

    /// Of numbers and truth values: what its components are.
    pub(in crate::export) fn scalar(self) -> Option<Scalar> {
        match self {
            Self::Scalar(scalar) | Self::Vector(_, scalar) | Self::Matrix(_, _, scalar) => Some(scalar),
            _ => None,
        }
    }

    /// How many components a scalar or a vector has.
    pub(in crate::export) fn size(self) -> u8 {
        if let Self::Vector(n, _) = self { n } else { 1 }
    }

    pub(in crate::export) fn is_vector(self) -> bool {
        matches!(self, Self::Vector(..))
    }

    /// The same shape with other components.
    pub(in crate::export) fn with(self, scalar: Scalar) -> Self {
        match self {
            Self::Scalar(_) => Self::Scalar(scalar),
            Self::Vector(n, _) => Self::Vector(n, scalar),
            Self::Matrix(c, r, _) => Self::Matrix(c, r, scalar),
            other => other,
        }
    }
}

/// Arrays and pointers, each once.
#[derive(Debug, Default)]
pub(in crate::export) struct Types {
    /// Element, and how many where that is fixed.
    arrays: Vec<(Ty, Option<u32>)>,
    pointees: Vec<Ty>,
}

impl Types {
    pub(in crate::export) fn array(&mut self, element: Ty, len: Option<u32>) -> Ty {
        Ty::Array(number(&mut self.arrays, (element, len)))
    }

    pub(in crate::export) fn pointer(&mut self, to: Ty) -> Ty {
        Ty::Pointer(number(&mut self.pointees, to))
    }

    /// Element and length of array `index`.
    pub(in crate::export) fn of_array(&self, index: u32) -> (Ty, Option<u32>) {
        self.arrays[index as usize]
    }

    /// What `ty` points to; itself where it is no pointer.
    pub(in crate::export) fn pointee(&self, ty: Ty) -> Ty {
        if let Ty::Pointer(index) = ty { self.pointees[index as usize] } else { ty }
    }

    /// `ty` with what is abstract in it made concrete.
    pub(in crate::export) fn concrete(&mut self, ty: Ty) -> Ty {
        match ty {
            Ty::Array(index) => {
                let (element, len) = self.of_array(index);
                let element = self.concrete(element);
                self.array(element, len)
            }
            other => other.scalar().map_or(other, |scalar| other.with(scalar.concrete())),
        }
    }

    /// The scalar that `ty` is made of, through arrays.
    pub(in crate::export) fn scalar(&self, ty: Ty) -> Option<Scalar> {
        match ty {
            Ty::Array(index) => self.scalar(self.of_array(index).0),
            other => other.scalar(),
        }
    }
}

fn number<T: PartialEq>(known: &mut Vec<T>, item: T) -> u32 {
    let at = known.iter().position(|one| *one == item).unwrap_or_else(|| {
        known.push(item);
        known.len() - 1
    });
    at as u32
}

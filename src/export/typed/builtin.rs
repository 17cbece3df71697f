//! WGSL's own functions: what a call of each gives.

use super::ty::{Scalar, Ty};

/// What a call of the built-in function `name` gives for arguments of these types; none where it is not known.
pub(super) fn result(name: &str, arguments: &[Ty]) -> Option<Ty> {
    let first = arguments.first().copied();
    let together = || together(arguments);
    let floats = || {
        let ty = together()?;
        Some(if ty.scalar() == Some(Scalar::AbstractInt) { ty.with(Scalar::AbstractFloat) } else { ty })
    };
    Some(match name {
        "abs" | "max" | "min" | "clamp" | "sign" => together()?,
        "acos" | "acosh" | "asin" | "asinh" | "atan" | "atanh" | "atan2" | "ceil" | "cos" | "cosh"
        | "cross" | "degrees" | "exp" | "exp2" | "faceForward" | "floor" | "fma" | "fract"
        | "inverseSqrt" | "log" | "log2" | "mix" | "normalize" | "pow" | "radians" | "reflect"
        | "refract" | "round" | "saturate" | "sin" | "sinh" | "smoothstep" | "sqrt" | "step" | "tan"
        | "tanh" | "trunc" => floats()?,
        "dpdx" | "dpdxCoarse" | "dpdxFine" | "dpdy" | "dpdyCoarse" | "dpdyFine" | "fwidth"
        | "fwidthCoarse" | "fwidthFine" | "quantizeToF16" => floats()?.with(Scalar::F32),
        "length" | "distance" => Ty::Scalar(floats()?.scalar()?),
        "dot" => Ty::Scalar(together()?.scalar()?),
        "determinant" => Ty::Scalar(first?.scalar()?),
        "transpose" => match first? {
            Ty::Matrix(columns, rows, scalar) => Ty::Matrix(rows, columns, scalar),
            _ => return None,
        },
        "all" | "any" => Ty::BOOL,
        "select" => {
            let (a, b) = (first?, *arguments.get(1)?);
            match (a.scalar(), b.scalar()) {
                (Some(_), Some(_)) => self::together(&[a, b])?,
                _ => a,
            }
        }
        "countLeadingZeros" | "countOneBits" | "countTrailingZeros" | "firstLeadingBit"
        | "firstTrailingBit" | "reverseBits" | "extractBits" => first?.with(first?.scalar()?.concrete()),
        "insertBits" => {
            let ty = self::together(arguments.get(..2)?)?;
            ty.with(ty.scalar()?.concrete())
        }
        "ldexp" => {
            let ty = first?;
            if ty.scalar()?.is_integer() { ty.with(Scalar::AbstractFloat) } else { ty }
        }
        "modf" => Ty::Modf(first?.size()),
        "frexp" => Ty::Frexp(first?.size()),
        "pack4x8snorm" | "pack4x8unorm" | "pack4xI8" | "pack4xU8" | "pack4xI8Clamp" | "pack4xU8Clamp"
        | "pack2x16snorm" | "pack2x16unorm" | "pack2x16float" | "dot4U8Packed" => Ty::U32,
        "dot4I8Packed" => Ty::I32,
        "unpack4x8snorm" | "unpack4x8unorm" => Ty::Vector(4, Scalar::F32),
        "unpack2x16snorm" | "unpack2x16unorm" | "unpack2x16float" => Ty::Vector(2, Scalar::F32),
        "unpack4xI8" => Ty::Vector(4, Scalar::I32),
        "unpack4xU8" => Ty::Vector(4, Scalar::U32),
        _ => return None,
    })
}

/// Scalars and vectors that a function takes as one type: the largest size, and the most concrete components.
pub(super) fn together(types: &[Ty]) -> Option<Ty> {
    let mut scalar = types.first()?.scalar()?;
    for ty in types {
        scalar = scalar.unify(ty.scalar()?);
    }
    if let Some(matrix) = types.iter().find(|ty| matches!(ty, Ty::Matrix(..))) {
        return Some(matrix.with(scalar));
    }
    Some(Ty::of(types.iter().map(|ty| ty.size()).max()?, scalar))
}

/// The components that the type names `vec2f`, `mat3x3f` and so on stand for: sizes, and the scalar where it is named.
pub(super) fn constructor(name: &str) -> Option<(Shape, Option<Scalar>)> {
    let scalar_of = |letter: &str| match letter {
        "" => Some(None),
        "f" => Some(Some(Scalar::F32)),
        "i" => Some(Some(Scalar::I32)),
        "u" => Some(Some(Scalar::U32)),
        _ => None,
    };
    let digit = |text: &str| text.parse::<u8>().ok().filter(|n| (2..=4).contains(n));
    if let Some(rest) = name.strip_prefix("vec") {
        let (size, letter) = rest.split_at_checked(1)?;
        return Some((Shape::Vector(digit(size)?), scalar_of(letter)?));
    }
    if let Some(rest) = name.strip_prefix("mat") {
        let (columns, rest) = rest.split_at_checked(1)?;
        let (rows, letter) = rest.strip_prefix('x')?.split_at_checked(1)?;
        return Some((Shape::Matrix(digit(columns)?, digit(rows)?), scalar_of(letter)?));
    }
    let scalar = match name {
        "bool" => Scalar::Bool,
        "i32" => Scalar::I32,
        "u32" => Scalar::U32,
        "f32" => Scalar::F32,
        _ => return None,
    };
    Some((Shape::Scalar, Some(scalar)))
}

/// How many components, and in which order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Scalar,
    Vector(u8),
    /// Columns, rows.
    Matrix(u8, u8),
}

impl Shape {
    pub(super) fn of(self, scalar: Scalar) -> Ty {
        match self {
            Self::Scalar => Ty::Scalar(scalar),
            Self::Vector(n) => Ty::Vector(n, scalar),
            Self::Matrix(columns, rows) => Ty::Matrix(columns, rows, scalar),
        }
    }
}

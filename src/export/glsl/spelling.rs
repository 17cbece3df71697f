//! Types, zeros and numbers in GLSL's spelling.

use super::super::typed::{Scalar, Ty};

/// The name of a scalar, vector or matrix. Abstract ones are called as what they become.
pub(super) fn numeric(ty: Ty) -> String {
    let letter = |scalar: Scalar| match scalar.concrete() {
        Scalar::Bool => "b",
        Scalar::I32 => "i",
        Scalar::U32 => "u",
        _ => "",
    };
    match ty {
        Ty::Scalar(scalar) => match scalar.concrete() {
            Scalar::Bool => "bool",
            Scalar::I32 => "int",
            Scalar::U32 => "uint",
            _ => "float",
        }
        .to_owned(),
        Ty::Vector(size, scalar) => format!("{}vec{size}", letter(scalar)),
        Ty::Matrix(columns, rows, _) if columns == rows => format!("mat{columns}"),
        Ty::Matrix(columns, rows, _) => format!("mat{columns}x{rows}"),
        _ => String::new(),
    }
}

/// Nought.
pub(super) fn zero(scalar: Scalar) -> &'static str {
    match scalar.concrete() {
        Scalar::Bool => "false",
        Scalar::I32 => "0",
        Scalar::U32 => "0u",
        _ => "0.0",
    }
}

/// A number as a literal of `scalar`, or none where it has none.
pub(super) fn number(value: f64, scalar: Scalar) -> Option<String> {
    match scalar.concrete() {
        Scalar::F32 => {
            let single = value as f32;
            single.is_finite().then(|| float(single))
        }
        Scalar::I32 if value == f64::from(i32::MIN) => Some("(-2147483647 - 1)".to_owned()),
        Scalar::I32
            if value.fract() == 0.0 && (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&value) =>
        {
            Some(format!("{}", value as i64))
        }
        Scalar::U32 if value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value) => {
            Some(format!("{}u", value as i64))
        }
        _ => None,
    }
}

/// The shortest literal that reads as `value`.
pub(super) fn float(value: f32) -> String {
    // The shortest of the greatest float is a little above it, and some take that for infinite.
    let plain = if value.abs() == f32::MAX {
        format!("{}3.4028234e38", if value < 0.0 { "-" } else { "" })
    } else {
        format!("{value:?}") // `1e-8`, `0.5`
    };
    if plain.contains(['.', 'e']) { plain } else { format!("{plain}.0") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_literals_of_their_type() {
        assert_eq!(number(1.0, Scalar::F32).as_deref(), Some("1.0"));
        assert_eq!(number(f64::from(f32::MAX), Scalar::F32).as_deref(), Some("3.4028234e38"));
        assert_eq!("3.4028234e38".parse(), Ok(f32::MAX));
        assert_eq!(number(1e-8, Scalar::F32).as_deref(), Some("1e-8"));
        assert_eq!(number(-2147483648.0, Scalar::I32).as_deref(), Some("(-2147483647 - 1)"));
        assert_eq!(number(4294967295.0, Scalar::U32).as_deref(), Some("4294967295u"));
        assert_eq!(number(-1.0, Scalar::U32), None);
        assert_eq!(number(0.5, Scalar::I32), None);
    }
}

//! Values as WGSL literals that parse back to the same value.

use crate::syntax::{Type, Value};

/// `value` as WGSL: `1800.0`, `vec3f(0.32, 0.29, 0.27)`, `true`.
pub fn literal(value: &Value) -> String {
    match value {
        Value::Bool(value) => value.to_string(),
        Value::I32(value) => value.to_string(),
        Value::U32(value) => format!("{value}u"),
        Value::F32(value) => float(*value),
        vector => {
            let parts: Vec<_> = vector.floats().iter().map(|value| float(*value)).collect();
            format!("{}({})", vector.ty(), parts.join(", "))
        }
    }
}

/// A finite f32, as an abstract float that rounds to it: WGSL reads literals as f64 first, and the shortest digits of an
/// f32 can, rarely, round twice to its neighbour.
pub(super) fn float(value: f32) -> String {
    let short = format!("{value:?}");
    let read = short.parse::<f64>().unwrap_or(0.0);
    let fits = read as f32 == value && read.abs() <= f64::from(f32::MAX);
    if fits { short } else { format!("{:?}", f64::from(value)) }
}

/// `value` as the code reads it: angles in radians.
pub(crate) fn in_code(value: &Value, unit: Option<&str>) -> Value {
    if unit != Some("deg") {
        return *value;
    }
    let radians: Vec<f32> =
        value.floats().iter().map(|degrees| f64::from(*degrees).to_radians() as f32).collect();
    Value::from_floats(value.ty(), &radians).unwrap_or(*value)
}

/// The scalars that `value` is made of.
pub(super) fn scalars(value: &Value) -> Vec<Value> {
    if value.ty().components() == 1 {
        return vec![*value];
    }
    value.floats().iter().map(|value| Value::F32(*value)).collect()
}

/// Its bytes in a uniform buffer, little-endian. A `bool` is a `u32`.
pub(super) fn bytes(value: &Value) -> Vec<u8> {
    match value {
        Value::Bool(value) => u32::from(*value).to_le_bytes().to_vec(),
        Value::I32(value) => value.to_le_bytes().to_vec(),
        Value::U32(value) => value.to_le_bytes().to_vec(),
        floats => floats.floats().iter().flat_map(|value| value.to_le_bytes()).collect(),
    }
}

/// The type as a uniform buffer holds it.
pub(super) fn uniform_type(ty: Type) -> Type {
    if ty == Type::Bool { Type::U32 } else { ty }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_f32_comes_back(bits: u32) {
            let value = f32::from_bits(bits);
            prop_assume!(value.is_finite());
            let text = float(value);
            prop_assert_eq!((text.parse::<f64>().unwrap_or(f64::NAN) as f32).to_bits(), bits);
            prop_assert!(text.contains(['.', 'e']), "{} would be an integer", text);
        }
    }

    #[test]
    fn the_ends_of_f32_are_written_exactly() {
        assert_eq!(float(f32::MAX), "3.4028234663852886e38");
        assert_eq!(float(1e-45), "1e-45");
        assert_eq!(float(-0.0), "-0.0");
        assert_eq!(literal(&Value::U32(u32::MAX)), "4294967295u");
    }
}

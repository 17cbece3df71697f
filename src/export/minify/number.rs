//! Numbers in as few characters as they can be written: `0.50` → `.5`, `1.0` → `1.`, `100000.0` → `1e5`, `0x1u` → `1u`.
//!
//! The value stays the same to the last digit, and so does what the language makes of it: a float stays one.

use std::borrow::Cow;

/// A literal of WGSL, as short as it goes.
pub(super) fn wgsl(text: &str) -> Cow<'_, str> {
    if let Some(hex) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        let digits = hex.trim_end_matches(['u', 'i']);
        let decimal = u64::from_str_radix(digits, 16).map(|value| format!("{value}{}", &hex[digits.len()..]));
        return shorter(text, decimal.ok()); // floats fail to be read, and stay
    }
    let digits = text.trim_end_matches(['f', 'h']);
    let suffix = &text[digits.len()..];
    if suffix.is_empty() && !digits.contains(['.', 'e', 'E']) {
        return Cow::Borrowed(text);
    }
    shorter(text, float(digits, suffix))
}

/// A literal of GLSL ES 3.00. Its `f` says nothing there.
pub(super) fn glsl(text: &str) -> Cow<'_, str> {
    let is_hex = text.starts_with("0x") || text.starts_with("0X");
    if is_hex || !text.contains(['.', 'e', 'E']) {
        return Cow::Borrowed(text);
    }
    shorter(text, float(text.trim_end_matches(['f', 'F']), ""))
}

fn shorter(text: &str, other: Option<String>) -> Cow<'_, str> {
    other.filter(|other| other.len() < text.len()).map_or(Cow::Borrowed(text), Cow::Owned)
}

/// A decimal float; none where it is not understood.
fn float(text: &str, suffix: &str) -> Option<String> {
    const MOST_ZEROS: i32 = 32;
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{fraction}");
    if all.is_empty() || !all.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let exponent = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let digits = all.trim_end_matches('0');
    let exponent = exponent.checked_add(i32::try_from(all.len() - digits.len()).ok()?)?;
    let digits = digits.trim_start_matches('0');
    let dot = if suffix.is_empty() { "." } else { "" };
    if digits.is_empty() {
        return Some(format!("0{dot}{suffix}"));
    }
    let len = i32::try_from(digits.len()).ok()?;
    let zeros = |count: i32| "0".repeat(count.unsigned_abs() as usize);
    let plain = match exponent {
        0..=MOST_ZEROS => Some(format!("{digits}{}{dot}", zeros(exponent))),
        _ if exponent < 0 && -exponent < len => {
            let (whole, fraction) = digits.split_at((len + exponent) as usize);
            Some(format!("{whole}.{fraction}"))
        }
        _ if exponent < 0 && -exponent - len <= MOST_ZEROS => {
            Some(format!(".{}{digits}", zeros(exponent + len)))
        }
        _ => None,
    };
    let short = format!("{digits}e{exponent}");
    let best = plain.filter(|plain| plain.len() <= short.len()).unwrap_or(short);
    Some(best + suffix)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_get_short_and_stay_what_they_are() {
        let all = [
            ("0.50", ".5"),
            ("1.0", "1."),
            ("0.0", "0."),
            ("00.0", "0."),
            ("0.0f", "0f"),
            ("1.0f", "1f"),
            ("1.5h", "1.5h"),
            ("100000.0", "1e5"),
            ("1000.0", "1e3"),
            ("100.0", "1e2"),
            ("10.0", "10."),
            ("120.0", "120."),
            ("1e+5", "1e5"),
            ("1.50E-07", "15e-8"),
            ("0.001", ".001"),
            ("0.0001", "1e-4"),
            ("123.456", "123.456"),
            ("1", "1"),
            ("1u", "1u"),
            ("0x1u", "1u"),
            ("0x10i", "16i"),
            ("0xFFFFFFFFu", "0xFFFFFFFFu"),
            ("0x1.8p1", "0x1.8p1"),
            ("0x1p-4f", "0x1p-4f"),
            ("0x1f", "31"),
            ("1e99999999999", "1e99999999999"),
        ];
        for (long, short) in all {
            assert_eq!(wgsl(long), short, "{long}");
        }
        assert_eq!(
            ["1.0", "1.0f", "0.5F", "7", "0x1fu", "1e-10"].map(glsl),
            ["1.", "1.", ".5", "7", "0x1fu", "1e-10"]
        );
    }

    proptest! {
        #[test]
        fn every_float_keeps_its_value(text in "[0-9]{0,12}\\.[0-9]{1,12}([eE][+-]?[0-9]{1,3})?") {
            let short = wgsl(&text);
            prop_assert!(short.len() <= text.len());
            prop_assert!(short.contains(['.', 'e', 'E']), "{} would be an integer", short);
            prop_assert_eq!(text.parse::<f64>().map(f64::to_bits), short.parse::<f64>().map(f64::to_bits));
            prop_assert_eq!(text.parse::<f32>().map(f32::to_bits), short.parse::<f32>().map(f32::to_bits));
        }
    }
}

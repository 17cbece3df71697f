//! Integer hashes of the PCG family (Jarzynski & Olano 2020) and the numbers made of them.

/// Hash of one integer (PCG RXS-M-XS).
#[must_use]
pub fn pcg(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// The top 24 bits as a number, `0 ≤ result < 1`.
#[must_use]
pub fn unit(bits: u32) -> f64 {
    f64::from(bits >> 8) / f64::from(1 << 24)
}

/// The top 24 bits as a number, `-1 ≤ result < 1`.
#[must_use]
pub fn signed(bits: u32) -> f64 {
    2.0 * unit(bits) - 1.0
}

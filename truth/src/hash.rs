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

/// Two hashes of two integers.
#[must_use]
pub fn pcg2d(value: [u32; 2]) -> [u32; 2] {
    let [mut x, mut y] = value.map(congruential);
    for _ in 0..2 {
        x = x.wrapping_add(y.wrapping_mul(1_664_525));
        y = y.wrapping_add(x.wrapping_mul(1_664_525));
        x ^= x >> 16;
        y ^= y >> 16;
    }
    [x, y]
}

/// Three hashes of three integers, without the last xorshift.
#[must_use]
pub fn pcg3d(value: [u32; 3]) -> [u32; 3] {
    let [mut x, mut y, mut z] = value.map(congruential);
    for round in 0..2 {
        x = x.wrapping_add(y.wrapping_mul(z));
        y = y.wrapping_add(z.wrapping_mul(x));
        z = z.wrapping_add(x.wrapping_mul(y));
        if round == 0 {
            [x, y, z] = [x, y, z].map(|hash| hash ^ hash >> 16);
        }
    }
    [x, y, z]
}

fn congruential(value: u32) -> u32 {
    value.wrapping_mul(1_664_525).wrapping_add(1_013_904_223)
}

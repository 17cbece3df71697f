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

/// How far from one half the top 24 bits of [`pcg`] are from flipping with each bit of the input; the worst pair.
#[must_use]
pub fn avalanche_bias_of_pcg() -> f64 {
    avalanche_bias(|value: [u32; 1]| value.map(pcg))
}

/// As [`avalanche_bias_of_pcg`], of [`pcg2d`].
#[must_use]
pub fn avalanche_bias_of_pcg2d() -> f64 {
    avalanche_bias(pcg2d)
}

/// As [`avalanche_bias_of_pcg`], of [`pcg3d`].
#[must_use]
pub fn avalanche_bias_of_pcg3d() -> f64 {
    avalanche_bias(pcg3d)
}

fn avalanche_bias<const N: usize>(hash: impl Fn([u32; N]) -> [u32; N]) -> f64 {
    const SAMPLES: u32 = 1 << 18;
    let mut random = crate::points::Random::new(1);
    // By input word, input bit, output word, output bit.
    let mut flips = vec![[[[0_u32; 24]; N]; 32]; N];
    for _ in 0..SAMPLES {
        let value: [u32; N] = std::array::from_fn(|_| random.bits());
        let before = hash(value);
        for (word, flips) in flips.iter_mut().enumerate() {
            for (bit, flips) in flips.iter_mut().enumerate() {
                let mut moved = value;
                moved[word] ^= 1 << bit;
                let after = hash(moved);
                for (output, flips) in flips.iter_mut().enumerate() {
                    let changed = before[output] ^ after[output];
                    for (bit, flips) in flips.iter_mut().enumerate() {
                        *flips += changed >> (8 + bit) & 1;
                    }
                }
            }
        }
    }
    let counts = flips.as_flattened().as_flattened().as_flattened();
    counts.iter().map(|&count| (f64::from(count) / f64::from(SAMPLES) - 0.5).abs()).fold(0.0, f64::max)
}

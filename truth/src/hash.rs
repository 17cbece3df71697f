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

/// How unlike a coin's the top 24 bits of a hash are when one bit of the input flips: how far from one half the part of the
/// flips is that flips them. The worst bit counts.
#[derive(Debug, Clone, Copy)]
pub struct Avalanche {
    /// Over flips of any of the low 16 bits of any input: those that tell cells from their neighbours.
    pub bit: f64,
    /// Over flips of one of the low 16 bits of one input, the worst one.
    pub pair: f64,
    /// Over flips of one bit of one input, the worst of all 32.
    pub any_pair: f64,
}

/// Of [`pcg`].
#[must_use]
pub fn avalanche_of_pcg() -> Avalanche {
    avalanche(|value: [u32; 1]| value.map(pcg))
}

/// Of [`pcg2d`].
#[must_use]
pub fn avalanche_of_pcg2d() -> Avalanche {
    avalanche(pcg2d)
}

/// Of [`pcg3d`].
#[must_use]
pub fn avalanche_of_pcg3d() -> Avalanche {
    avalanche(pcg3d)
}

fn avalanche<const N: usize>(hash: impl Fn([u32; N]) -> [u32; N]) -> Avalanche {
    let [bit, pair] = biases(&hash, 16, 1 << 18);
    let [_, any_pair] = biases(&hash, 32, 1 << 14);
    Avalanche { bit, pair, any_pair }
}

/// The worst bias of an output bit over flips of all of the low `width` bits of the inputs, and over flips of one of them.
fn biases<const N: usize>(hash: &impl Fn([u32; N]) -> [u32; N], width: usize, samples: u32) -> [f64; 2] {
    let mut random = crate::points::Random::new(1);
    // By input bit, output word, output bit.
    let mut flips = vec![[[0_u32; 24]; N]; width * N];
    for _ in 0..samples {
        let value: [u32; N] = std::array::from_fn(|_| random.bits());
        let before = hash(value);
        for (bit, flips) in flips.iter_mut().enumerate() {
            let mut moved = value;
            moved[bit / width] ^= 1 << (bit % width);
            let after = hash(moved);
            for (word, flips) in flips.iter_mut().enumerate() {
                let changed = before[word] ^ after[word];
                for (bit, flips) in flips.iter_mut().enumerate() {
                    *flips += changed >> (8 + bit) & 1;
                }
            }
        }
    }
    let bias = |count: u32, of: u32| (f64::from(count) / f64::from(of) - 0.5).abs();
    let pairs = flips.iter().flatten().flatten().map(|&count| bias(count, samples));
    let bits = (0..24 * N).map(|bit| {
        let count = flips.iter().map(|flips| flips[bit / 24][bit % 24]).sum();
        bias(count, samples * flips.len() as u32)
    });
    [bits.fold(0.0, f64::max), pairs.fold(0.0, f64::max)]
}

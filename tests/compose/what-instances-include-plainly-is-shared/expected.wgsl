// ---- random ----
const random_seed: f32 = 7.0;

// ---- hash.wgsl ----
fn hash() -> f32 { return random_seed; }

// ---- layer.wgsl as a ----
fn a_density() -> f32 { return hash(); }

// ---- layer.wgsl as b ----
fn b_density() -> f32 { return hash(); }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(a_density() + b_density() + hash());
}

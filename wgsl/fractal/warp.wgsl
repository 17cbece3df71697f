// Domain distortion: any relief, seen through a plane that a second field has bent.

/// What is bent: (value, d/dx, d/dy).
#slot relief: fn(p: vec2f, seed: u32) -> vec3f
/// What bends it, one coordinate at a time: (value, d/dx, d/dy). A smooth fBm of few octaves.
#slot drift: fn(p: vec2f, seed: u32) -> vec3f

/// relief(p / size + strength · (drift₁(p / size), drift₂(p / size))) with its gradient by the chain rule, exact:
/// (value, d/dx, d/dy).
///
/// fbm(p/h + γ fbm′(p)) where both slots are fBm. `size` > 0: length of the relief's unit, in units of `p`. `strength`:
/// in units of the relief. The drifts have the seeds `seed` + 71 and + 72. Range: the relief's own. A fold (the map p →
/// q no longer one to one) is possible from strength · drift's slope = 1 upward, and looks like flow.
fn warp2(p: vec2f, seed: u32, size: f32, strength: f32) -> vec3f {
    let at = p / size;
    var q = at;
    var turned = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // row i: gradient of q[i]; kept as its transpose
    for (var i = 0; i < 2; i++) {
        let bend = strength * drift(at, seed + 71u + u32(i));
        q[i] += bend.x;
        turned[i] += bend.yz;
    }
    let value = relief(q, seed);
    return vec3f(value.x, turned * value.yz / size);
}

/// A slope that `warp2` nowhere exceeds, where relief and drift nowhere exceed theirs: its Lipschitz bound.
fn warp_slope_bound(size: f32, strength: f32, relief_slope: f32, drift_slope: f32) -> f32 {
    return relief_slope * (1.0 + 1.4142136 * abs(strength) * drift_slope) / size;
}

// Values that carry their derivatives with them: a function of the plane up to second order at one point.

/// A function of the plane near a point: its value, its gradient and its second derivatives.
struct Jet2 {
    /// The value.
    value: f32,
    /// (d/dx, d/dy).
    gradient: vec2f,
    /// (d²/dx², d²/dxdy, d²/dy²).
    hessian: vec3f,
}

/// A constant: no derivatives.
fn jet2_constant(value: f32) -> Jet2 {
    return Jet2(value, vec2f(0.0), vec3f(0.0));
}

/// A jet taken at `scale` · p, as a function of p.
fn jet2_per(a: Jet2, scale: f32) -> Jet2 {
    return Jet2(a.value, scale * a.gradient, (scale * scale) * a.hessian);
}

/// `a` + `b`.
fn jet2_sum(a: Jet2, b: Jet2) -> Jet2 {
    return Jet2(a.value + b.value, a.gradient + b.gradient, a.hessian + b.hessian);
}

/// `factor` · `a`.
fn jet2_scaled(a: Jet2, factor: f32) -> Jet2 {
    return Jet2(factor * a.value, factor * a.gradient, factor * a.hessian);
}

/// `a` · `b`.
fn jet2_product(a: Jet2, b: Jet2) -> Jet2 {
    let cross = a.gradient.xxy * b.gradient.xyy + b.gradient.xxy * a.gradient.xyy;
    return Jet2(
        a.value * b.value,
        a.value * b.gradient + b.value * a.gradient,
        a.value * b.hessian + b.value * a.hessian + cross,
    );
}

/// f(`a`) where f has the value `f0`, the slope `f1` and the second derivative `f2` at a.value.
fn jet2_through(a: Jet2, f0: f32, f1: f32, f2: f32) -> Jet2 {
    return Jet2(f0, f1 * a.gradient, f1 * a.hessian + f2 * a.gradient.xxy * a.gradient.xyy);
}

/// A jet taken at q = `to_q` · p + constant, as a function of p.
fn jet2_carried(a: Jet2, to_q: mat2x2f) -> Jet2 {
    let turned_x = vec2f(dot(a.hessian.xy, to_q[0]), dot(a.hessian.yz, to_q[0])); // Hessian times the first column
    let turned_y = vec2f(dot(a.hessian.xy, to_q[1]), dot(a.hessian.yz, to_q[1]));
    return Jet2(
        a.value,
        a.gradient * to_q, // a row vector times M is Mᵀ times the vector
        vec3f(dot(to_q[0], turned_x), dot(to_q[0], turned_y), dot(to_q[1], turned_y)),
    );
}

/// f(x, y), where f is known by its derivatives in x and y, and both are functions of the plane themselves (chain
/// rule).
fn jet2_composed(f: Jet2, x: Jet2, y: Jet2) -> Jet2 {
    let a = x.gradient;
    let b = y.gradient;
    let hessian = f.gradient.x * x.hessian + f.gradient.y * y.hessian
        + f.hessian.x * vec3f(a.x * a.x, a.x * a.y, a.y * a.y)
        + f.hessian.y * vec3f(2.0 * a.x * b.x, a.x * b.y + a.y * b.x, 2.0 * a.y * b.y)
        + f.hessian.z * vec3f(b.x * b.x, b.x * b.y, b.y * b.y);
    return Jet2(f.value, f.gradient.x * a + f.gradient.y * b, hessian);
}

/// `smoothstep(low, high, f)`, for `low` < `high`.
fn jet2_smoothstep(low: f32, high: f32, f: Jet2) -> Jet2 {
    let width = high - low;
    let t = clamp((f.value - low) / width, 0.0, 1.0);
    let curvature = select(0.0, (6.0 - 12.0 * t) / (width * width), t > 0.0 && t < 1.0);
    return jet2_through(f, t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / width, curvature);
}

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

/// `scale` f + `shift`.
fn jet2_affine(f: Jet2, scale: f32, shift: f32) -> Jet2 {
    return Jet2(scale * f.value + shift, scale * f.gradient, scale * f.hessian);
}

/// f + g.
fn jet2_add(f: Jet2, g: Jet2) -> Jet2 {
    return Jet2(f.value + g.value, f.gradient + g.gradient, f.hessian + g.hessian);
}

/// f · g (Leibniz).
fn jet2_multiply(f: Jet2, g: Jet2) -> Jet2 {
    let a = f.gradient;
    let b = g.gradient;
    let mixed = vec3f(2.0 * a.x * b.x, a.x * b.y + a.y * b.x, 2.0 * a.y * b.y);
    return Jet2(f.value * g.value, f.value * b + g.value * a, f.value * g.hessian + g.value * f.hessian + mixed);
}

/// h(f) for a function h of one variable, given as (h, h', h'') at the value of f (chain rule).
fn jet2_apply(f: Jet2, h: vec3f) -> Jet2 {
    let a = f.gradient;
    return Jet2(h.x, h.y * a, h.y * f.hessian + h.z * vec3f(a.x * a.x, a.x * a.y, a.y * a.y));
}

/// f(x, y), where f is known by its derivatives in x and y, and both are functions of the plane themselves (chain
/// rule).
fn jet2_compose(f: Jet2, x: Jet2, y: Jet2) -> Jet2 {
    let a = x.gradient;
    let b = y.gradient;
    let hessian = f.gradient.x * x.hessian + f.gradient.y * y.hessian
        + f.hessian.x * vec3f(a.x * a.x, a.x * a.y, a.y * a.y)
        + f.hessian.y * vec3f(2.0 * a.x * b.x, a.x * b.y + a.y * b.x, 2.0 * a.y * b.y)
        + f.hessian.z * vec3f(b.x * b.x, b.x * b.y, b.y * b.y);
    return Jet2(f.value, f.gradient.x * a + f.gradient.y * b, hessian);
}

/// `smoothstep(low, high, f)`; `low` < `high`.
fn jet2_smoothstep(low: f32, high: f32, f: Jet2) -> Jet2 {
    let width = high - low;
    let t = clamp((f.value - low) / width, 0.0, 1.0);
    return jet2_apply(f, vec3f(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / width, select(0.0, (6.0 - 12.0 * t) / (width * width), t > 0.0 && t < 1.0)));
}

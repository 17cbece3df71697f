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

fn og_step2(a0: f32) -> f32 { return f32(); }

// ---- inner.wgsl as inner ----
fn og_inner_once(x: f32) -> f32 {
    return og_step2(x);
}

// ---- twice.wgsl ----
/// Two steps.
fn og_twice(x: f32) -> f32 {
    return og_step2(og_inner_once(x));
}

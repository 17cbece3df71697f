diagnostic(off,derivative_uniformity);
diagnostic(warning, my.own_rule);
requires readonly_and_readwrite_storage_textures;

// ---- a.wgsl ----
fn a() -> f32 { return 1.0; }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(a());
}

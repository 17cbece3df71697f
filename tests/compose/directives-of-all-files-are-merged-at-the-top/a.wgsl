diagnostic(off,derivative_uniformity);
diagnostic(warning, my.own_rule);
requires readonly_and_readwrite_storage_textures;
fn a() -> f32 { return 1.0; }

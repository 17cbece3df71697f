fn perlin2(p: vec2f) -> f32 { return p.x; }

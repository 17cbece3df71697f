// Höhe über Grund — 高さ
const Höhe: f32 = 1.5;
fn 面积(längе: f32) -> f32 { let δ = längе * Höhe; return δ * δ; }
@fragment fn main() -> @location(0) vec4f { return vec4f(面积(2.0)); }

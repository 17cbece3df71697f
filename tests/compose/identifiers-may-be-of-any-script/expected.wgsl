// ---- höhe ----
/// Die Höhe über dem Meer.
const höhe_größe: f32 = 2.0;

// ---- δ.wgsl as θ ----
fn θ_σ(x: f32) -> f32 { return x; }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(höhe_größe + θ_σ(высота()));
}
fn высота() -> f32 { return 1.0; } // 高さ 🏔

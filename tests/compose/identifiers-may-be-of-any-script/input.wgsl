/// Die Höhe über dem Meer.
#param höhe.größe: f32 = 2.0, unit m
#include <δ.wgsl> as θ

@fragment fn main() -> @location(0) vec4f {
    return vec4f(höhe.größe + θ_σ(высота()));
}
fn высота() -> f32 { return 1.0; } // 高さ 🏔

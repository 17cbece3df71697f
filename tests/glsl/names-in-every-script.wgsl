// Identifiers of other scripts, which GLSL spells in ASCII.

const π = 3.0;

struct Höhe { größe: f32, 高さ: f32 }

fn λ(Δx: f32) -> f32 {
    return Δx * π;
}

fn größe_von(höhe: Höhe) -> f32 {
    let größe = höhe.größe;
    return größe + höhe.高さ;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let é = floor(at.x);
    let e = floor(at.y);
    let е = 7.0; // a Cyrillic one
    let höhe = Höhe(é, е);
    return vec4f(λ(é), größe_von(höhe), e, é + е);
}

#param sun.power: f32 = 1.0

fn orogen() -> f32 { return 1.0; }
struct OrogenParams { x: f32 }

fn orogen() -> f32 { return 1.0; }
struct OrogenParams { x: f32 }

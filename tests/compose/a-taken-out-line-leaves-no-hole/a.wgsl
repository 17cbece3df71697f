

fn a() -> f32 { return 1.0; }



fn b() -> f32 { return 1.0; }

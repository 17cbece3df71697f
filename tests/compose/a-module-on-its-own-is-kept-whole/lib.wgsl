fn of_library() -> f32 { return 1.0; }
fn not_asked_for() -> f32 { return 1.0; }

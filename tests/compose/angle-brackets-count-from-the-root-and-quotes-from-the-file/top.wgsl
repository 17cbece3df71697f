fn top() -> f32 { return 0.125; }

struct Hit { distance: f32 }
fn f(hit: Hit) -> f32 { return hit.distanse; }

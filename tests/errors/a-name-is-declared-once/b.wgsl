struct helper { x: f32 }

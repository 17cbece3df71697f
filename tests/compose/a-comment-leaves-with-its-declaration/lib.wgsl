// About what nobody uses.
fn unused() -> f32 { return 1.0; }

// About what is used.
fn used() -> f32 { return 1.0; } // behind it

// About what nobody uses, either.
fn unused_too() -> f32 { return 1.0; }

// At the end of the file.

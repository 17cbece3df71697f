var<private> counter: atomic<u32>;
fn f() -> u32 { return atomicLoad(&counter); }

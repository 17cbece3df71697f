// The library.

const SIZE = 8; // threads
struct Inner { x: Number, }
alias Number = f32;
struct Outer { inner: Inner, @size(PADDING) y: f32 }
const PADDING = 16;
const_assert SIZE == LIMIT; // holds for all
const LIMIT = 8;
fn used() -> f32 { return Outer(Inner(1.0), 2.0).inner.x; }
fn lost() -> Lost { return Lost(); }
struct Lost { x: f32 }
var<private> state: f32;

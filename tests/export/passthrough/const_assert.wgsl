const N = 4;
const_assert N < 5;
const M: u32 = N * 2u;
const_assert(M == 8u);

fn used() -> i32 { const_assert true; return N; }
fn unused() -> u32 { return M; }
@compute @workgroup_size(M) fn main() { _ = used(); }

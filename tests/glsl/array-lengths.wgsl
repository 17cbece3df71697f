// The length of an array from constants and expressions, used in loops and in other types.

const N = 2 + 1;
const M = N * 2u;
alias List = array<i32, N>;

struct Holder { list: array<List, M / 2> }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var holder: Holder;
    for (var i = 0; i < N; i++) {
        for (var j = 0u; j < M / 2; j++) { holder.list[j][i] = i * 10 + i32(j) + i32(at.x); }
    }
    return vec4i(holder.list[2][1], holder.list[u32(at.y) % 3u][2], i32(M), N);
}

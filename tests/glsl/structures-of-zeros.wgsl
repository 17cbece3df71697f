// `T()` is all zeros, also nested and in arrays.

struct Leaf { n: i32, v: vec2u, on: bool }
struct Tree { leaves: array<Leaf, 2>, m: mat2x2f, name: u32 }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var tree = Tree();
    let leaf = Leaf();
    let x = i32(at.x);
    tree.leaves[x & 1].n = x;
    tree.leaves[1] = Leaf(tree.leaves[1].n + 5, vec2u(3u), true);
    if x > 40 { tree = Tree(); }
    return vec4i(tree.leaves[0].n, tree.leaves[1].n + i32(tree.leaves[1].v.y), i32(tree.leaves[1].on), leaf.n + i32(tree.m[1].x) + i32(tree.name));
}

// Elements of arrays, of arrays in structs, and components of vectors in arrays; the right side may read the left.

struct Heap { size: i32, items: array<vec2i, 4> }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let i = x % 4;
    var a = array<i32, 4>(1, 2, 3, 4);
    a[0] += x;
    a[i] *= 3;
    a[(i + 1) % 4] -= a[i];
    a[i]++;
    a[3] <<= 1u;
    var heap: Heap;
    heap.size += 2;
    heap.items[i].y += 5;
    heap.items[i] *= 2;
    heap.items[heap.size].x -= a[heap.size];
    heap.items[i][x & 1] ^= 3;
    return vec4i(a[0] + a[1] * 1000, a[2] + a[3] * 1000, heap.items[i].x, heap.items[i].y + heap.items[2].x * 1000);
}

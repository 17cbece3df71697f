// `++` and `--` on variables, components, elements, members and what pointers point to.

struct Counter { up: i32, down: u32 }

fn bump(p: ptr<function, i32>) {
    (*p)++;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var i = x;
    i++;
    i++;
    var u = 0u;
    u--;
    var v = vec2i(x);
    v.x++;
    v[1]--;
    var a = array<i32, 3>(5, 6, 7);
    a[x % 3]++;
    a[0]--;
    var c = Counter(x, 10u);
    c.up--;
    c.down++;
    bump(&i);
    return vec4i(i + c.up * 100, i32(u) + i32(c.down) * 10, v.x + v.y * 100, a[0] + a[1] * 10 + a[2] * 100);
}

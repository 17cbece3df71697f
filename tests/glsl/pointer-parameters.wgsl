// A function writes what its pointers point to: scalars, vectors, structures and arrays of the caller's.

struct State { seed: u32, steps: i32 }

fn next(state: ptr<function, State>) -> u32 {
    (*state).seed = (*state).seed * 747796405u + 2891336453u;
    (*state).steps += 1;
    return (*state).seed >> 16u;
}

fn swap(a: ptr<function, f32>, b: ptr<function, f32>) {
    let t = *a;
    *a = *b;
    *b = t;
}

fn fill(values: ptr<function, array<i32, 4>>, with_: i32) {
    for (var i = 0; i < 4; i++) { (*values)[i] = with_ * i; }
}

fn push(v: ptr<function, vec3f>) {
    (*v).y += 1.0;
    (*v)[2] *= 2.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var state = State(u32(at.x), 0);
    let a = next(&state);
    let b = next(&state);
    var p = floor(at.x);
    var q = floor(at.y);
    swap(&p, &q);
    var values: array<i32, 4>;
    fill(&values, i32(p));
    var v = vec3f(p, q, 3.0);
    push(&v);
    return vec4i(i32(a), i32(b), state.steps + values[3] * 10, i32(v.x + v.y * 100.0 + v.z * 10000.0));
}

// Elements of arrays, columns of matrices and members of structures, passed on by pointer; the index is taken once.

struct Body { place: vec2f, speed: f32 }

fn raise(p: ptr<function, f32>) {
    *p += 1.5;
}

fn turn(v: ptr<function, vec2f>) {
    *v = (*v).yx;
}

fn push(b: ptr<function, Body>) {
    (*b).place.x += (*b).speed;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var i = i32(at.x) % 3;
    var heights = array<f32, 3>(1.0, 2.0, floor(at.y));
    raise(&heights[i]);
    let high = &heights[i];
    i = 0;
    *high *= 2.0;
    var m = mat2x2f(floor(at.x), 2.0, 3.0, 4.0);
    turn(&m[1]);
    var bodies = array<Body, 2>(Body(vec2f(1.0), 2.0), Body(floor(at.xy), 3.0));
    push(&bodies[1]);
    turn(&bodies[1].place);
    raise(&bodies[0].speed);
    return vec4f(heights[0] + heights[1], heights[2] + m[1].x, bodies[1].place) + vec4f(bodies[0].speed);
}

// The same without pointers to parts of variables.

struct Body { place: vec2f, speed: f32 }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let i = i32(at.x) % 3;
    var heights = array<f32, 3>(1.0, 2.0, floor(at.y));
    heights[i] += 1.5;
    heights[i] *= 2.0;
    var m = mat2x2f(floor(at.x), 2.0, 3.0, 4.0);
    m[1] = m[1].yx;
    var bodies = array<Body, 2>(Body(vec2f(1.0), 2.0), Body(floor(at.xy), 3.0));
    bodies[1].place.x += bodies[1].speed;
    bodies[1].place = bodies[1].place.yx;
    bodies[0].speed += 1.5;
    return vec4f(heights[0] + heights[1], heights[2] + m[1].x, bodies[1].place) + vec4f(bodies[0].speed);
}

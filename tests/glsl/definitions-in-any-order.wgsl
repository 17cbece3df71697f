// Functions, constants, structures, aliases and globals are used above where they are declared.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let shape = make(floor(at.xy));
    counter += STEPS;
    return vec4f(area(shape), f32(counter), shape.corner * SCALE);
}

fn area(shape: Shape) -> f32 {
    return edge(shape.corner.x) * edge(shape.corner.y) + shape.list[LAST];
}

fn make(p: Point) -> Shape {
    return Shape(p, Numbers(1.0, 2.0, SCALE));
}

struct Shape { corner: Point, list: Numbers }

const LAST = STEPS - 1;

fn edge(x: f32) -> f32 {
    return abs(x - SCALE);
}

alias Numbers = array<f32, STEPS>;
var<private> counter: i32 = START * 2;
const SCALE: f32 = HALF * 8.0;
alias Point = vec2f;
const STEPS = 3;
const HALF = 0.5;
const START = STEPS + 1;

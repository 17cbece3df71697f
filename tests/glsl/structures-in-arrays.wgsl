// Arrays of structures and structures of arrays, indexed by variables.

struct Lamp { place: vec2f, strength: f32 }
struct Street { lamps: array<Lamp, 3>, lit: array<bool, 3> }

const LAMPS = array<Lamp, 3>(Lamp(vec2f(1.0, 2.0), 3.0), Lamp(vec2f(4.0, 5.0), 6.0), Lamp(vec2f(), 9.0));

fn build(x: f32) -> Street {
    var street: Street;
    for (var i = 0; i < 3; i++) {
        street.lamps[i] = Lamp(vec2f(x, f32(i)), LAMPS[i].strength * x);
        street.lit[i] = i != 1;
    }
    return street;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let street = build(floor(at.x));
    let i = i32(at.y) % 3;
    var lamps = LAMPS;
    lamps[i].place.y += 10.0;
    return vec4f(street.lamps[i].place, street.lamps[2 - i].strength, f32(street.lit[i]) + lamps[1].place.y + LAMPS[i].place.x);
}

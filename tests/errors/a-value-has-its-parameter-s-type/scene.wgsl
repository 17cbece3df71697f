/// How high the sun stands.
#param sun.elevation: f32 = 18.0, range -90 .. 90, unit deg
#param sun.color: vec3f = (1, 1, 1), color
#param sun.count: i32 = 1
#param sun.seed: u32 = 1
#param sun.on: bool = true
#param sun.pair: vec2f = (0, 0), range 0 .. 1
#option terrain.basis = perlin { value, perlin, simplex }
#option march.steps = 8, range 1 .. 16
#option march.soft = true

@fragment fn main() -> @location(0) vec4f { return vec4f(sun.elevation); }

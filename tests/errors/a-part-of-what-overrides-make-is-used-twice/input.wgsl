#param planet.latitude: f32 = 30.0, range -90 .. 90, unit deg
#param planet.longitude: f32 = 10.0, range -180 .. 180, unit deg

fn eastward() -> vec2f {
    let meridian = vec2f(cos(planet.longitude), sin(planet.longitude));
    return vec2f(-meridian.y * meridian.x, meridian.x) * planet.latitude;
}

@fragment
fn main() -> @location(0) vec4f {
    return vec4f(eastward(), 0.0, 1.0);
}

// With and without a value, of every kind, written by functions, fresh for every pixel.

struct Weather { wind: vec2f, wet: bool }

var<private> count: i32 = 3;
var<private> total: f32;
var<private> wind = vec2f(1.0, -2.0);
var<private> weather: Weather = Weather(vec2f(0.5), true);
var<private> turn: mat2x2f = mat2x2f(0.0, 1.0, 1.0, 0.0);
var<private> list: array<u32, 3>;

fn blow(by: f32) {
    wind = turn * wind + by;
    weather.wind.x += by;
    total += wind.x;
    count++;
    list[count % 3] += 2u;
    weather.wet = !weather.wet;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    for (var i = 0; i < i32(at.x) % 7; i++) { blow(floor(at.y)); }
    return vec4f(total, wind.y + weather.wind.x, f32(count), f32(list[0] + list[1] * 100u) + f32(weather.wet));
}

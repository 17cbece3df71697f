// What there is.

/// Rain.
#option inspect.has_rain = true
/// Land.
#option inspect.has_land = true
/// Snow.
#option inspect.has_snow = true

fn main_image(p: vec2f) -> vec4f {
    var seen = vec4f(0.0);
#if inspect.has_rain
    seen.x = 1.0;
#endif
#if inspect.has_land
    seen.y = 1.0;
#endif
#if inspect.has_snow
    seen.z = 1.0;
#endif
    return seen;
}

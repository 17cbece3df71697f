#slot noise
#slot noise: vec2f
#slot noise: fn(vec2f) -> f32
#slot noise: fn(p: vec2f -> f32
#slot noise: fn(p: vec2f) ->

// Where the water stands.

/// Height of the water's surface above sea level, waves averaged out.
#param water.level: f32 = 0.0, range -1000 .. 9000, unit m

#option noise.octaves = 4, range 1 .. 8
#param noise.strength: f32 = 0.5

fn inner() -> f32 {
    return noise.strength;
}

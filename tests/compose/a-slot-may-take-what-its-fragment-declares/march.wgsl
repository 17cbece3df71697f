struct Sample {
    t: f32,
}

alias Real = f32;

#slot probe: fn(s: Sample, w: array<Real, 2>) -> f32

fn run() -> f32 {
    return probe(Sample(1.0), array(1.0, 2.0));
}

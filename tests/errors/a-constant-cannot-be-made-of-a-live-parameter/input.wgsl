#param sun.power: f32 = 1.0

const TWICE = 2.0 * sun.power;

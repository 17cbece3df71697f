// Built-ins, comparisons and logic that are evaluated before the shader runs.

const ROOT = sqrt(16.0);
const LOW = min(3, 5) + max(1u, 2);
const CHOSEN = select(1.0, 2.0, ROOT > 3.0);
const NORTH = normalize(vec2f(0.0, 5.0));
const BITS = countOneBits(0xFFu) + (1u << 5u);
const WORD = (0xABCDu >> 4u) & 0xFFu;
const HALF = abs(-7.5) / 3.0;
const MIXED = (0.25 * vec3f(2.0, 4.0, 8.0) + 1).zyx;
const PART = MIXED.x + vec4f(1.0, 2.0, 3.0, 4.0)[2];
const FLAGS = !(ROOT == 4.0) || any(vec2<bool>(false, true));

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    return vec4f(
        ROOT + f32(LOW) + floor(at.x),
        CHOSEN + NORTH.y * 10.0,
        f32(BITS + WORD) + HALF,
        PART + MIXED.y * 100.0 + select(0.0, 1000.0, FLAGS),
    );
}

// Where along a ray the air is looked at.

#include <math/gauss_legendre.wgsl>
#include <quality.wgsl>

/// Where the air is looked at along each unbroken part of a ray; rounded up to 2, 4, 6, 8, 12, 16, 24, 32 or 64. Eight
/// hold a sky by day within 1 %; 12 one at twilight, 16 one from space. Up to twelve, `quality` = `low` makes do with fewer.
#option sky.samples = 8, range 2 .. 64

#if sky.samples <= 2
const SKY_NODES: i32 = 2;
const SKY_RULE = GAUSS_LEGENDRE_2;
#elif sky.samples <= 4 || quality == low && sky.samples <= 8
const SKY_NODES: i32 = 4;
const SKY_RULE = GAUSS_LEGENDRE_4;
#elif sky.samples <= 6
const SKY_NODES: i32 = 6;
const SKY_RULE = GAUSS_LEGENDRE_6;
#elif sky.samples <= 8 || quality == low && sky.samples <= 12
const SKY_NODES: i32 = 8;
const SKY_RULE = GAUSS_LEGENDRE_8;
#elif sky.samples <= 12
const SKY_NODES: i32 = 12;
const SKY_RULE = GAUSS_LEGENDRE_12;
#elif sky.samples <= 16
const SKY_NODES: i32 = 16;
const SKY_RULE = GAUSS_LEGENDRE_16;
#elif sky.samples <= 24
const SKY_NODES: i32 = 24;
const SKY_RULE = GAUSS_LEGENDRE_24;
#elif sky.samples <= 32
const SKY_NODES: i32 = 32;
const SKY_RULE = GAUSS_LEGENDRE_32;
#else
const SKY_NODES: i32 = 64;
const SKY_RULE = GAUSS_LEGENDRE_64;
#endif

/// The nodes of a short and clear way, where 4 are as good as many: of up to 60 km through haze of optical depth 1.
const SKY_NODES_NEAR: i32 = min(SKY_NODES, 4);

/// Node `i` (0 .. `count` - 1) along a part of a ray, as a fraction of its length, and the weight of that node; the
/// weights sum to 1. `count` is `SKY_NODES` or `SKY_NODES_NEAR`.
///
/// Gauss–Legendre in s, with the fraction s² (3 + s) / 4: the nodes crowd at the start, where the air is dense or not
/// yet hidden by air before it; with `from_end` = 1 at the end. Over a clear sky from the ground, 8 nodes err by .4 %
/// at most, where equal steps err by 22 %.
fn sky_node(i: i32, count: i32, from_end: f32) -> vec2f {
    let late = 2 * i >= count;
    let half = select(i, count - 1 - i, late);
    var rule = SKY_RULE[half];
    if count != SKY_NODES {
        rule = GAUSS_LEGENDRE_4[half];
    }
    let s = select(rule.x, 1.0 - rule.x, late);
    let u = 1.0 - s;
    let from_start = vec2f(0.25 * s * s * (3.0 + s), 0.75 * s * (2.0 + s));
    let to_end = vec2f(1.0 - 0.25 * u * u * (3.0 + u), 0.75 * u * (2.0 + u));
    let node = mix(from_start, to_end, from_end);
    return vec2f(node.x, rule.y * node.y);
}

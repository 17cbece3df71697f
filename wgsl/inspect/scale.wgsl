// A scale of colours for numbers, and its legend at the right edge of the picture.

#include <color/heat.wgsl>
#include <frame.wgsl>
#include <inspect/digits.wgsl>

/// Which numbers the colours stand for.
struct Scale {
    /// At the dark end; above 0 where the scale is logarithmic.
    low: f32,
    /// At the light end, above `low`.
    high: f32,
    /// Whether equal factors look equal, and not equal differences.
    logarithmic: bool,
}

/// Where nothing is to be measured: linear sRGB.
const SCALE_NOTHING: vec3f = vec3f(0.05, 0.055, 0.06);

/// Where `value` lies on `scale`: 0 at its low end, 1 at its high end.
fn scale_part(scale: Scale, value: f32) -> f32 {
    if scale.logarithmic {
        return log2(max(value, 1e-30) / scale.low) / log2(scale.high / scale.low);
    }
    return (value - scale.low) / (scale.high - scale.low);
}

/// The colour of `value`, linear sRGB; beyond the ends it is the end's.
fn scale_color(scale: Scale, value: f32) -> vec3f {
    return heat_color(scale_part(scale, value));
}

/// How many pixels wide a cell of a digit is.
fn scale_cell() -> f32 {
    return max(round(min(frame.resolution.y, 0.5625 * frame.resolution.x) / 170.0), 1.0);
}

/// `color`, linear sRGB, with the legend of `scale` drawn over it.
fn scale_legend(scale: Scale, color: vec3f, frag_coord: vec2f) -> vec3f {
    let cell = scale_cell();
    let bar = vec2f(frame.resolution.x - 10.0 * cell, frame.resolution.x - 4.0 * cell);
    let foot = floor(0.15 * frame.resolution.y);
    let head = floor(0.85 * frame.resolution.y);
    let panel = vec2f(bar.x - 27.0 * cell, foot - 6.0 * cell);
    if frag_coord.x < panel.x || frag_coord.y < panel.y || frag_coord.y > head + 6.0 * cell {
        return color;
    }
    let part = (frag_coord.y - foot) / (head - foot);
    if frag_coord.x >= bar.x && frag_coord.x < bar.y && part >= 0.0 && part <= 1.0 {
        return heat_color(part);
    }
    // The nearest tick: a quarter of the scale, or a power of ten.
    var tick = clamp(round(4.0 * part), 0.0, 4.0) / 4.0;
    var value = mix(scale.low, scale.high, tick);
    if scale.logarithmic {
        value = pow(10.0, round(0.30103 * (log2(scale.low) + part * log2(scale.high / scale.low))));
        tick = scale_part(scale, value);
    }
    let dimmed = 0.25 * color;
    if tick < -0.001 || tick > 1.001 {
        return dimmed;
    }
    let middle = floor(mix(foot, head, tick));
    let from_tick = vec2f(bar.x - 3.0 * cell - frag_coord.x, frag_coord.y - middle + 2.5 * cell) / cell;
    let is_mark = abs(frag_coord.y - middle) < 0.5 * cell && frag_coord.x >= bar.x - 2.0 * cell && frag_coord.x < bar.x;
    let is_inked = is_mark || number_inked(vec2i(floor(from_tick)), value);
    return select(dimmed, vec3f(0.9), is_inked);
}

/// 1, 2 or 5 times a power of ten: the largest that goes into `span` > 0 at least `count` times.
fn scale_step(span: f32, count: f32) -> f32 {
    let raw = max(span / count, 1e-6);
    let power = pow(10.0, floor(log2(raw) * 0.30103 + 1e-4));
    let times = raw / power;
    return power * select(select(1.0, 2.0, times >= 2.0), 5.0, times >= 5.0);
}

// How much of a distant light is seen over a heightfield.

/// Height of the ground (m) at a place of the map (m); details much smaller than `footprint` (m) may be left out.
#slot height: fn(p: vec2f, footprint: f32) -> f32

const GOLDEN_PART: f32 = 0.618034;

/// Part of a distant light that is seen from `origin`, 0 (umbra) .. 1.
///
/// The least (height above ground) / (distance) along the ray to it, held against the light's size (Quilez, "Soft
/// shadows in raymarched SDFs", 2010): `spread` is its angular radius (rad, > 0). `start` and `far` (m) are where to
/// begin and to give up, `ceiling` (m) a height that the ground nowhere exceeds, `max_steps` how often to look: steps
/// grow with distance, and so does the size of the details looked at. The least is then searched for between the looks
/// (golden section, half as many looks, 8 at most), or the shadows of crests would have teeth.
fn shadow_soft(
    origin: vec3f,
    to_light: vec3f,
    spread: f32,
    start: f32,
    far: f32,
    ceiling: f32,
    footprint: f32,
    max_steps: i32,
) -> f32 {
    if to_light.y <= -spread {
        return 0.0;
    }
    let first = max(start, 1e-3);
    var end = far;
    if to_light.y > 1e-6 {
        end = min(far, (ceiling - origin.y) / to_light.y);
    }
    // The looks, each farther than the last, and the search share one call of `height`: what is costly is compiled
    // once.
    let growth = pow(max(far / first, 2.0), 1.0 / f32(max(max_steps, 1))); // as many looks near as far
    var least = 1e9;
    var low = first; // the least lies between these two
    var high = first;
    var newest = false;
    var before = first;
    var t = first;
    var looks = 0;
    var a = 0.0;
    var b = 0.0;
    var at_a = 0.0;
    var at_b = 0.0;
    let searches = min(8, max_steps / 2);
    for (var i = 0; i < max_steps + searches; i++) {
        if looks == 0 && (i >= max_steps || t > end || least < -1.0) {
            if newest {
                high = min(t, end);
            }
            if least < -1.0 || high <= low {
                break;
            }
            a = high - GOLDEN_PART * (high - low);
            b = low + GOLDEN_PART * (high - low);
            looks = 1;
        }
        if looks > searches {
            break;
        }
        if looks == 1 {
            t = a;
        } else if looks == 2 {
            t = b;
        } else if looks > 2 {
            if at_a < at_b {
                high = b;
                b = a;
                at_b = at_a;
                a = high - GOLDEN_PART * (high - low);
                t = a;
            } else {
                low = a;
                a = b;
                at_a = at_b;
                b = low + GOLDEN_PART * (high - low);
                t = b;
            }
        }
        let p = origin + t * to_light;
        let above = p.y - height(p.xz, max(footprint, 0.01 * t)); // the farther, the coarser the ground
        let here = above / (t * spread);
        if looks > 0 {
            at_a = select(at_a, here, t == a);
            at_b = select(at_b, here, t == b);
            least = min(least, here);
            looks++;
        } else {
            if newest {
                high = t;
            }
            newest = here < least;
            if newest {
                least = here;
                low = before;
                high = t;
            }
            before = t;
            t = max(t * growth, t + 0.4 * above);
        }
    }
    return smoothstep(-1.0, 1.0, least);
}

/// Whether `origin` sees a distant light: 1 or 0. Steps are `relax` times the height above ground and no shorter than
/// `shortest` (m): what stands between two of them is missed; `march/heightfield_bounded.wgsl` misses nothing.
fn shadow_hard(
    origin: vec3f,
    to_light: vec3f,
    start: f32,
    far: f32,
    ceiling: f32,
    footprint: f32,
    relax: f32,
    shortest: f32,
    max_steps: i32,
) -> f32 {
    var end = far;
    if to_light.y > 1e-6 {
        end = min(far, (ceiling - origin.y) / to_light.y);
    }
    var t = start;
    for (var i = 0; i < max_steps; i++) {
        if t > end {
            break;
        }
        let p = origin + t * to_light;
        let above = p.y - height(p.xz, max(footprint, 0.01 * t));
        if above < 0.0 {
            return 0.0;
        }
        t += max(relax * above, shortest);
    }
    return 1.0;
}

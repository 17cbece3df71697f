// From scene light to what a display can show: tone maps, linear light to linear light.
//
// All keep greys grey, go up wherever the light of a grey does, and are finite for light from 0 to 1e6 and beyond.

/// 1 - e^(-x) in each channel: 0 .. 1 for light >= 0, never clips, slope 1 in the dark; .18 becomes .165.
fn tone_map_exponential(radiance: vec3f) -> vec3f {
    return 1.0 - exp(-max(radiance, vec3f(0.0)));
}

/// x / (1 + x) in each channel (Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", eq. 3): 0 .. 1,
/// slope 1 in the dark; .18 becomes .153, and 1 only half of white.
fn tone_map_reinhard(radiance: vec3f) -> vec3f {
    let x = clamp(radiance, vec3f(0.0), vec3f(1e12));
    return x / (1.0 + x);
}

/// x (1 + x / white²) / (1 + x) in each channel (Reinhard et al. 2002, eq. 4): 0 .. 1, slope 1 in the dark, and what is as
/// light as `white` > 0 or lighter becomes 1. With `white` 4, .18 becomes .154.
fn tone_map_reinhard_white(radiance: vec3f, white: f32) -> vec3f {
    let x = clamp(radiance, vec3f(0.0), vec3f(white));
    return x * (1.0 + x / (white * white)) / (1.0 + x);
}

/// The look of film by the Academy's reference transforms (ACES 1.0 RRT and ODT for sRGB), as fitted by Stephen Hill (2016,
/// in MJP's BakingLab): 0 .. 1.
///
/// Darker than the others: .18 becomes .106 (hosts that want mid grey kept expose by +.7 EV). Black up to .0033, where the
/// slope is .13. Bright colours bleach.
fn tone_map_aces(radiance: vec3f) -> vec3f {
    let to_film = mat3x3f(
        vec3f(0.59719, 0.07600, 0.02840),
        vec3f(0.35458, 0.90834, 0.13383),
        vec3f(0.04823, 0.01566, 0.83777),
    );
    let to_display = mat3x3f(
        vec3f(1.60475, -0.10208, -0.00327),
        vec3f(-0.53108, 1.10813, -0.07276),
        vec3f(-0.07367, -0.00605, 1.07603),
    );
    let x = to_film * clamp(radiance, vec3f(0.0), vec3f(1e6));
    let curve = (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081);
    return saturate(to_display * curve);
}

/// AgX (Troy Sobotka 2022, as Blender 4 has it by Eary Chow): 0 .. 1, and .18 stays .18.
///
/// A sigmoid over the logarithm of the light, from 10 EV below .18 (black, slope 0) to 6.5 EV above it (white), among
/// primaries drawn together so that bright colours fade to white without a turn of hue. Punchless by design.
fn tone_map_agx(radiance: vec3f) -> vec3f {
    // sRGB to Rec. 2020 and its primaries drawn in; and back from ones that are drawn in less.
    let inset = mat3x3f(
        vec3f(0.5448147465, 0.1404169485, 0.0888104196),
        vec3f(0.3737873984, 0.7541375546, 0.1788717564),
        vec3f(0.0813978551, 0.1054454969, 0.7323178240),
    );
    let outset = mat3x3f(
        vec3f(1.9648874117, -0.2993133649, -0.1643527425),
        vec3f(-0.8559884957, 1.3263979646, -0.2381839694),
        vec3f(-0.1088989160, -0.0270845997, 1.4025367119),
    );
    let x = inset * clamp(radiance, vec3f(0.0), vec3f(1e6));
    let stops = (log2(max(x, vec3f(1e-9)) / 0.18) + 10.0) / 16.5;
    let past = clamp(stops, vec3f(0.0), vec3f(1.0)) - 0.60606061; // .18
    // Slope 2.4 in the middle; toe and shoulder are u / (1 + u^1.5)^(2/3), scaled to end at 0 and 1.
    let scale = select(vec3f(0.71519829), vec3f(0.56567561), past < vec3f(0.0));
    let u = 2.4 * abs(past) / scale;
    let bent = u / pow(1.0 + u * sqrt(u), vec3f(2.0 / 3.0));
    let shown = 0.48943709 + sign(past) * scale * bent; // .48943709^2.4 = .18
    return saturate(outset * pow(max(shown, vec3f(0.0)), vec3f(2.4)));
}

/// Khronos PBR Neutral (Khronos Group 2024, "PBR Neutral Tone Mapper"): 0 .. 1.
///
/// Colours stay as they are, less the .04 that every surface mirrors (less than that below .08: .18 becomes .14, and black
/// stays black with slope 0), as long as none of their channels exceeds .8; lighter ones are pressed together and fade to
/// white.
fn tone_map_neutral(radiance: vec3f) -> vec3f {
    let x = clamp(radiance, vec3f(0.0), vec3f(1e6));
    let least = min(x.x, min(x.y, x.z));
    let mirrored = select(0.04, least - 6.25 * least * least, least < 0.08);
    let color = x - mirrored;
    let peak = max(color.x, max(color.y, color.z));
    if peak <= 0.76 {
        return color;
    }
    let pressed = 1.0 - 0.0576 / (peak - 0.52);
    let kept = 1.0 / (0.15 * (peak - pressed) + 1.0);
    return mix(vec3f(pressed), color * (pressed / peak), kept);
}

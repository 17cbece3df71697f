// Phase functions: which part of the light that is scattered goes on into which direction (1 / sr).
//
// `cos_theta` is the cosine of the angle by which the light turns: 1 straight on (the eye looks at the sun), -1 back.
// Each integrates to 1 over the sphere; "mean cosine" is the integral of cos_theta times the function. An anisotropy `g`
// is taken as if it was within -.9999 .. .9999: there is no NaN and no infinity at its ends.

/// Alike in all directions: 1 / 4 pi. Mean cosine 0.
fn phase_isotropic() -> f32 {
    return 0.07957747;
}

/// Rayleigh's: of molecules, much smaller than the wavelength. .0597 .. .1194; mean cosine 0.
fn phase_rayleigh(cos_theta: f32) -> f32 {
    return 0.059683103 * (1.0 + cos_theta * cos_theta);
}

/// Henyey & Greenstein's (1941): one lobe, forward for `g` > 0, back for `g` < 0. Mean cosine `g`.
///
/// From (1 - |g|) / (1 + |g|)^2 to (1 + |g|) / (1 - |g|)^2, over 4 pi; relative error below 1e-5 also in the peak.
fn phase_henyey_greenstein(cos_theta: f32, g: f32) -> f32 {
    let strength = min(abs(g), 0.9999);
    let narrow = 1.0 - strength;
    let off = max(1.0 - select(-cos_theta, cos_theta, g > 0.0), 0.0); // 1 - cos of the angle to the lobe's axis
    // 1 + g^2 - 2 g cos_theta, as a sum of what is positive: the peak keeps its digits.
    let distance2 = narrow * narrow + 2.0 * strength * off;
    return 0.07957747 * narrow * (1.0 + strength) / (distance2 * sqrt(distance2));
}

/// Two lobes of Henyey & Greenstein's: `forward_share` (0 .. 1) of `g_forward`, the rest of `g_back` (< 0 for a lobe
/// toward the sun). Mean cosine `forward_share` g_forward + (1 - `forward_share`) g_back.
fn phase_two_lobe(cos_theta: f32, g_forward: f32, g_back: f32, forward_share: f32) -> f32 {
    let forward = phase_henyey_greenstein(cos_theta, g_forward);
    let back = phase_henyey_greenstein(cos_theta, g_back);
    return mix(back, forward, forward_share);
}

/// Cornette & Shanks's (1992): Henyey & Greenstein's that becomes Rayleigh's for `g` = 0; of haze.
///
/// Mean cosine 3 g (4 + g^2) / (5 (2 + g^2)): for `g` = .8 it is .84364.
fn phase_cornette_shanks(cos_theta: f32, g: f32) -> f32 {
    return phase_draine(cos_theta, g, 1.0);
}

/// Schlick's (Blasi, Le Saëc & Schlick 1993): like Henyey & Greenstein's of the same `g`, without a root.
///
/// k = 1.55 g - .55 g^3, held within -.999 .. .999 (reached at |g| = .9293: it would pass 1 at .938). Mean cosine
/// 1 / k - (1 - k^2) / (2 k^2) ln((1 + k) / (1 - k)), 0 for k = 0: for `g` = .5 it is .5320, for .8 it is .8726.
fn phase_schlick(cos_theta: f32, g: f32) -> f32 {
    let strength = min(abs(g), 1.0);
    let narrow = max((1.0 - strength) * (1.0 - 0.55 * strength * (1.0 + strength)), 1e-3); // 1 - |k|
    let off = max(1.0 - select(-cos_theta, cos_theta, g > 0.0), 0.0);
    let distance = narrow + (1.0 - narrow) * off;
    return 0.07957747 * narrow * (2.0 - narrow) / (distance * distance);
}

/// Draine's (2003): Henyey & Greenstein's for `alpha` = 0, Cornette & Shanks's for 1, more light to the front and to the
/// back and less to the sides for more.
///
/// `alpha` >= 0. Mean cosine g (1 + alpha (3 + 2 g^2) / 5) / (1 + alpha (1 + 2 g^2) / 3).
fn phase_draine(cos_theta: f32, g: f32, alpha: f32) -> f32 {
    let g2 = min(g * g, 0.9998);
    let sides = (1.0 + alpha * cos_theta * cos_theta) / (1.0 + alpha * (1.0 + 2.0 * g2) / 3.0);
    return phase_henyey_greenstein(cos_theta, g) * sides;
}

/// That of cloud droplets (Mie's) as one Henyey & Greenstein and one Draine lobe (Jendersie & d'Eon 2023).
///
/// `droplet_diameter`: 5 .. 50 um, the range of the fit for clouds and fog; held within it. With the fit's numbers as in
/// `phase_hg_draine_lobes`, the mean cosine is (1 - w) g_hg + w times that of the Draine lobe: .8434 (5 um) to .8912
/// (50 um). The peak is up to 18,700 / sr high; relative error below 3e-5.
fn phase_hg_draine(cos_theta: f32, droplet_diameter: f32) -> f32 {
    let lobes = phase_hg_draine_lobes(droplet_diameter);
    let narrow = phase_henyey_greenstein(cos_theta, lobes.x);
    return mix(narrow, phase_draine(cos_theta, lobes.y, lobes.z), lobes.w);
}

/// The numbers of `phase_hg_draine`: g of the Henyey & Greenstein lobe, then g, alpha and share w of the Draine lobe.
fn phase_hg_draine_lobes(droplet_diameter: f32) -> vec4f {
    let d = clamp(droplet_diameter, 5.0, 50.0);
    return vec4f(
        exp(-0.0990567 / (d - 1.67154)),
        exp(-2.20679 / (d + 3.91029) - 0.428934),
        exp(3.62489 - 8.29288 / (d + 5.52825)),
        exp(-0.599085 / (d - 0.641583) - 0.665888),
    );
}

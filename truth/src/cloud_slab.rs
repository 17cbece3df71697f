//! Light in a homogeneous, plane-parallel cloud, all orders, by following photons.

use std::f64::consts::PI;

use crate::phase::henyey_greenstein;

/// What the cloud is made of: two lobes of Henyey & Greenstein's.
#[derive(Debug, Clone, Copy)]
pub struct Medium {
    /// Anisotropy of the forward lobe.
    pub g_forward: f64,
    /// Anisotropy of the back lobe.
    pub g_back: f64,
    /// Part of the scattered light that the forward lobe gets.
    pub forward_share: f64,
    /// Part of the light that is scattered and not absorbed.
    pub albedo: f64,
}

impl Medium {
    /// The phase function (1 / sr).
    #[must_use]
    pub fn phase(&self, cosine: f64) -> f64 {
        let back = henyey_greenstein(cosine, self.g_back);
        self.forward_share * henyey_greenstein(cosine, self.g_forward) + (1.0 - self.forward_share) * back
    }
}

/// Where an eye looks from, and to where.
#[derive(Debug, Clone, Copy)]
pub struct View {
    /// Angle between the ray and the vertical, below 90 (degrees).
    pub zenith: f64,
    /// Azimuth of the ray that the eye looks along, from the sun's: from below, 0 looks toward the sun; from above, 180
    /// has the sun behind the eye (degrees).
    pub azimuth: f64,
    /// The eye is above the cloud and looks down, or below it and looks up.
    pub above: bool,
}

impl View {
    /// Unit vector along which the light travels that the eye sees; y is up, the sun's azimuth is +x.
    fn light(&self) -> [f64; 3] {
        let (zenith, azimuth) = (self.zenith.to_radians(), self.azimuth.to_radians());
        let down = if self.above { 1.0 } else { -1.0 };
        [-zenith.sin() * azimuth.cos(), down * zenith.cos(), -zenith.sin() * azimuth.sin()]
    }

    /// Cosine of the angle between the ray and the direction to a sun at `sun_zenith` (degrees).
    #[must_use]
    pub fn cosine_to_sun(&self, sun_zenith: f64) -> f64 {
        -dot(self.light(), to_sun(sun_zenith))
    }
}

/// What leaves the slab, for a sun of irradiance 1 on a surface that faces it; black above and below.
#[derive(Debug, Clone)]
pub struct Leaving {
    /// For each view: radiance of all orders, of the first order, and the standard error of the former.
    pub views: Vec<[f64; 3]>,
    /// Flux through the top, and through the bottom with the sun's direct light (per area of the slab).
    pub flux: [f64; 2],
}

/// Radiance of the first order, in closed form.
#[must_use]
pub fn first_order(medium: &Medium, tau: f64, sun_zenith: f64, view: &View) -> f64 {
    let (sun, eye) = (sun_zenith.to_radians().cos(), view.zenith.to_radians().cos());
    let path = if view.above {
        (1.0 - (-tau * (1.0 / sun + 1.0 / eye)).exp()) * sun / (sun + eye)
    } else if (sun - eye).abs() < 1e-9 {
        tau / sun * (-tau / sun).exp()
    } else {
        ((-tau / sun).exp() - (-tau / eye).exp()) * sun / (sun - eye)
    };
    medium.albedo * medium.phase(view.cosine_to_sun(sun_zenith)) * path
}

/// Follows so many photons through a slab of optical thickness `tau`. Each scattering is also looked at from every view;
/// the first order, known exactly, is taken from [`first_order`].
#[must_use]
pub fn follow(
    medium: &Medium,
    tau: f64,
    sun_zenith: f64,
    views: &[View],
    photons: u32,
    seed: u64,
) -> Leaving {
    let mut random = Stream(seed);
    let sun = to_sun(sun_zenith);
    let toward: Vec<[f64; 3]> = views.iter().map(View::light).collect();
    let batches = 50;
    let in_batch = photons / batches;
    let share = sun[1] / f64::from(in_batch);
    let mut sums = vec![[0.0; 2]; views.len()];
    let mut flux = [0.0; 2];
    for _ in 0..batches {
        let mut batch = vec![0.0; views.len()];
        for _ in 0..in_batch {
            let mut direction = sun.map(|x| -x);
            let (mut depth, mut weight, mut order) = (0.0, 1.0, 0);
            loop {
                depth += direction[1] * random.unit().ln(); // down is more depth
                if !(0.0..=tau).contains(&depth) {
                    flux[usize::from(depth > tau)] += weight * share / f64::from(batches);
                    break;
                }
                order += 1;
                weight *= medium.albedo;
                if weight < 0.01 {
                    if random.unit() < 0.5 {
                        break;
                    }
                    weight *= 2.0;
                }
                if order > 1 {
                    for (sum, out) in batch.iter_mut().zip(&toward) {
                        let way = if out[1] > 0.0 { depth } else { tau - depth } / out[1].abs();
                        *sum += weight * medium.phase(dot(direction, *out)) * (-way).exp() / out[1].abs();
                    }
                }
                direction = turn(direction, medium, &mut random);
            }
        }
        for (sum, batch) in sums.iter_mut().zip(&batch) {
            sum[0] += batch * share;
            sum[1] += (batch * share).powi(2);
        }
    }
    let n = f64::from(batches);
    let finish = |(view, sum): (&View, &[f64; 2])| {
        let mean = sum[0] / n;
        let first = first_order(medium, tau, sun_zenith, view);
        [mean + first, first, ((sum[1] / n - mean * mean).max(0.0) / (n - 1.0)).sqrt()]
    };
    Leaving { views: views.iter().zip(&sums).map(finish).collect(), flux }
}

fn to_sun(zenith: f64) -> [f64; 3] {
    [zenith.to_radians().sin(), zenith.to_radians().cos(), 0.0]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Another direction, drawn from the phase function.
fn turn(along: [f64; 3], medium: &Medium, random: &mut Stream) -> [f64; 3] {
    let g = if random.unit() < medium.forward_share { medium.g_forward } else { medium.g_back };
    let part = random.unit();
    let cosine = if g.abs() < 1e-3 {
        2.0 * part - 1.0
    } else {
        let ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * part);
        ((1.0 + g * g - ratio * ratio) / (2.0 * g)).clamp(-1.0, 1.0)
    };
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let around = 2.0 * PI * random.unit();
    // Two unit vectors across: from the axis that is least along.
    let helper = if along[1].abs() < 0.7 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
    let across = unit(cross(along, helper));
    let other = cross(along, across);
    let (c, s) = (sine * around.cos(), sine * around.sin());
    unit(std::array::from_fn(|i| cosine * along[i] + c * across[i] + s * other[i]))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// Random numbers of 64 bits (Steele, Lea & Flood 2014).
struct Stream(u64);

impl Stream {
    /// A number in 0 .. 1, never 0.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 * (0.5_f64).powi(53) + (0.5_f64).powi(54)
    }
}

//! All orders of scattering in a planet's air, by tracing paths from the eye: one colour at a time, in f64.
//!
//! A path takes its free flights by null collisions, asks at each vertex for the sun (its transmittance from a table that
//! was summed along rays), and starts anew from the ground, which is Lambert's. Lengths are metres, the sun's irradiance 1.

use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];

/// Air of one colour around one planet.
#[derive(Debug, Clone, Copy)]
pub struct Air {
    /// Radius (m) of the planet.
    pub ground: f64,
    /// Height (m) at which the air ends.
    pub height: f64,
    /// Scattering (1/m) by molecules at sea level, and the height over which they thin out.
    pub rayleigh: [f64; 2],
    /// Scattering and absorption (1/m) by aerosols at sea level, and the height over which they thin out.
    pub mie: [f64; 3],
    /// Their asymmetry: the parameter of Cornette and Shanks's phase function.
    pub asymmetry: f64,
    /// Absorption (1/m) by ozone at its densest, the height of that, and half the width of the layer.
    pub ozone: [f64; 3],
    /// Albedo of the ground.
    pub albedo: f64,
}

impl Air {
    /// Earth's in red (0), green (1) or blue (2), over ground of albedo .3.
    #[must_use]
    pub fn earth(channel: usize) -> Self {
        Self {
            ground: 6_360e3,
            height: 100e3,
            rayleigh: [[5.802e-6, 13.558e-6, 33.1e-6][channel], 8e3],
            mie: [3.996e-6, 0.444e-6, 1.2e3],
            asymmetry: 0.8,
            ozone: [[0.650e-6, 1.881e-6, 0.085e-6][channel], 25e3, 15e3],
            albedo: 0.3,
        }
    }

    /// Mars's, over ground of albedo .3.
    #[must_use]
    pub fn mars(channel: usize) -> Self {
        Self {
            ground: 3_389.5e3,
            height: 120e3,
            rayleigh: [[19.918e-6, 13.57e-6, 5.75e-6][channel], 10.43e3],
            mie: [53.618e-6, 0.553e-6, 3.095e3],
            asymmetry: 0.85,
            ozone: [0.0, 25e3, 15e3],
            albedo: 0.3,
        }
    }

    /// Scattering by molecules, by aerosols, and extinction (1/m) at `height`.
    fn at(&self, height: f64) -> [f64; 3] {
        let height = height.max(0.0);
        let molecules = self.rayleigh[0] * (-height / self.rayleigh[1]).exp();
        let aerosols = (-height / self.mie[2]).exp();
        let tent = (1.0 - (height - self.ozone[1]).abs() / self.ozone[2]).max(0.0);
        let scattered = self.mie[0] * aerosols;
        [molecules, scattered, molecules + scattered + self.mie[1] * aerosols + self.ozone[0] * tent]
    }

    fn rayleigh_phase(cosine: f64) -> f64 {
        3.0 / (16.0 * PI) * (1.0 + cosine * cosine)
    }

    fn mie_phase(&self, cosine: f64) -> f64 {
        let g = self.asymmetry;
        let shape = (1.0 - g * g) * (1.0 + cosine * cosine) / (2.0 + g * g);
        3.0 / (8.0 * PI) * shape / (1.0 + g * g - 2.0 * g * cosine).powf(1.5)
    }

    /// Where the ray leaves the air or meets the ground, and whether it is the ground.
    fn reach(&self, from: Vector, toward: Vector) -> (f64, bool) {
        let along = dot(from, toward);
        let squared = dot(from, from);
        let ground = along * along - squared + self.ground * self.ground;
        if along < 0.0 && ground >= 0.0 {
            return ((-along - ground.sqrt()).max(0.0), true);
        }
        let top = self.ground + self.height;
        (-along + (along * along - squared + top * top).max(0.0).sqrt(), false)
    }

    fn height_of(&self, point: Vector) -> f64 {
        dot(point, point).sqrt() - self.ground
    }
}

/// Streams of f64.
#[derive(Debug, Clone)]
struct Stream(u64);

impl Stream {
    fn new(seed: u64) -> Self {
        let mut stream = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0xD1B5_4A32_D192_ED03);
        stream.next();
        stream
    }

    /// `SplitMix64`, in `0 .. 1`.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn along(from: Vector, toward: Vector, distance: f64) -> Vector {
    std::array::from_fn(|i| from[i] + distance * toward[i])
}

fn unit(vector: Vector) -> Vector {
    let length = dot(vector, vector).sqrt();
    vector.map(|x| x / length)
}

/// The direction at `cosine` from the unit `axis`, turned by `turn` (rad) around it.
fn around(axis: Vector, cosine: f64, turn: f64) -> Vector {
    let side = if axis[1].abs() < 0.9 { [-axis[2], 0.0, axis[0]] } else { [0.0, axis[2], -axis[1]] };
    let side = unit(side);
    let other = [
        axis[1] * side[2] - axis[2] * side[1],
        axis[2] * side[0] - axis[0] * side[2],
        axis[0] * side[1] - axis[1] * side[0],
    ];
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (s, c) = turn.sin_cos();
    unit(std::array::from_fn(|i| cosine * axis[i] + sine * (c * side[i] + s * other[i])))
}

/// What came out: a mean, and how sure it is.
#[derive(Debug, Clone, Copy)]
pub struct Estimate {
    /// Light of the first order alone, summed along the ray.
    pub first: f64,
    /// All orders, and the ground at the ray's end.
    pub all: f64,
    /// Standard error of `all`.
    pub error: f64,
}

/// Air under a sun: paths through it.
#[derive(Debug)]
pub struct Paths {
    air: Air,
    sunlight: Vec<f64>,
}

const ROWS: usize = 256;
const COLUMNS: usize = 1024;

impl Paths {
    /// Sums the transmittance toward the sun from everywhere.
    #[must_use]
    pub fn new(air: Air) -> Self {
        let mut sunlight = Vec::with_capacity(ROWS * COLUMNS);
        let top = air.ground + air.height;
        let horizon = (top * top - air.ground * air.ground).sqrt();
        for row in 0..ROWS {
            let rho = horizon * row as f64 / (ROWS - 1) as f64;
            let radius = rho.hypot(air.ground);
            let (near, far) = (top - radius, rho + horizon);
            for column in 0..COLUMNS {
                let length = near + (far - near) * column as f64 / (COLUMNS - 1) as f64;
                let mu = ((top * top - radius * radius - length * length) / (2.0 * radius * length.max(1e-6)))
                    .clamp(-1.0, 1.0);
                // Twice Simpson's rule in s, the way being (3s² - 2s³) of the length: dense at both ends.
                let steps = 48;
                let mut depth = 0.0;
                for step in 0..=steps {
                    let s = f64::from(step) / f64::from(steps);
                    let way = length * s * s * (3.0 - 2.0 * s);
                    let height = (radius * radius + way * way + 2.0 * radius * mu * way).sqrt() - air.ground;
                    let weight = if step == 0 || step == steps { 1.0 } else { 2.0 + 2.0 * f64::from(step % 2) };
                    depth += weight * air.at(height)[2] * length * 6.0 * s * (1.0 - s);
                }
                sunlight.push(depth / (3.0 * f64::from(steps)));
            }
        }
        Self { air, sunlight }
    }

    /// Part of the sunlight that gets to `radius` (m) from a zenith distance whose cosine is `mu`.
    #[must_use]
    pub fn sunlight(&self, radius: f64, mu: f64) -> f64 {
        let (ground, top) = (self.air.ground, self.air.ground + self.air.height);
        let rho_squared = (radius * radius - ground * ground).max(0.0);
        if mu < 0.0 && radius * radius * (mu * mu - 1.0) + ground * ground > 0.0 {
            return 0.0;
        }
        let horizon = (top * top - ground * ground).sqrt();
        let rho = rho_squared.sqrt();
        let length = -radius * mu + (radius * radius * (mu * mu - 1.0) + top * top).max(0.0).sqrt();
        let (near, far) = (top - radius, rho + horizon);
        let x = (rho / horizon).clamp(0.0, 1.0) * (ROWS - 1) as f64;
        let y = ((length - near) / (far - near)).clamp(0.0, 1.0) * (COLUMNS - 1) as f64;
        let (i, j) = ((x as usize).min(ROWS - 2), (y as usize).min(COLUMNS - 2));
        let (fx, fy) = (x - i as f64, y - j as f64);
        let at = |i: usize, j: usize| self.sunlight[i * COLUMNS + j];
        let low = at(i, j) * (1.0 - fy) + at(i, j + 1) * fy;
        let high = at(i + 1, j) * (1.0 - fy) + at(i + 1, j + 1) * fy;
        (-(low * (1.0 - fx) + high * fx)).exp()
    }

    fn sun_at(&self, point: Vector, sun: Vector) -> f64 {
        let radius = dot(point, point).sqrt();
        self.sunlight(radius, dot(point, sun) / radius)
    }

    /// The next encounter on the way: its place, or `None` where the air ends or the ground begins.
    fn flight(&self, from: Vector, toward: Vector, reach: f64, random: &mut Stream) -> Option<Vector> {
        let air = &self.air;
        let (squared, along_ray) = (dot(from, from), dot(from, toward));
        let height_at = |way: f64| (squared + way * (way + 2.0 * along_ray)).max(0.0).sqrt() - air.ground;
        let ozone = air.ozone[0];
        let mut way = 0.0;
        loop {
            // Null collisions under a bound that holds for the next stretch: falling rays get a short one.
            let falling = -(along_ray + way);
            let (ahead, lowest) = if falling > 0.0 {
                let slope = (falling / squared.sqrt()).max(0.02);
                let ahead = (0.7 * air.rayleigh[1].min(4.0 * air.mie[2]) / slope).min(reach - way);
                (ahead, height_at(way + ahead.min(falling)))
            } else {
                (reach - way, height_at(way))
            };
            let [molecules, aerosols, _] = air.at(lowest.max(0.0));
            let bound = molecules + aerosols * (1.0 + air.mie[1] / air.mie[0].max(1e-30)) + ozone;
            let step = -(1.0 - random.next()).ln() / bound;
            if step > ahead {
                way += ahead;
                if way >= reach - 1e-3 {
                    return None;
                }
                continue;
            }
            way += step;
            if random.next() * bound < air.at(height_at(way))[2] {
                return Some(along(from, toward, way));
            }
        }
    }

    /// Light that comes to `point` along `-toward`, having met air or ground at least once: one path's estimate.
    fn gather(&self, point: Vector, toward: Vector, sun: Vector, random: &mut Stream) -> f64 {
        let air = &self.air;
        let (mut point, mut toward, mut weight, mut light) = (point, toward, 1.0, 0.0);
        for _ in 0..1000 {
            let (reach, ends_on_ground) = air.reach(point, toward);
            if let Some(met) = self.flight(point, toward, reach, random) {
                let [molecules, aerosols, extinction] = air.at(air.height_of(met));
                let scattering = molecules + aerosols;
                weight *= scattering / extinction;
                let cosine = dot(toward, sun);
                let phase = molecules * Air::rayleigh_phase(cosine) + aerosols * air.mie_phase(cosine);
                light += weight * phase / scattering.max(1e-30) * self.sun_at(met, sun);
                let by_molecules = random.next() * scattering < molecules;
                toward = self.scattered(toward, by_molecules, &mut weight, random);
                point = met;
            } else if ends_on_ground {
                let met = unit(along(point, toward, reach));
                point = met.map(|x| x * (air.ground + 1e-3));
                weight *= air.albedo;
                light += weight / PI * dot(met, sun).max(0.0) * self.sun_at(point, sun);
                toward = around(met, random.next().sqrt(), TAU * random.next());
            } else {
                break;
            }
            if weight < 0.1 {
                if random.next() > 4.0 * weight {
                    break;
                }
                weight = 0.25;
            }
        }
        light
    }

    fn scattered(&self, toward: Vector, by_molecules: bool, weight: &mut f64, random: &mut Stream) -> Vector {
        let u = random.next();
        let cosine = if by_molecules {
            let q = 4.0 * u - 2.0;
            let root = (q + (q * q + 1.0).sqrt()).cbrt();
            root - 1.0 / root
        } else {
            let g = self.air.asymmetry;
            let part = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
            let cosine = (1.0 + g * g - part * part) / (2.0 * g);
            *weight *= 1.5 * (1.0 + cosine * cosine) / (2.0 + g * g);
            cosine
        };
        around(toward, cosine.clamp(-1.0, 1.0), TAU * random.next())
    }

    /// Radiance that comes to `height` (m) from `toward` with the sun at `sun` (y is up): the first order is summed, the
    /// others come from `count` paths.
    #[must_use]
    pub fn radiance(&self, height: f64, toward: Vector, sun: Vector, count: usize, seed: u64) -> Estimate {
        let air = &self.air;
        let origin = [0.0, air.ground + height, 0.0];
        let mut random = Stream::new(seed);
        let (reach, ends_on_ground) = air.reach(origin, toward);
        let steps = 4096;
        let cosine = dot(toward, sun);
        let (mut depth, mut first, mut past) = (0.0, 0.0, 0.0);
        let mut sums = vec![0.0];
        for step in 0..steps {
            let s = (f64::from(step) + 0.5) / f64::from(steps);
            let size = 2.0 * reach * s / f64::from(steps);
            let point = along(origin, toward, reach * s * s);
            let [molecules, aerosols, extinction] = air.at(air.height_of(point));
            let seen = size * (-(depth + 0.5 * extinction * size)).exp();
            depth += extinction * size;
            let phase = molecules * Air::rayleigh_phase(cosine) + aerosols * air.mie_phase(cosine);
            first += seen * phase * self.sun_at(point, sun);
            past += seen * (molecules + aerosols);
            sums.push(past);
        }
        let (mut sum, mut squares) = (0.0, 0.0);
        for path in 0..count {
            let sought = past * (path as f64 + random.next()) / count as f64;
            let step = sums.partition_point(|&x| x < sought).clamp(1, sums.len() - 1);
            let inside = (sought - sums[step - 1]) / (sums[step] - sums[step - 1]).max(1e-300);
            let s = ((step - 1) as f64 + inside) / f64::from(steps);
            let point = along(origin, toward, reach * s * s);
            let [molecules, aerosols, _] = air.at(air.height_of(point));
            let by_molecules = random.next() * (molecules + aerosols) < molecules;
            let mut weight = past;
            let onward = self.scattered(toward, by_molecules, &mut weight, &mut random);
            let light = weight * self.gather(point, onward, sun, &mut random);
            sum += light;
            squares += light * light;
        }
        let (mean, mut variance) = mean_and_variance(sum, squares, count);
        let mut all = first + mean;
        if ends_on_ground {
            let (ground, error) = self.bounce(along(origin, toward, reach), sun, count / 2, &mut random);
            all += (-depth).exp() * ground;
            variance += ((-depth).exp() * error).powi(2);
        }
        Estimate { first, all, error: variance.sqrt() }
    }

    /// Radiance of the ground under sun and sky, and its error.
    fn bounce(&self, point: Vector, sun: Vector, count: usize, random: &mut Stream) -> (f64, f64) {
        let up = unit(point);
        let start = up.map(|x| x * (self.air.ground + 1e-3));
        let (sky, error) = self.sky_over(start, sun, count, random);
        let direct = dot(up, sun).max(0.0) * self.sun_at(start, sun);
        (self.air.albedo / PI * (direct + sky), self.air.albedo / PI * error)
    }

    fn sky_over(&self, point: Vector, sun: Vector, count: usize, random: &mut Stream) -> (f64, f64) {
        let up = unit(point);
        let (mut sum, mut squares) = (0.0, 0.0);
        for path in 0..count {
            let u = (path as f64 + random.next()) / count as f64;
            let toward = around(up, u.sqrt(), TAU * random.next());
            let light = PI * self.gather(point, toward, sun, random);
            sum += light;
            squares += light * light;
        }
        let (mean, variance) = mean_and_variance(sum, squares, count);
        (mean, variance.sqrt())
    }

    /// Irradiance of level ground at `height` (m) by the sky alone, all orders, and its standard error.
    #[must_use]
    pub fn irradiance(&self, height: f64, sun_mu: f64, count: usize, seed: u64) -> (f64, f64) {
        let sun = [(1.0 - sun_mu * sun_mu).max(0.0).sqrt(), sun_mu, 0.0];
        let point = [0.0, self.air.ground + height.max(1e-3), 0.0];
        self.sky_over(point, sun, count, &mut Stream::new(seed))
    }

    /// Mean radiance, from bins of direction, of what meets a point: `elevations` × `azimuths` bins, all orders but the
    /// sun itself. A bin's cosine of the zenith angle is sign(u)|u|^1.6, its azimuth from the sun's π·v^1.5.
    #[must_use]
    pub fn field(&self, height: f64, sun_mu: f64, bins: [usize; 2], count: usize, seed: u64) -> Vec<f64> {
        let sun = [(1.0 - sun_mu * sun_mu).max(0.0).sqrt(), sun_mu, 0.0];
        let point = [0.0, self.air.ground + height.max(1e-3), 0.0];
        let mut random = Stream::new(seed);
        let [elevations, azimuths] = bins;
        let each = count.div_ceil(elevations * azimuths);
        let mut field = Vec::new();
        for i in 0..elevations {
            for j in 0..azimuths {
                let (mut sum, mut weights) = (0.0, 0.0);
                for _ in 0..each {
                    let u = 2.0 * (i as f64 + random.next()) / elevations as f64 - 1.0;
                    let v = (j as f64 + random.next()) / azimuths as f64;
                    let mu = u.signum() * u.abs().powf(1.6);
                    let azimuth = PI * v.powf(1.5);
                    let weight = u.abs().powf(0.6) * v.sqrt();
                    let sine = (1.0 - mu * mu).max(0.0).sqrt();
                    let toward = [sine * azimuth.cos(), mu, sine * azimuth.sin()];
                    sum += weight * self.gather(point, toward, sun, &mut random);
                    weights += weight;
                }
                field.push(sum / weights);
            }
        }
        field
    }
}

fn mean_and_variance(sum: f64, squares: f64, count: usize) -> (f64, f64) {
    let count = count as f64;
    let mean = sum / count;
    (mean, (squares / count - mean * mean).max(0.0) / count)
}

//! Rays over a land of Perlin octaves: where they first meet it, by steps that cannot skip anything.

use crate::noise::perlin2;

/// A land: octaves of Perlin noise, each twice as fine as the one before, turned and shifted.
#[derive(Debug, Clone, Copy)]
pub struct Relief {
    /// What it is called in tables.
    pub name: &'static str,
    /// Strength of the first octave (m).
    pub height: f32,
    /// Wavelength of the first octave (m).
    pub wavelength: f32,
    /// Strength of an octave over that of the one before.
    pub gain: f32,
    /// How many octaves.
    pub octaves: usize,
    /// How many of them, from the first on, say how much the others count; all for a plain sum.
    pub plain: usize,
    /// How far (m) the camera is above the ground.
    pub lift: f64,
    /// Where it looks, in degrees above the horizon.
    pub pitch: f64,
}

/// The lands of the bench: a grazing view, a rougher one, and hills from above.
pub const RELIEFS: [Relief; 3] = [
    Relief {
        name: "mountains, grazing",
        height: 400.0,
        wavelength: 3000.0,
        gain: 0.5,
        octaves: 8,
        plain: 8,
        lift: 60.0,
        pitch: -6.0,
    },
    Relief {
        name: "rough mountains",
        height: 350.0,
        wavelength: 3000.0,
        gain: 0.55,
        octaves: 10,
        plain: 10,
        lift: 60.0,
        pitch: -8.0,
    },
    Relief {
        name: "hills from above",
        height: 100.0,
        wavelength: 1500.0,
        gain: 0.574, // Hurst exponent .8
        octaves: 8,
        plain: 8,
        lift: 200.0,
        pitch: -40.0,
    },
];

/// A dual heightmap: three octaves say how much the other five count.
pub const DUAL: Relief = Relief {
    name: "dual heightmap",
    height: 400.0,
    wavelength: 3000.0,
    gain: 0.55,
    octaves: 8,
    plain: 3,
    lift: 60.0,
    pitch: -6.0,
};

/// How far is looked (m).
pub const FAR: f64 = 20_000.0;

/// A ray, of `f32` numbers as the GPU gets them.
#[derive(Debug, Clone, Copy)]
pub struct Ray {
    /// Where it starts (m).
    pub origin: [f64; 3],
    /// A unit vector.
    pub direction: [f64; 3],
}

impl Ray {
    /// The ray whose numbers are rounded to `f32`; `direction` need not be a unit vector.
    #[must_use]
    pub fn new(origin: [f64; 3], direction: [f64; 3]) -> Self {
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        let rounded = |x: f64| f64::from(x as f32);
        Self { origin: origin.map(rounded), direction: direction.map(|x| rounded(x / length)) }
    }

    /// The place `t` along it.
    #[must_use]
    pub fn at(&self, t: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.origin[i] + t * self.direction[i])
    }

    /// Its six numbers, for the GPU.
    #[must_use]
    pub fn numbers(&self) -> [f32; 6] {
        let [x, y, z] = self.origin.map(|x| x as f32);
        let [u, v, w] = self.direction.map(|x| x as f32);
        [x, y, z, u, v, w]
    }
}

impl Relief {
    /// The same land as WGSL, with the marches over it.
    #[must_use]
    pub fn wgsl(&self) -> String {
        format!(
            "const RELIEF_HEIGHT: f32 = {:?};\nconst RELIEF_WAVELENGTH: f32 = {:?};\nconst RELIEF_GAIN: f32 = {:?};\n\
             const RELIEF_OCTAVES: i32 = {};\nconst RELIEF_PLAIN: i32 = {};\n{}",
            self.height,
            self.wavelength,
            self.gain,
            self.octaves,
            self.plain,
            include_str!("march/relief.wgsl"),
        )
    }

    /// A height that the land nowhere exceeds (m).
    #[must_use]
    pub fn ceiling(&self) -> f64 {
        (0..self.octaves).map(|i| self.strength(i)).sum()
    }

    fn strength(&self, index: usize) -> f64 {
        f64::from(self.height) * f64::from(self.gain).powi(index as i32)
    }

    /// Height of one octave (m).
    fn octave(&self, index: usize, x: f64, z: f64) -> f64 {
        let (sin, cos) = (index as f64 * 0.6_f64.atan2(0.8)).sin_cos();
        let frequency = f64::from(1_u32 << index) / f64::from(self.wavelength);
        let shift = index as f64;
        let q = [
            frequency * (cos * x - sin * z) + shift * f64::from(37.31_f32),
            frequency * (sin * x + cos * z) + shift * f64::from(17.83_f32),
        ];
        self.strength(index) * perlin2(q, None, index as u32 + 11)
    }

    /// Height of the land (m).
    #[must_use]
    pub fn height(&self, x: f64, z: f64) -> f64 {
        let plain: f64 = (0..self.plain).map(|i| self.octave(i, x, z)).sum();
        let rugged: f64 = (self.plain..self.octaves).map(|i| self.octave(i, x, z)).sum();
        plain + (0.5 + 0.5 * plain / f64::from(self.height)).clamp(0.0, 1.0) * rugged
    }

    /// Height of a ray over the land at `t` (m).
    #[must_use]
    pub fn clearance(&self, ray: &Ray, t: f64) -> f64 {
        let [x, y, z] = ray.at(t);
        y - self.height(x, z)
    }

    /// Where the ray first meets the land, to 1e-6 m, up to `far` (m).
    ///
    /// Steps as long as nothing can be met, since noise is less steep than 3 a cell; but no shorter than a 400th of the
    /// finest octave's cell, so that only what reaches less than a few millimetres into the ray is skipped.
    #[must_use]
    pub fn first_crossing(&self, ray: &Ray, far: f64) -> Option<f64> {
        let across = ray.direction[0].hypot(ray.direction[2]);
        let frequency = |i: usize| f64::from(1_u32 << i) / f64::from(self.wavelength);
        let slope = |range: std::ops::Range<usize>| -> f64 {
            range.map(|i| 3.0 * frequency(i) * self.strength(i)).sum()
        };
        let ranges: f64 = (self.plain..self.octaves).map(|i| self.strength(i)).sum();
        // Product rule: the first octaves also change how much the others count.
        let steepest = slope(0..self.plain) * (1.0 + 0.5 * ranges / f64::from(self.height))
            + slope(self.plain..self.octaves);
        let closing = (steepest * across - ray.direction[1]).max(1e-9);
        let shortest = 0.0025 / frequency(self.octaves - 1);
        let ceiling = self.ceiling();
        let mut t: f64 = 0.0;
        if ray.origin[1] > ceiling {
            if ray.direction[1] >= 0.0 {
                return None;
            }
            t = (ceiling - ray.origin[1]) / ray.direction[1];
        }
        let mut before = t;
        while t < far {
            if ray.at(t)[1] > ceiling && ray.direction[1] >= 0.0 {
                return None;
            }
            let above = self.clearance(ray, t);
            if above <= 0.0 {
                let (mut free, mut under) = (before, t);
                while under - free > 1e-6 {
                    let middle = 0.5 * (free + under);
                    if self.clearance(ray, middle) > 0.0 {
                        free = middle;
                    } else {
                        under = middle;
                    }
                }
                return Some(under);
            }
            before = t;
            t += (above / closing).max(shortest);
        }
        None
    }

    /// The rays of a square picture, 50 degrees wide, from `side` by `side` pixels.
    #[must_use]
    pub fn rays(&self, side: usize) -> Vec<Ray> {
        let origin = [0.0, self.height(0.0, 0.0) + self.lift, 0.0];
        let (sin, cos) = self.pitch.to_radians().sin_cos();
        let half = 25.0_f64.to_radians().tan();
        let across = |i: usize| ((i as f64 + 0.5) / side as f64 * 2.0 - 1.0) * half;
        let pixels = (0..side).flat_map(|j| (0..side).map(move |i| (across(i), across(j))));
        pixels.map(|(x, y)| Ray::new(origin, [x, sin + y * cos, cos - y * sin])).collect()
    }
}

/// What a march found on many rays, against the truth.
#[derive(Debug, Clone, Copy)]
pub struct Errors {
    /// Crossings passed over: no hit, or one more than a metre and a 1000th of the distance too far.
    pub missed: usize,
    /// Hits where there is nothing.
    pub phantoms: usize,
    /// How far a hit is from the truth along the ray, |t - t*|: the median, the 95th percentile, and the farthest too far.
    pub ide50: f64,
    /// See `ide50`.
    pub ide95: f64,
    /// See `ide50`.
    pub late: f64,
    /// How far a hit is above or below the land (m), 95th percentile.
    pub hde95: f64,
}

impl Errors {
    /// `truth`: where each ray meets the land; `hits`: what a march says, `None` for no hit.
    #[must_use]
    pub fn of(relief: &Relief, rays: &[Ray], truth: &[Option<f64>], hits: &[Option<f64>]) -> Self {
        let (mut missed, mut phantoms, mut late) = (0, 0, 0.0_f64);
        let (mut ide, mut hde) = (Vec::new(), Vec::new());
        for ((ray, truth), hit) in rays.iter().zip(truth).zip(hits) {
            match (truth, hit) {
                (Some(truth), Some(hit)) if hit - truth <= (0.001 * truth).max(1.0) => {
                    ide.push((hit - truth).abs());
                    hde.push(relief.clearance(ray, *hit).abs());
                    late = late.max(hit - truth);
                }
                (Some(_), _) => missed += 1,
                (None, Some(_)) => phantoms += 1,
                (None, None) => {}
            }
        }
        ide.sort_by(f64::total_cmp);
        hde.sort_by(f64::total_cmp);
        let percentile =
            |values: &[f64], part: usize| values.get(values.len() * part / 100).copied().unwrap_or(0.0);
        Self {
            missed,
            phantoms,
            ide50: percentile(&ide, 50),
            ide95: percentile(&ide, 95),
            late,
            hde95: percentile(&hde, 95),
        }
    }
}

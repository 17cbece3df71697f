//! Light scattered once by a planet's air, and what comes through it, from the definitions in f64: integrals along rays,
//! broken wherever the air, the planet's shadow or the ozone begins or ends, and each piece summed densely.
//!
//! Lengths are metres, the sun's irradiance is 1, and the eye stands on the y axis: y is up where it is.

use std::f64::consts::PI;

type Vector = [f64; 3];
type Colour = [f64; 3];

/// Air around a planet, in red, green and blue.
#[derive(Debug, Clone, Copy)]
pub struct Air {
    /// Radius of the ground (m).
    pub ground: f64,
    /// Height at which the air ends (m).
    pub height: f64,
    /// Scattering by molecules at the ground (1/m).
    pub rayleigh: Colour,
    /// Height over which they thin out by e (m).
    pub rayleigh_height: f64,
    /// Scattering by aerosols at the ground (1/m).
    pub mie: f64,
    /// Their extinction (1/m).
    pub mie_extinction: f64,
    /// Height over which they thin out by e (m).
    pub mie_height: f64,
    /// Cornette's and Shanks's parameter.
    pub asymmetry: f64,
    /// Absorption by ozone where it is densest (1/m).
    pub ozone: Colour,
    /// Height of that (m), and how far above and below there is none.
    pub ozone_layer: [f64; 2],
}

impl Air {
    /// Earth's (Hillaire 2020).
    #[must_use]
    pub fn earth() -> Self {
        Self {
            ground: 6_360e3,
            height: 100e3,
            rayleigh: [5.802e-6, 13.558e-6, 33.1e-6],
            rayleigh_height: 8e3,
            mie: 3.996e-6,
            mie_extinction: 4.44e-6,
            mie_height: 1.2e3,
            asymmetry: 0.8,
            ozone: [0.650e-6, 1.881e-6, 0.085e-6],
            ozone_layer: [25e3, 15e3],
        }
    }

    /// Mars's.
    #[must_use]
    pub fn mars() -> Self {
        Self {
            ground: 3_389.5e3,
            height: 120e3,
            rayleigh: [19.918e-6, 13.57e-6, 5.75e-6],
            rayleigh_height: 10.43e3,
            mie: 53.618e-6,
            mie_extinction: 53.618e-6 + 0.553e-6,
            mie_height: 3.095e3,
            asymmetry: 0.85,
            ozone: [0.0; 3],
            ozone_layer: [25e3, 15e3],
        }
    }

    /// Optical paths (m) of molecules, aerosols and ozone from `from` to `distance` along `toward`.
    #[must_use]
    pub fn path(&self, from: Vector, toward: Vector, distance: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let cuts = self.cuts(from, toward, distance, &[]);
        for piece in cuts.windows(2) {
            let span = piece[1] - piece[0];
            for (x, w) in &GAUSS {
                let height = self.height_of(along(from, toward, piece[0] + span * x));
                let densities = self.densities(height);
                for (total, density) in sum.iter_mut().zip(densities) {
                    *total += span * w * density;
                }
            }
        }
        sum
    }

    /// Transmittance from `height` to the top of the air; `mu` is the cosine of the zenith angle. 0 behind the planet.
    #[must_use]
    pub fn transmittance(&self, height: f64, mu: f64) -> Colour {
        let from = [0.0, self.ground + height, 0.0];
        let toward = [(1.0 - mu * mu).max(0.0).sqrt(), mu, 0.0];
        if self.blocked(from, toward) {
            return [0.0; 3];
        }
        self.dimmed(self.path(from, toward, f64::INFINITY))
    }

    /// Radiance scattered once toward an eye at `height`, from up to `distance` along `view`; `sun` is where the sun is.
    #[must_use]
    pub fn single(&self, height: f64, view: Vector, sun: Vector, distance: f64) -> Colour {
        let (view, sun) = (unit(view), unit(sun));
        let eye = [0.0, self.ground + height, 0.0];
        let nu = dot(view, sun);
        let molecules = 3.0 / (16.0 * PI) * (1.0 + nu * nu);
        let g = self.asymmetry;
        let aerosols = 3.0 / (8.0 * PI) * (1.0 - g * g) * (1.0 + nu * nu)
            / ((2.0 + g * g) * (1.0 + g * g - 2.0 * g * nu).powf(1.5));
        // The edge of the shadow's cylinder: |p − (p · sun) sun| = ground.
        let (across, out) = (aside(eye, sun), aside(view, sun));
        let edges = roots(dot(out, out), dot(across, out), dot(across, across) - self.ground * self.ground);
        let mut sum = [0.0; 3];
        for piece in self.cuts(eye, view, distance, &edges).windows(2) {
            let middle = along(eye, view, f64::midpoint(piece[0], piece[1]));
            if self.blocked(middle, sun) {
                continue;
            }
            let panels = 4;
            for panel in 0..panels {
                // Narrow panels at both ends, where the shadow's edge is.
                let place = |i: i32| 0.5 - 0.5 * (PI * f64::from(i) / f64::from(panels)).cos();
                let (low, high) = (place(panel), place(panel + 1));
                let span = piece[1] - piece[0];
                for (x, w) in &GAUSS {
                    let t = piece[0] + span * (low + (high - low) * x);
                    let there = along(eye, view, t);
                    let seen = self.path(eye, view, t);
                    let lit = self.path(there, sun, f64::INFINITY);
                    let left = self.dimmed([seen[0] + lit[0], seen[1] + lit[1], seen[2] + lit[2]]);
                    let densities = self.densities(self.height_of(there));
                    let weight = span * (high - low) * w;
                    for c in 0..3 {
                        let scattered =
                            densities[0] * self.rayleigh[c] * molecules + densities[1] * self.mie * aerosols;
                        sum[c] += weight * scattered * left[c];
                    }
                }
            }
        }
        sum
    }

    /// What is left of light after the optical paths (m) of the three kinds.
    #[must_use]
    pub fn dimmed(&self, path: [f64; 3]) -> Colour {
        std::array::from_fn(|c| {
            let depth = path[0] * self.rayleigh[c] + path[1] * self.mie_extinction + path[2] * self.ozone[c];
            (-depth).exp()
        })
    }

    /// Densities of the three kinds, over the greatest of each.
    fn densities(&self, height: f64) -> [f64; 3] {
        let [center, half_width] = self.ozone_layer;
        [
            (-height / self.rayleigh_height).exp(),
            (-height / self.mie_height).exp(),
            (1.0 - (height - center).abs() / half_width).max(0.0),
        ]
    }

    fn height_of(&self, p: Vector) -> f64 {
        dot(p, p).sqrt() - self.ground
    }

    /// Whether the planet is in the way.
    fn blocked(&self, from: Vector, toward: Vector) -> bool {
        let ahead = dot(from, toward) < 0.0;
        let across = aside(from, toward);
        ahead && dot(across, across) < self.ground * self.ground
    }

    /// Where a ray's air begins, bends and ends, in order: its lowest point, the heights where the ozone bends, some more
    /// for the aerosols, and `more`.
    fn cuts(&self, from: Vector, toward: Vector, distance: f64, more: &[f64]) -> Vec<f64> {
        let middle = dot(from, toward);
        let outside = dot(from, from);
        let crossing = |height: f64| {
            let radius = self.ground + height;
            roots(1.0, middle, outside - radius * radius)
        };
        let top = crossing(self.height);
        if top[0].is_nan() {
            return Vec::new();
        }
        let (near, mut far) = (top[0].max(0.0), top[1].min(distance));
        if self.blocked(from, toward) {
            far = far.min(crossing(0.0)[0].max(0.0));
        }
        let [center, half_width] = self.ozone_layer;
        let scale = self.mie_height;
        let mut cuts = vec![near, far, -middle];
        for height in
            [center - half_width, center, center + half_width, 2.5 * scale, 20.0 * scale, 0.55 * self.height]
        {
            cuts.extend(crossing(height));
        }
        cuts.extend(more);
        cuts.retain(|t| t.is_finite() && *t >= near && *t <= far);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|b, a| *b - *a < 1e-6);
        cuts
    }
}

/// Where a t² + 2 b t + c = 0: in order, NaN where nowhere.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let root = (b * b - a * c).sqrt();
    [(-b - root) / a, (-b + root) / a]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Vector) -> Vector {
    let size = dot(a, a).sqrt();
    a.map(|x| x / size)
}

fn along(from: Vector, toward: Vector, t: f64) -> Vector {
    std::array::from_fn(|i| from[i] + t * toward[i])
}

/// What of `a` is at right angles to the unit `b`.
fn aside(a: Vector, b: Vector) -> Vector {
    along(a, b, -dot(a, b))
}

/// Gauss–Legendre, 10 points over 0 .. 1: (x, w).
const GAUSS: [(f64, f64); 10] = [
    (0.013_046_735_741_414, 0.033_335_672_154_344),
    (0.067_468_316_655_507, 0.074_725_674_575_290),
    (0.160_295_215_850_487, 0.109_543_181_257_991),
    (0.283_302_302_935_376, 0.134_633_359_654_998),
    (0.425_562_830_509_184, 0.147_762_112_357_376),
    (0.574_437_169_490_815, 0.147_762_112_357_376),
    (0.716_697_697_064_623, 0.134_633_359_654_998),
    (0.839_704_784_149_512, 0.109_543_181_257_991),
    (0.932_531_683_344_492, 0.074_725_674_575_290),
    (0.986_953_264_258_585, 0.033_335_672_154_344),
];

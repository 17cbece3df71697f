//! The engine's camera: reversed depth without a far plane, and places relative to the eye.

use glam::dcamera::rh::{proj, view};
use glam::{DVec3, Mat4, Vec2, Vec3};

/// Where the picture is taken from.
#[derive(Debug, Clone, Copy)]
pub struct Camera {
    /// The eye (m).
    pub eye: Vec3,
    /// Clockwise from north (rad).
    pub azimuth: f32,
    /// Above the horizon (rad).
    pub elevation: f32,
    /// On a frame 36 mm wide.
    pub focal_length: f32,
}

/// The nearest that is drawn (m): there the depth is 1, and infinitely far away 0.
const NEAR: f64 = 0.2;

impl Camera {
    /// Unit vector: where it looks.
    pub fn forward(&self) -> Vec3 {
        let (sin, cos) = self.azimuth.sin_cos();
        let (up, level) = self.elevation.sin_cos();
        Vec3::new(sin * level, up, -cos * level)
    }

    /// The camera that looks from `eye` at `target`.
    pub fn looking_at(eye: Vec3, target: Vec3, focal_length: f32) -> Self {
        let way = (target - eye).normalize();
        Self { eye, azimuth: way.x.atan2(-way.z), elevation: way.y.asin(), focal_length }
    }

    /// From places relative to the eye to the clip space of a picture of this shape, and back.
    pub fn clip_from_eye(&self, aspect: f32) -> (Mat4, Mat4) {
        let half_height = 18.0 / f64::from(self.focal_length) / f64::from(aspect);
        let projection =
            proj::directx::perspective_infinite_reverse(2.0 * half_height.atan(), f64::from(aspect), NEAR);
        let clip = projection * view::look_to_mat4(DVec3::ZERO, self.forward().as_dvec3(), DVec3::Y);
        (clip.as_mat4(), clip.inverse().as_mat4())
    }

    /// The pixel of a picture of `size`, from the top left, that shows `place`; none behind the eye.
    pub fn pixel(&self, place: Vec3, size: [u32; 2]) -> Option<Vec2> {
        let size = Vec2::new(size[0] as f32, size[1] as f32);
        let clip = self.clip_from_eye(size.x / size.y).0 * (place - self.eye).extend(1.0);
        (clip.w > 0.0).then(|| (Vec2::new(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * size)
    }
}

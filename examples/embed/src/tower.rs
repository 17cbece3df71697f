//! The engine's one mesh: a watchtower of granite, 6 m wide and 15 m high, with a roof of shingles.

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};

/// A corner of a triangle.
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Vertex {
    pub position: Vec3,
    pub normal: Vec3,
    pub material: u32,
}

/// What a surface is made of; `things.wgsl` has the same numbers.
#[derive(Clone, Copy)]
enum Material {
    Stone,
    Shingles,
    Wood,
    Dark,
}

/// How high it stands over its foot (m).
pub const HEIGHT: f32 = 15.2;
/// How far it reaches from the middle of its foot, with what is in the ground (m).
pub const REACH: f32 = 16.0;

/// Its triangles, in metres from the middle of its foot, y up.
pub fn tower() -> Vec<Vertex> {
    let mut mesh = Mesh::default();
    let level = |half: f32| Vec2::splat(half);
    mesh.frustum(Vec3::ZERO, [-4.0, 0.9], [level(3.25), level(3.15)], Material::Stone); // the plinth goes into the ground
    mesh.frustum(Vec3::ZERO, [0.9, 10.6], [level(3.0), level(2.75)], Material::Stone);
    mesh.frustum(Vec3::ZERO, [10.4, 10.8], [level(2.8), level(3.05)], Material::Stone);
    mesh.frustum(Vec3::ZERO, [10.8, 11.2], [level(3.05), level(3.05)], Material::Stone);
    mesh.frustum(Vec3::ZERO, [10.95, 11.15], [level(3.45), level(3.5)], Material::Shingles); // the eaves
    mesh.frustum(Vec3::ZERO, [11.15, HEIGHT], [level(3.5), level(0.04)], Material::Shingles);
    for (side, [low, high], width) in [
        (0, [0.9, 3.2], 0.62_f32), // the door
        (0, [5.2, 6.5], 0.2),
        (0, [8.6, 9.9], 0.34),
        (1, [3.4, 4.7], 0.2),
        (1, [8.6, 9.9], 0.34),
        (2, [6.4, 7.7], 0.2),
        (2, [8.6, 9.9], 0.34),
        (3, [4.6, 5.9], 0.2),
        (3, [8.6, 9.9], 0.34),
    ] {
        mesh.opening(side, low, high, width);
    }
    mesh.triangles
}

#[derive(Default)]
struct Mesh {
    triangles: Vec<Vertex>,
}

impl Mesh {
    /// A frame of stone, and in it the dark or, from the ground, a door.
    fn opening(&mut self, side: usize, low: f32, high: f32, half: f32) {
        let wall = |y: f32| 3.0 - 0.25 * (y - 0.9) / 9.7; // the shaft's half width
        let (out, across) =
            [(Vec3::Z, Vec3::X), (Vec3::X, Vec3::Z), (-Vec3::Z, Vec3::X), (-Vec3::X, Vec3::Z)][side];
        let size = |half: f32, deep: f32| {
            let size = half * across.abs() + deep * out.abs();
            Vec2::new(size.x, size.z)
        };
        let mut block = |shift: f32, half: f32, [low, high]: [f32; 2], proud: f32, material| {
            let centre = wall(0.5 * (low + high)) * out + shift * across;
            self.frustum(centre, [low, high], [size(half, proud); 2], material);
        };
        let is_door = low < 1.0;
        block(
            0.0,
            half,
            [low, high],
            if is_door { 0.06 } else { 0.05 },
            if is_door { Material::Wood } else { Material::Dark },
        );
        for shift in [-half - 0.11, half + 0.11] {
            block(shift, 0.11, [low, high], 0.13, Material::Stone);
        }
        block(0.0, half + 0.34, [high, high + 0.26], 0.15, Material::Stone);
        block(0.0, half + 0.3, [low - 0.16, low], 0.17, Material::Stone);
    }

    /// A box whose top may be narrower than its bottom, around `centre`, from and to these heights.
    fn frustum(&mut self, centre: Vec3, heights: [f32; 2], halves: [Vec2; 2], material: Material) {
        let corner = |end: usize, x: f32, z: f32| {
            Vec3::new(centre.x + x * halves[end].x, heights[end], centre.z + z * halves[end].y)
        };
        for (a, b) in [
            ((-1.0, 1.0), (1.0, 1.0)),
            ((1.0, 1.0), (1.0, -1.0)),
            ((1.0, -1.0), (-1.0, -1.0)),
            ((-1.0, -1.0), (-1.0, 1.0)),
        ] {
            let [low_a, low_b] = [corner(0, a.0, a.1), corner(0, b.0, b.1)];
            let [high_a, high_b] = [corner(1, a.0, a.1), corner(1, b.0, b.1)];
            self.quad([low_a, low_b, high_b, high_a], material);
        }
        let ring = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        self.quad(ring.map(|(x, z)| corner(1, x, z)), material);
        self.quad(ring.map(|(x, z)| corner(0, x, -z)), material);
    }

    /// Two triangles, counterclockwise from outside.
    fn quad(&mut self, [a, b, c, d]: [Vec3; 4], material: Material) {
        let normal = (c - a).cross(d - b).normalize();
        let corner = |position| Vertex { position, normal, material: material as u32 };
        self.triangles.extend([a, b, c, a, c, d].map(corner));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_face_looks_outward() {
        let mut mesh = Mesh::default();
        mesh.frustum(Vec3::new(5.0, 0.0, 0.0), [1.0, 3.0], [Vec2::ONE, Vec2::splat(0.5)], Material::Stone);
        assert_eq!(mesh.triangles.len(), 36);
        for corner in &mesh.triangles {
            let outward = corner.position - Vec3::new(5.0, 2.0, 0.0);
            assert!(outward.dot(corner.normal) > 0.0, "{corner:?}");
        }
    }

    #[test]
    fn it_is_as_large_as_it_says() {
        let tower = tower();
        let top = tower.iter().map(|corner| corner.position.y).fold(f32::MIN, f32::max);
        assert_eq!(top, HEIGHT);
        assert!(tower.iter().all(|corner| corner.position.length() < REACH));
    }
}

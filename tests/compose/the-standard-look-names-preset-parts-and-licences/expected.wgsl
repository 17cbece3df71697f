// preset: A *test* */ of all parts
// Composed by Orogen 0.1.0. Parameters and functions keep the names that their fragments give them.
//
// Options: a.on = true
//
// Licences of the fragments:
// Apache-2.0: lib.wgsl
// MIT: tests/compose/the-standard-look-names-preset-parts-and-licences/scene.wgsl

// ---- a ----

/// A parameter.
const a_x: f32 = 2.0;  // m, 0 .. 9
/// An angle.
const a_turn: f32 = 1.5707964;  // 90.0 deg, 0 .. 360
const a_n: u32 = 3u;  // 1 .. 4
/// On or off.
const a_on: bool = true;

/// The live parameters.
struct OrogenParams {
    live_y: f32,  // m, 0 .. 9
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- lib.wgsl as lib ----

// SPDX-License-Identifier: Apache-2.0

fn lib_f() -> f32 { return 1.0; }

// ---- tests/compose/the-standard-look-names-preset-parts-and-licences/scene.wgsl ----

// SPDX-License-Identifier: MIT

@fragment fn main() -> @location(0) vec4f {
    return vec4f(select(a_x, lib_f(), a_on) + orogen.live_y + a_turn + f32(a_n));
}

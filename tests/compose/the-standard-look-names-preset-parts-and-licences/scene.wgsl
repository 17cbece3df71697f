// SPDX-License-Identifier: MIT

#include <lib.wgsl> as lib
/// A parameter.
#param a.x: f32 = 1.0, range 0 .. 9, unit m
/// An angle.
#param a.turn: f32 = 90.0, range 0 .. 360, unit deg
#param a.n: u32 = 3, range 1 .. 4
/// On or off.
#option a.on = true
#param live.y: f32 = 2.0, range 0 .. 9, unit m

@fragment fn main() -> @location(0) vec4f {
    return vec4f(select(a.x, lib_f(), a.on) + live.y + a.turn + f32(a.n));
}

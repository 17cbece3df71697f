// The height of a planet's ground: one map of heights on three planes.
//
// Wavelengths are powers of two, so that the lattice of every octave is reached from whole cells without rounding: the
// ground is as smooth under a walker's feet as at the centre of the world.

#include <geometry/triplanar.wgsl>
#include <math/precise.wgsl>
#include <planet/forms.wgsl>
#include <planet/globe.wgsl>

/// What shaped the ground: continents, basins and chains of mountains, or impacts.
#option planet.relief = continents { continents, craters }
/// How narrow the blend between the map's three planes is.
#param planet.sharpness: f32 = 6.0, range 2 .. 32
/// How far apart on the map the planet's six sides lie.
#param planet.sides: vec2f = (31000000, 17000000), range 0 .. 100000000, unit m

#if planet.relief == craters
#include <planet/craters.wgsl>
#else
#include <planet/continents.wgsl>
#endif

/// The ground beneath a place.
struct PlanetGround {
    /// Height above sea level (m).
    height: f32,
    /// Its gradient along the sphere, in the world's axes: rise over run.
    slope: vec3f,
}

/// The ground beneath `p` (m), without the octaves too small to be seen in a pixel `footprint` (m) wide. Analytic.
fn planet_ground(p: vec3f, footprint: f32) -> PlanetGround {
    let axes = planet_axes();
    let unit = planet_grain();
    let place = planet_place(p, unit);
    let up = axes * planet_up(p);
    let sides = triplanar_weights(up, planet.sharpness);
    // Level n has forms 2^n grains wide.
    let finest = max(log2(2.0 * footprint / unit), 0.0);
    var height = 0.0;
    var slope = vec3f(0.0);
    for (var side = 0; side < 3; side++) {
        let weight = sides.weights[side];
        if weight <= 0.0 {
            continue;
        }
        let number = 2 * side + i32(up[side] < 0.0);
        let apart = vec2i(planet.sides / unit) * (number + 1);
        var cell = place.cell.yz;
        var fraction = place.fraction.yz;
        if side == 1 {
            cell = place.cell.zx;
            fraction = place.fraction.zx;
        } else if side == 2 {
            cell = place.cell.xy;
            fraction = place.fraction.xy;
        }
        let map = planet_map(vec3i(cell + apart, 0), vec3f(fraction, 0.0), finest);
        var along = vec3f(0.0, map.y, map.z);
        if side == 1 {
            along = vec3f(map.z, 0.0, map.y);
        } else if side == 2 {
            along = vec3f(map.y, map.z, 0.0);
        }
        height += weight * map.x;
        slope += weight * along / unit + map.x * sides.gradients[side] / sky.ground_radius;
    }
    let level = slope - dot(slope, up) * up;
    return PlanetGround(height, level * axes); // a row vector times a rotation: turned back
}

/// Height (m) of `p` (m) above the ground.
fn planet_above(p: vec3f, footprint: f32) -> f32 {
    return planet_altitude(p) - planet_ground(p, footprint).height;
}

/// Unit normal of the ground with `slope` at a place whose unit `up` is given.
///
/// Each plane's slope is laid over the sphere's own normal (whiteout blending: Barré-Brisebois & Hill 2012, "Blending in
/// Detail"), which for a height measured along `up` is exact but for the radius' own growth with height.
fn planet_normal(up: vec3f, slope: vec3f) -> vec3f {
    return normalize(up - slope);
}

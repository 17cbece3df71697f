// A host's own shader: it measures Orogen's land on a grid, for a map.

#include <terrain/height.wgsl>
#include "light.wgsl"

/// How much land the map shows, from edge to edge.
#param map.extent: f32 = 24000.0, range 100 .. 1000000, unit m

struct Cell {
    height: f32,
    light: f32,
}

@group(1) @binding(0) var<storage, read_write> cells: array<Cell>;

const map_columns = 72u;
const map_rows = 28u;

/// One cell of the map an invocation.
@compute @workgroup_size(64)
fn measure(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= map_columns * map_rows {
        return;
    }
    let cell = vec2f(f32(id.x % map_columns), f32(id.x / map_columns));
    let grid = vec2f(f32(map_columns), f32(map_rows));
    let land = terrain_height_grad(((cell + 0.5) / grid - 0.5) * map.extent);
    cells[id.x] = Cell(land.x, light_from_the_north_west(land.yz));
}

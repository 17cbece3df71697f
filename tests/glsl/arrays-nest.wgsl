// Arrays of arrays, built whole, read and written row by row and element by element.

alias Row = array<i32, 3>;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var grid = array<Row, 2>(Row(1, 2, x), Row(y, 5, 6));
    let copy = grid;
    grid[x & 1][y % 3] += 100;
    grid[1] = grid[x & 1];
    var cube: array<array<array<i32, 2>, 3>, 2>;
    cube[x & 1][y % 3][1] = x;
    cube[0] = cube[1];
    return vec4i(grid[0][2] + grid[1][0] * 1000, grid[1][y % 3], copy[x & 1][y % 3], cube[0][y % 3][1] + cube[1][0][0]);
}

const before = 2.0;
const inner = 4.0;
const later = 5.0;
const x = 6.0;

@fragment
fn main() -> @location(0) vec4f {
    let shadowed = before; // the global stays out
    for (var i = 0; i < 3; i++) { let inner = f32(i); }
    let y = inner; // the loop's is gone: the global
    {
        let x = x; // the right one is the global
    }
    let z = later; // the global: the local comes after
    let later = z;
    return vec4f(shadowed, y, later, 1.0);
}

// A remark that stays.
/// Leaves.
/// And this.
#param p.x: f32 = 1.0
/// Stays: it is the function's.
fn f() -> f32 { return p.x; }

/// Set off by a blank line: stays.

#param p.y: f32 = 2.0
/// Leaves.
    #param p.z: f32 = 3.0 // a comment behind it leaves too

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f() + p.y + p.z);
}

// What stands in `continuing` runs after each turn, also after a `continue`, and not after a `break`.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var i = 0;
    var body = 0;
    var after = 0;
    loop {
        if i >= x { break; }
        if i % 3 == 1 { continue; }
        if body > y { break; }
        body += 2;
        continuing {
            after += 1;
            i += 1;
        }
    }
    return vec4i(i, body, after, 0);
}

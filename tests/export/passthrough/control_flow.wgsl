fn walk(n: i32) -> i32 {
    var i = 0;
    loop {
        if i >= n { break; }
        switch i {
            case 0, 1: { i += 2; }
            case 2, default { i++; }
        }
        continuing { i = i + 1; break if i > 100; }
    }
    for (var j = 0; j < 4; j++) { if j == 2 { continue; } i += j; }
    while i > 50 { i -= 7; }
    return i;
}
@compute @workgroup_size(1) fn main() { let r = walk(9); }

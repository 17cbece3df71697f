// Lone semicolons, also after blocks and declarations.

;
struct Point { x: i32, y: i32, };
const ORIGIN = Point(1, 2);;

fn sum(p: Point) -> i32 {
    ;
    let r = p.x + p.y;;
    return r;
    ;
};

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    ;;
    if at.x > 3.0 { ; }
    for (var i = 0; i < 2; i++) { ; };
    return vec4i(sum(ORIGIN), sum(Point(i32(at.x), 1)), 0, 0);
}

// The entry point itself returns from many places and declares what others do.

fn helper(color: vec4i) -> vec4i {
    return color * 2;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var color = vec4i(vec2i(at.xy), 0, 0);
    if color.x < 8 { return helper(color); }
    for (var i = 0; i < 64; i++) {
        if i * i > color.y { return vec4i(i, color.xyz); }
        switch i {
            case 6: { if color.x == 50 { return vec4i(-6); } }
            default: {}
        }
    }
    return color;
}

// What keeps the scene in while it is on its way to a target that calls `main_image` itself.

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return main_image(position.xy);
}

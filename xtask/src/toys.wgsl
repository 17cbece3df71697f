// What compute.toys puts before a shader, as far as ours uses it. Its names are taken.

alias int = i32;
alias uint = u32;
alias float = f32;

struct Time { frame: u32, elapsed: f32, delta: f32 }
struct Mouse { pos: vec2u, zoom: f32, click: i32, start: vec2i, delta: vec2i }

@group(0) @binding(2) var<uniform> time: Time;
@group(0) @binding(3) var<uniform> mouse: Mouse;
@group(0) @binding(5) var screen: texture_storage_2d<rgba16float, write>;


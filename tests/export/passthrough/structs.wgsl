struct Inner { a: f32, @align(16) b: vec3<f32>, }
struct Outer { inner: Inner, list: array<Inner, 4>, m: mat3x3<f32> };

@group(0) @binding(3) var<uniform> outer: Outer;

struct Varying {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) id: u32,
}

@vertex fn vs(@builtin(vertex_index) i: u32) -> Varying {
    var out: Varying;
    out.position = vec4f(outer.m * outer.list[i & 3u].b, outer.inner.a);
    out.id = i;
    return out;
}
@fragment fn fs(in: Varying) -> @location(0) vec4f { return vec4f(f32(in.id)); }

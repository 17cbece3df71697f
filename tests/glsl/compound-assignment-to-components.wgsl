// Components of vectors by name and by index, constant and not.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = i32(at.x);
    var v = vec4f(floor(at.xy), 1.0, 2.0);
    v.x += 0.5;
    v.y *= 2;
    v.z -= v.x;
    v.w /= 4.0;
    v[0] += 1.0;
    v[x & 3] *= 2.0;
    v[u32(x) % 4u] += 0.25;
    v.r += 1.0;
    v.g -= 1.0;
    v.b = v.a;
    var k = vec3i(x, 2, 3);
    k.x <<= 2u;
    k.y %= 2;
    k[x % 3] |= 64;
    k[x % 3]++;
    k.z--;
    v += vec4f(vec3f(k), 0.0);
    v *= 0.5;
    v -= 1.0;
    return v;
}

// PLACEHOLDER until branch `orders` is merged: isotropic two-stream guess of the light beyond the first order.

#include <sky/medium.wgsl>

fn orders_source(height: f32, sun_mu: f32, cos_theta: f32) -> vec3f {
    let d = medium_density(height);
    let scattering = 1e-6 * (d.x * sky.rayleigh_scattering + d.y * sky.mie_scattering);
    let up = smoothstep(-0.12, 0.3, sun_mu);
    return 0.05 * up * exp(-0.2 * max(-sun_mu, 0.0)) * scattering;
}

fn orders_irradiance(height: f32, sun_mu: f32) -> vec3f {
    return vec3f(0.06, 0.1, 0.16) * smoothstep(-0.1, 0.5, sun_mu);
}

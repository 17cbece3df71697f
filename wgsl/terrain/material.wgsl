// What the ground is made of, place by place.

/// What covers the land: bands of mud, sand, grass, rock and snow by height and slope; sand only; or layered rock.
#option ground.cover = bands { bands, sand, strata }

/// Ground as light meets it.
struct Surface {
    /// Reflectance, linear sRGB.
    albedo: vec3f,
    /// Unit normal, with what is too small for the height: ripples, grain.
    normal: vec3f,
}

#if ground.cover == sand
#include <terrain/sand.wgsl>
#elif ground.cover == strata
#include <terrain/strata.wgsl>
#else
#include <terrain/bands.wgsl>
#endif

/// The ground at `position` (m) with unit `normal`, seen by a pixel `footprint` (m) wide.
fn terrain_material(position: vec3f, normal: vec3f, footprint: f32) -> Surface {
#if ground.cover == sand
    return sand_surface(position, normal, footprint);
#elif ground.cover == strata
    return strata_surface(position, normal, footprint);
#else
    return bands_surface(position, normal, footprint);
#endif
}

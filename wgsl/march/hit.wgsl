// What every march hands back.

/// Where a ray ended.
struct MarchHit {
    /// Distance along the ray (m): to the surface if `hit`, else the `far` that it was given.
    distance: f32,
    /// Whether it met the surface.
    hit: bool,
    /// Steps that it took, those of the refinement included.
    steps: i32,
    /// Evaluations of the slot: of the whole height, of the distance, or of single octaves, as the march says.
    evaluations: i32,
}

/// Where a ray ended, and up to where nothing that stands on the surface can be met either.
struct MarchApproach {
    hit: MarchHit,
    /// As far along the ray (m) as the march saw it stay at a given height above the surface, or higher; 0 where it did
    /// not look.
    clear: f32,
}

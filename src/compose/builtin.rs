//! WGSL's own functions, as far as composing has to know them.

/// Whether `name` can fill a slot: it is one of WGSL's functions, and has one signature a type.
pub(super) fn is_builtin_function(name: &str) -> bool {
    const NAMES: &str = "abs acos acosh all any asin asinh atan atan2 atanh ceil clamp cos cosh countLeadingZeros \
        countOneBits countTrailingZeros cross degrees distance dot dpdx dpdy exp exp2 faceForward \
        firstLeadingBit firstTrailingBit floor fma fract fwidth inverseSqrt ldexp length log log2 max \
        min mix normalize pow radians reflect refract reverseBits round saturate select sign sin sinh \
        smoothstep sqrt step tan tanh transpose trunc determinant extractBits insertBits";
    NAMES.split_whitespace().any(|known| known == name)
}

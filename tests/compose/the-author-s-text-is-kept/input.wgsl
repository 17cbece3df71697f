// SPDX-License-Identifier: MIT
// Copyright somebody.

/* A block /* in a block */ comment. */
const ODD  =  1.50e+00f ; // spelled oddly
const HEX = 0xFFu; const TWICE = 0x1.8p1;   // two on a line

/**
 * Documented the old way.
 */
fn   spaced ( x :f32 )->f32{ return x ; } // after it

    // indented comment
    @fragment fn main(
        @builtin(position) p: vec4f, // where
    ) -> @location(0) vec4f { return vec4f(spaced(ODD) + f32(HEX) + TWICE) * p; }
// the end
/* a /* nested /* thrice */ */ comment */
//! module words
/// Doc of a constant. // and more
const a /* between */ = /**/ 1.0; // trailing { ( <

/* unused: */ fn unused() -> f32 { return a; }
@fragment /* here */ fn /* too */ main(/* nothing */) -> /* and */ @location(/*0*/ 0) vec4f {
    // "no strings" 'in' WGSL
    return vec4f(a); /* } */
}
// the last word

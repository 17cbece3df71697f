// Comments with quotes, preprocessor lines, non-ASCII and what would end them in GLSL.

// #define x 3
// */ "unclosed 'quotes' /* in a line comment
/* // a line comment in a block */
/* "*/ const Q = 2.0; /* /* " */ ' */
/*/ not closed yet /*/ */ */
// größer ≥ 1 … 日本語 🏔

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x); /**/ let y = x /***/ * /**//**/ 2.0; //
    let z = x /* / * */ / /* * / */ 2.0;
    return vec4f(x, y, z, Q) /// the end
        ;
}

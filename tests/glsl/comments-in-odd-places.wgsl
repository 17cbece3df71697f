// Comments stand wherever white space may; block comments nest. /* this one does not open */

/* a block /* in a block */ still a comment */
const A /* name */ = /* value */ 2.0 /* end */; // behind a declaration

/// A doc comment.
fn f(/* nothing yet */ a: f32, // the first
    /* the second */ b: f32 /* no comma */) /* gives */ -> /* a number */ f32 /* body: */ { // opens
    // alone
    return a /* times */ * /**/ b // no semicolon yet
        + A; /* behind */ // twice
    // at the end
} // closes

struct S { // first line
    a: f32, // a's
    /* b's */ b: vec2f, /* after */
    // last line
}

@fragment /* stage */
fn main_fragment(@builtin(/* which */ position) at: vec4f) -> @location(0 /* zero */) vec4f {
    var s = /* made */ S(/* a */ 1.0, /* b */ vec2f(/* one for all */ 2.0)); //* not a block
    if /* so */ at.x > 3.0 /* then */ { /* empty */ } else /* else */ { s.a /* plus */ += 1.0; }
    for (/* init */ var i = 0; /* test */ i < 2; /* step */ i++ /* end */) { s.b.x += f32(i); }
    switch /* of */ i32(at.y) /* kinds */ { /* none */ case /* one */ 1: { s.a = 5.0; } /* rest */ default: { } }
    /* here */ return /* there */ vec4f(f(s.a, floor(at.x)), s.b, /* last: */ 0.0 /* trailing */, /* comma */);
    /* unreached */
}
// the end, without a newline \

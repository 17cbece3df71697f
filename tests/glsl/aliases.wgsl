// Of scalars, vectors, matrices, arrays, structures and of other aliases; used as types and as constructors.

alias Real = f32;
alias Count = u32;
alias Place = vec3<Real>;
alias Frame = mat3x3<Real>;
alias Path = array<Place, 2>;
alias Answer = bool;

struct Body { place: Place, frame: Frame }
alias Thing = Body;
alias Things = array<Thing, 2>;

fn move_by(thing: Thing, by: Place) -> Thing {
    return Thing(thing.place + thing.frame * by, thing.frame);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let frame = Frame(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    var things = Things(Thing(Place(), frame), Body(Place(1.0), frame));
    let path = Path(Place(floor(at.xy), 2.0), Place(3));
    let n = Count(at.x) % 2u;
    things[n] = move_by(things[n], path[0]);
    let answer: Answer = things[1].place.x > Real(n);
    return vec4f(things[0].place + path[1], things[1].place.y) + select(Real(0), Real(1), answer);
}

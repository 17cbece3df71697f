// What a function does to its copy of a structure with arrays does not reach the caller.

struct Bag { items: array<i32, 3>, count: i32 }

fn with_item(bag: Bag, item: i32) -> Bag {
    var next = bag;
    next.items[next.count % 3] = item;
    next.count += 1;
    return next;
}

fn total(bag: Bag) -> i32 {
    var sum = 0;
    for (var i = 0; i < 3; i++) { sum += bag.items[i] * (i + 1); }
    return sum;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let empty = Bag();
    let one = with_item(empty, i32(at.x));
    var bag = one;
    for (var i = 0; i < i32(at.y) % 5; i++) { bag = with_item(bag, i + 10); }
    return vec4i(total(empty), total(one), total(bag), bag.count);
}

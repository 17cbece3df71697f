// No view: no picture.
fn stesp() {}

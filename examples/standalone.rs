//! A preset becomes a standalone shader.
fn main() -> Result<(), orogen::Error> {
    let library = orogen::Library::standard();
    let mut args = std::env::args().skip(1);
    let name = args.next().unwrap_or("alpine".into());
    let live: Vec<String> = args.collect();
    let preset =
        if name.ends_with(".wgsl") { orogen::Preset::of_file(&name) } else { orogen::Preset::named(&name)? };
    let shader = orogen::compose(&library, &preset, &orogen::Bake::live(live))?;
    println!("{}", shader.wgsl());
    Ok(())
}

//! Throwaway.
#![allow(missing_docs, clippy::all, clippy::unwrap_used, clippy::panic, clippy::print_stdout)]
use cpu_time::ProcessTime;
use orogen::render::{Format, Gpu, Shot, encode, render};
use orogen::{Bake, Library, Preset, Shader};
use std::time::Instant;

fn shader(library: &Library, name: &str, sets: &[String]) -> (Shader, Preset) {
    let mut preset = Preset::named(name).unwrap();
    for s in sets {
        preset.set(s).map_err(|e| e.render(false)).unwrap();
    }
    let s = orogen::compose(library, &preset, &Bake::constants()).map_err(|e| e.render(false)).unwrap();
    (s, preset)
}
/// (seconds a frame, seconds until the first is there, the picture)
fn draw(gpu: &Gpu, s: &Shader, p: &Preset, w: u32, h: u32, n: u32) -> (f64, f64, orogen::render::Picture) {
    let shot = Shot { samples: n + 1, tile: Some(2048), ..Shot::new(w, h) };
    let cpu = ProcessTime::now();
    let mut first = None;
    let mut best = f64::INFINITY;
    let mut prev = 0.0;
    let pic = render(gpu, s, p, &shot, &mut |_, _| {
        let now = cpu.elapsed().as_secs_f64();
        if first.is_none() {
            first = Some(now);
        } else {
            best = best.min(now - prev);
        }
        prev = now;
    })
    .unwrap();
    (best, first.unwrap(), pic)
}
/// profile [-r ROUNDS] [-s WxH] [-o DIR] [-a set,set] PRESET... -- VARIANT... ; a variant: set,set,...
fn main() {
    let mut args = std::env::args().skip(1);
    let (mut rounds, mut w, mut h, mut out, mut folder) = (3, 480, 270, None::<String>, "wgsl".to_owned());
    let mut names = vec![];
    let mut variants: Vec<Vec<String>> = vec![];
    let mut after = false;
    while let Some(a) = args.next() {
        if after {
            variants.push(a.split(';').filter(|x| !x.is_empty()).map(str::to_owned).collect());
            continue;
        }
        match a.as_str() {
            "-r" => rounds = args.next().unwrap().parse().unwrap(),
            "-s" => {
                let v = args.next().unwrap();
                let (a, b) = v.split_once('x').unwrap();
                w = a.parse().unwrap();
                h = b.parse().unwrap();
            }
            "-o" => out = args.next(),
            "-w" => folder = args.next().unwrap(),
            "--" => after = true,
            _ => names.push(a),
        }
    }
    if variants.is_empty() {
        variants = vec![vec!["quality=low".into()], vec!["quality=high".into()]];
    }
    let gpu = Gpu::new(None).map_err(|e| e.render(false)).unwrap();
    let library = Library::standard().with_folder(&folder).unwrap();
    for name in &names {
        println!("{name}");
        let mut med = vec![];
        for v in &variants {
            let (s, p) = shader(&library, name, v);
            let (t, c, pic) = draw(&gpu, &s, &p, w, h, rounds);
            if let Some(dir) = &out {
                std::fs::create_dir_all(dir).unwrap();
                let tag = v.join("+").replace("quality=", "").replace('/', "_");
                std::fs::write(format!("{dir}/{name}-{tag}.png"), encode(&pic, Format::Png).unwrap())
                    .unwrap();
            }
            println!("  {t:>8.3}  compile {:>6.2}  {}", c - t, v.join(" "));
            med.push(t);
        }
        if variants.len() == 2 {
            println!("  {name:<20} {:.3}  ratio {:.2}", med[0], med[0] / med[1]);
        }
    }
}

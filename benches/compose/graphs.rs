//! Module graphs of any size, for benches: the same text a module, whatever the shape.

use orogen::{Library, Preset};

/// How modules include one another.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// Each includes the next.
    Chain,
    /// Each includes two of the layer below.
    Diamond,
    /// The root includes all.
    Wide,
}

/// A generated graph: `modules` fragments of `functions` functions each, all of them reachable from the root.
pub(crate) struct Graph {
    /// The fragments.
    pub(crate) library: Library,
    /// The root, which includes them.
    pub(crate) root: Preset,
    /// The path of a fragment that includes nothing.
    pub(crate) leaf: String,
}

/// The text of module `index`; `salt` makes a changed version of it.
pub(crate) fn module(index: usize, functions: usize, includes: &[usize], salt: u32) -> String {
    let mut text = format!("// Module {index} of a generated graph.\n\n");
    for include in includes {
        text.push_str(&format!("#include <m{include}.wgsl>\n"));
    }
    text.push('\n');
    for function in 0..functions {
        let below = match includes {
            [] => "x * 0.5".to_owned(),
            some => format!("m{}_f{function}(x * 0.5, octaves)", some[function % some.len()]),
        };
        let before =
            if function == 0 { "x".to_owned() } else { format!("m{index}_f{}(x, octaves)", function - 1) };
        text.push_str(&format!(
            "/// Value {function} of module {index} at `x`, in -1 .. 1.\n\
             fn m{index}_f{function}(x: f32, octaves: i32) -> f32 {{\n\
             \x20   var sum = {salt}.0;\n\
             \x20   var amplitude = 0.5; // halves an octave\n\
             \x20   for (var octave = 0; octave < octaves; octave += 1) {{\n\
             \x20       let phase = x * f32(octave + {function}) + 0.25;\n\
             \x20       sum += amplitude * sin(phase) * cos(phase * 1.7);\n\
             \x20       amplitude *= 0.5;\n\
             \x20   }}\n\
             \x20   let weight = clamp(sum * 0.5 + 0.5, 0.0, 1.0);\n\
             \x20   if weight > 0.75 {{\n\
             \x20       return mix({below}, {before}, weight);\n\
             \x20   }}\n\
             \x20   return sum;\n\
             }}\n\n"
        ));
    }
    text
}

fn includes(shape: Shape, modules: usize, index: usize) -> Vec<usize> {
    const WIDTH: usize = 8;
    match shape {
        Shape::Chain => (index + 1 < modules).then_some(index + 1).into_iter().collect(),
        Shape::Wide => Vec::new(),
        Shape::Diamond => {
            let layer = (index / WIDTH + 1) * WIDTH;
            let below = [layer + index % WIDTH, layer + (index + 1) % WIDTH];
            below.into_iter().filter(|below| *below < modules).collect()
        }
    }
}

/// A graph of that shape and size.
pub(crate) fn graph(shape: Shape, modules: usize, functions: usize) -> Graph {
    let mut library = Library::empty();
    for index in 0..modules {
        let text = module(index, functions, &includes(shape, modules, index), 0);
        library = library.with_file(format!("m{index}.wgsl"), text);
    }
    let roots: Vec<_> = match shape {
        Shape::Chain => vec![0],
        Shape::Diamond => (0..8.min(modules)).collect(),
        Shape::Wide => (0..modules).collect(),
    };
    let mut root = String::new();
    for index in &roots {
        root.push_str(&format!("#include <m{index}.wgsl>\n"));
    }
    root.push_str("\n@group(0) @binding(0) var<storage, read_write> result: array<f32>;\n\n@compute @workgroup_size(64)\n");
    root.push_str("fn main(@builtin(global_invocation_id) id: vec3u) {\n    var sum = 0.0;\n");
    for index in &roots {
        for function in 0..functions {
            root.push_str(&format!("    sum += m{index}_f{function}(f32(id.x), 4);\n"));
        }
    }
    root.push_str("    result[id.x] = sum;\n}\n");
    Graph { library, root: Preset::of_text("root.wgsl", &root), leaf: format!("m{}.wgsl", modules - 1) }
}

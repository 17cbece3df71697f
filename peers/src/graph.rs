//! Module graphs of any size and shape, in three dialects: the functions are the same text in all of them, and only what each
//! tool has its own words for differs (where a module's names come from, conditions, settings).

use std::fmt::Write;
use std::sync::Arc;

/// How modules include one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Each includes the next.
    Chain,
    /// Each includes two of the layer below, eight a layer.
    Diamond,
    /// The root includes all.
    Wide,
}

impl Shape {
    pub(crate) const ALL: [Self; 3] = [Self::Chain, Self::Diamond, Self::Wide];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Chain => "chain",
            Self::Diamond => "diamond",
            Self::Wide => "wide",
        }
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|shape| shape.name() == name)
    }
}

/// Whose words a graph is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dialect {
    Orogen,
    NagaOil,
    Wesl,
}

/// What a graph is like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Plan {
    pub(crate) shape: Shape,
    pub(crate) modules: usize,
    /// Functions a module.
    pub(crate) functions: usize,
}

/// What is set from outside: one option and one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Settings {
    /// Every fourth module has a constant of one value or another by it.
    pub(crate) fine: bool,
    /// In percent; every fourth module reads it.
    pub(crate) gain: i32,
}

impl Default for Settings {
    fn default() -> Self {
        Self { fine: true, gain: 50 }
    }
}

/// One file of a graph.
pub(crate) struct File {
    /// Without its extension: `m7`.
    pub(crate) name: String,
    pub(crate) text: Arc<str>,
}

/// A graph in one dialect.
pub(crate) struct Graph {
    /// Each after those that it includes; the root is not among them.
    pub(crate) modules: Vec<File>,
    /// The root's text: a compute shader that calls every function of the modules that it includes.
    pub(crate) root: String,
}

const WIDTH: usize = 8;

impl Plan {
    pub(crate) fn name(self) -> String {
        format!("{} {}×{}", self.shape.name(), self.modules, self.functions)
    }

    /// Whom a module includes.
    pub(crate) fn includes(self, index: usize) -> Vec<usize> {
        let below = match self.shape {
            Shape::Wide => return Vec::new(),
            Shape::Chain => vec![index + 1],
            Shape::Diamond => {
                let layer = (index / WIDTH + 1) * WIDTH;
                vec![layer + index % WIDTH, layer + (index + 1) % WIDTH]
            }
        };
        below.into_iter().filter(|below| *below < self.modules).collect()
    }

    /// Whom the root includes.
    pub(crate) fn roots(self) -> Vec<usize> {
        match self.shape {
            Shape::Chain => vec![0],
            Shape::Diamond => (0..WIDTH.min(self.modules)).collect(),
            Shape::Wide => (0..self.modules).collect(),
        }
    }

    /// A module that includes no other.
    pub(crate) fn leaf(self) -> usize {
        self.modules - 1
    }

    pub(crate) fn graph(self, dialect: Dialect) -> Graph {
        // Whoever is included has the higher number.
        let modules = (0..self.modules).rev();
        let file = |index| File { name: format!("m{index}"), text: self.module(dialect, index, 0).into() };
        Graph { modules: modules.map(file).collect(), root: self.root(dialect) }
    }

    /// The text of one module; `salt` makes a changed version of it.
    pub(crate) fn module(self, dialect: Dialect, index: usize, salt: u32) -> String {
        let includes = self.includes(index);
        let has_detail = index.is_multiple_of(4);
        let has_gain = index % 4 == 1;
        let mut text = String::new();
        if dialect == Dialect::NagaOil {
            let _ = writeln!(text, "#define_import_path m{index}\n");
        }
        let _ = writeln!(text, "// Module {index} of a generated graph.\n");
        for include in &includes {
            let functions =
                (0..self.functions).filter(|function| includes[function % includes.len()] == *include);
            text += &import(dialect, *include, functions);
        }
        if has_detail && dialect == Dialect::Orogen || has_gain {
            text += &import_settings(dialect);
        }
        text.push('\n');
        if has_detail {
            let constant = |value| format!("const m{index}_detail: f32 = {value};\n");
            text += &choice(dialect, &constant("1.5"), &constant("0.75"));
            text.push('\n');
        }
        for function in 0..self.functions {
            let below = match includes.as_slice() {
                [] => "x * 0.5".to_owned(),
                some => format!("m{}_f{function}(x * 0.5, octaves)", some[function % some.len()]),
            };
            let factor = match (has_detail, has_gain, dialect) {
                (true, ..) => format!(" * m{index}_detail"),
                (_, true, Dialect::Orogen) => " * f32(detail.gain) * 0.01".to_owned(),
                (_, true, Dialect::NagaOil) => " * f32(#{GAIN}) * 0.01".to_owned(),
                (_, true, Dialect::Wesl) => " * f32(gain) * 0.01".to_owned(),
                _ => String::new(),
            };
            let _ = write!(
                text,
                "/// Value {function} of module {index} at `x`, in -1 .. 1.\n\
                 fn m{index}_f{function}(x: f32, octaves: i32) -> f32 {{\n\
                 \x20   var sum = {salt}.0;\n\
                 \x20   var amplitude = 0.5; // halves an octave\n\
                 \x20   for (var octave = 0; octave < octaves; octave += 1) {{\n\
                 \x20       let phase = x * f32(octave + {function}) + 0.25;\n\
                 \x20       sum += amplitude * sin(phase) * cos(phase * 1.7){factor};\n\
                 \x20       amplitude *= 0.5;\n\
                 \x20   }}\n\
                 \x20   let weight = clamp(sum * 0.5 + 0.5, 0.0, 1.0);\n\
                 \x20   if weight > 0.75 {{\n\
                 \x20       return mix({below}, sum, weight);\n\
                 \x20   }}\n\
                 \x20   return sum;\n\
                 }}\n\n"
            );
        }
        text
    }

    fn root(self, dialect: Dialect) -> String {
        let mut text = String::from("// The root of a generated graph.\n\n");
        for index in self.roots() {
            text += &import(dialect, index, 0..self.functions);
        }
        text += "\n@group(0) @binding(0) var<storage, read_write> result: array<f32>;\n\n@compute @workgroup_size(64)\n";
        text += "fn main(@builtin(global_invocation_id) id: vec3u) {\n    var sum = 0.0;\n";
        for index in self.roots() {
            for function in 0..self.functions {
                let _ = writeln!(text, "    sum += m{index}_f{function}(f32(id.x) * 0.01, 4);");
            }
        }
        text += "    result[id.x] = sum;\n}\n";
        text
    }
}

/// The file that declares what is set, where a dialect has one.
pub(crate) fn settings(dialect: Dialect, settings: Settings) -> Option<String> {
    match dialect {
        Dialect::Orogen => Some(
            "// What is set from outside.\n\n/// How strong it is.\n#param detail.gain: i32 = 50, range 0 .. 100\n\
             /// Whether it is fine.\n#option detail.fine = true\n"
                .to_owned(),
        ),
        Dialect::NagaOil => None, // definitions are handed over in Rust
        Dialect::Wesl => {
            Some(format!("// What is set from outside.\n\n/// How strong it is.\nconst gain: i32 = {};\n", settings.gain))
        }
    }
}

/// The lines that make `functions` of a module known.
pub(crate) fn import(dialect: Dialect, index: usize, functions: impl Iterator<Item = usize>) -> String {
    let names: Vec<String> = functions.map(|function| format!("m{index}_f{function}")).collect();
    match dialect {
        Dialect::Orogen => format!("#include <m{index}.wgsl>\n"),
        Dialect::NagaOil => format!("#import m{index}::{{{}}}\n", names.join(", ")),
        Dialect::Wesl => format!("import package::m{index}::{{{}}};\n", names.join(", ")),
    }
}

fn import_settings(dialect: Dialect) -> String {
    match dialect {
        Dialect::Orogen => "#include <settings.wgsl>\n".to_owned(),
        Dialect::NagaOil => String::new(),
        Dialect::Wesl => "import package::settings::gain;\n".to_owned(),
    }
}

/// `yes` where `fine` is set, else `no`.
pub(crate) fn choice(dialect: Dialect, yes: &str, no: &str) -> String {
    match dialect {
        Dialect::Orogen => format!("#if detail.fine\n{yes}#else\n{no}#endif\n"),
        Dialect::NagaOil => format!("#if FINE == true\n{yes}#else\n{no}#endif\n"),
        Dialect::Wesl => format!("@if(fine) {yes}@else {no}"),
    }
}

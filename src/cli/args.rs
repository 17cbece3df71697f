//! The command line, as `--help` tells it.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

const ALL_AROUND: &str = "\
Examples:
  orogen render alpine --set sun.elevation=6 --samples 8 -o dusk.png
  orogen render alpine --frames 48 --fps 24 -o clouds.png               clouds_0001.png and 47 more
  orogen render world.json -I shaders --watch -o world.png              anew on every save of any of its files
  orogen render alpine --projection equirectangular -o panorama.jpg     all around, 2:1
  orogen render alpine --projection cube -o sky.exr                     a skybox in linear light
  orogen render alpine --projection cube --faces -o sky.png             sky_px.png, sky_nx.png, …
A preset may ask for it itself: \"camera\": { \"projection\": \"cube\" }; so may an export, with --set.

A skybox has six square faces, +X -X +Y -Y +Z -Z from the top: the layers of a cube texture as
they lie in memory, each upright as seen from the inside. Cube textures are left-handed: +X is
east, our +x, but +Z is north, our -z. In a shader of yours, ask for vec3(d.x, d.y, -d.z).
  Bevy      image.reinterpret_stacked_2d_as_array(6), a texture view of dimension Cube, and
            Skybox { image, .. } shows it the right way round
  three.js  new CubeTextureLoader().load([\"sky_px.png\", \"sky_nx.png\", \"sky_py.png\", \"sky_ny.png\",
            \"sky_pz.png\", \"sky_nz.png\"]), and scene.backgroundRotation.y = Math.PI;
            a panorama with --set camera.azimuth=90 and EquirectangularReflectionMapping
            needs no turning
The middle of a panorama is toward camera.azimuth, its horizon level. A skybox is never turned.";

const EXAMPLES: &str = "\
Examples:
  orogen list presets                                  what there is to start from
  orogen export alpine -o alpine.wgsl                  a standalone shader
  orogen export alpine --target shadertoy -o alpine.glsl
  orogen render alpine --set sun.elevation=6 -o dusk.png
  orogen render alpine --view steps -o steps.png       a debug view: `orogen list views` names them
  orogen heightmap alpine -o land.r16                  its land, for an engine's own terrain
  orogen params alpine                                 what can be set, and to what
  orogen export alpine --live 'sun.*' --target json    where a host finds the live parameters
  orogen export '<sky/atmosphere.wgsl>' --prefix og_   a module to paste into a shader of yours
  orogen export alpine --module terrain/height.wgsl    the same, with the preset's values
  orogen export alpine --target wesl -o assets/alpine  a WESL package, for Bevy and other hosts of WESL

A PRESET is a built-in name (alpine), the path of a .json file, the path of a .wgsl file, or a module of the library in
angle brackets ('<noise/perlin.wgsl>').

Exit status: 0 done; 1 the input is wrong; 2 usage; 3 no GPU adapter.";

/// Composes WGSL fragments for natural environments into shaders and pictures.
#[derive(Parser)]
#[command(name = "orogen", version, after_help = EXAMPLES, max_term_width = 110)]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) common: Common,
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Clone, Args)]
pub(super) struct Common {
    /// Lay a folder of fragments over the library (repeatable; the last one wins)
    #[arg(short = 'I', id = "folders", value_name = "DIR", global = true)]
    pub(super) folders: Vec<PathBuf>,
    /// Set a parameter or an option over the preset's value (repeatable)
    #[arg(long, value_name = "GROUP.NAME=VALUE", global = true)]
    pub(super) set: Vec<String>,
    /// How much work for how good a picture: low, medium, high or ultra; the preset's unless told
    #[arg(long, value_name = "NAME", global = true, value_parser = ["low", "medium", "high", "ultra"], hide_possible_values = true)]
    pub(super) quality: Option<String>,
    /// Lay a folder over the templates that say what the files look like
    #[arg(long, value_name = "DIR", global = true)]
    pub(super) templates: Option<PathBuf>,
    /// No progress and no hints on standard error
    #[arg(short, long, global = true)]
    pub(super) quiet: bool,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Write a preset or a fragment as a shader
    Export(Export),
    /// Say whether presets and fragments are valid
    Check(Check),
    /// Render a preset or a fragment into a picture
    Render(Render),
    /// Say what can be set in a preset's scene
    Params(Params),
    /// List what the library has, one a line: name, tab, what it is
    List(List),
    /// Evaluate a WGSL expression on the GPU, CSV out
    Eval(Eval),
    /// Write the heights of a preset's land: tiles for an engine's own terrain
    Heightmap(Heightmap),
}

#[derive(Clone, Args)]
pub(super) struct Baking {
    /// Keep these parameters live, in a uniform buffer: 'sun.*,clouds.coverage', a group, or 'default' for those
    /// declared `live`; wins over --overrides
    #[arg(long, value_name = "GLOB,…", value_delimiter = ',', value_parser = glob)]
    pub(super) live: Vec<String>,
    /// Make these parameters pipeline overrides, but for those that --live matches
    #[arg(long, value_name = "GLOB,…", value_delimiter = ',', value_parser = glob)]
    pub(super) overrides: Vec<String>,
}

#[derive(Clone, Args)]
pub(super) struct Viewing {
    /// A debug view in the place of the picture: steps, normals, …; `orogen list views` names them all
    #[arg(long, value_name = "NAME")]
    pub(super) view: Option<String>,
}

#[derive(Args)]
pub(super) struct Export {
    /// Built-in preset, .json file, .wgsl file, or '<module>' of the library; for wesl, the whole library where it is left out
    #[arg(value_name = "PRESET|FILE")]
    pub(super) preset: Option<String>,
    #[command(flatten)]
    pub(super) viewing: Viewing,
    /// What to write
    #[arg(long, value_enum, default_value = "wgsl")]
    pub(super) target: Target,
    /// Which entry point a scene gets: fragment, unless told
    #[arg(long, value_enum)]
    pub(super) stage: Option<Stage>,
    #[command(flatten)]
    pub(super) baking: Baking,
    /// Write it in fewer bytes: short names, no comments, no blank space, one line with the licences (wgsl, glsl and
    /// shadertoy). Entry points, overrides, bindings and live parameters keep their names
    #[arg(long)]
    pub(super) minify: bool,
    /// Of a Shadertoy file, write two: FILE for the tab Image, and beside it NAME.common.glsl with the library's functions
    /// for the tab Common
    #[arg(long, conflicts_with_all = ["minify", "source_map"])]
    pub(super) common: bool,
    /// A fragment of the library in the place of the preset's picture, on its own, with the preset's values:
    /// terrain/height.wgsl
    #[arg(long, value_name = "PATH", conflicts_with = "view")]
    pub(super) module: Option<String>,
    /// Of a fragment, only these functions, types and constants, and what they reach
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub(super) only: Vec<String>,
    /// What every name of module scope is to start with, so that it collides with nothing: og_
    #[arg(long, value_name = "PREFIX", default_value = "")]
    pub(super) prefix: String,
    /// Bind group and binding of the buffer of live parameters
    #[arg(long, value_name = "GROUP,BINDING", default_value = "0,0", value_parser = binding)]
    pub(super) binding: (u32, u32),
    /// What vectors are in Rust
    #[arg(long, value_enum, default_value = "arrays")]
    pub(super) types: Types,
    /// Leave the layouts of bind groups out of Rust, for a host without wgpu
    #[arg(long)]
    pub(super) no_layouts: bool,
    /// Write a Source Map (v3) beside the file, as FILE.map (wgsl only)
    #[arg(long)]
    pub(super) source_map: bool,
    /// Keep declarations that no entry point reaches; for wesl, write the whole library with the preset's values, its options as
    /// features
    #[arg(long)]
    pub(super) keep_unused: bool,
    /// Where to write; '-' is standard output; for wesl, a folder: one that is empty or holds an earlier package
    #[arg(short, value_name = "FILE|-|DIR", default_value = "-")]
    pub(super) output: PathBuf,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Target {
    /// One standalone WGSL module
    Wgsl,
    /// A GLSL file to paste into Shadertoy
    Shadertoy,
    /// A GLSL ES 3.00 fragment shader
    Glsl,
    /// An Interactive Shader Format file: GLSL with a JSON header, whose inputs are the live parameters
    Isf,
    /// A WGSL file to paste into compute.toys
    ComputeToys,
    /// SPIR-V 1.3, binary
    Spirv,
    /// HLSL, shader model 6.0
    Hlsl,
    /// Metal Shading Language
    Msl,
    /// The interface: entry points, bindings, uniform layout, overrides, parameters
    Json,
    /// Rust: live parameters as structs, names of overrides, layouts of bind groups, and the WGSL
    Rust,
    /// A WESL package: a folder with a module for each fragment, parameters as constants of the module `parameters`
    Wesl,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Types {
    /// [f32; 3]
    Arrays,
    /// glam::Vec3
    Glam,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Stage {
    /// A vertex and a fragment entry point
    Fragment,
    /// A compute entry point that writes a storage texture
    Compute,
}

#[derive(Args)]
pub(super) struct Check {
    /// Built-in presets, .json files, .wgsl files, or '<modules>' of the library
    #[arg(value_name = "PRESET|FILE", required = true)]
    pub(super) presets: Vec<String>,
    /// How to say what is wrong: text on standard error, or one JSON object a line on standard output
    #[arg(long, value_enum, default_value = "text")]
    pub(super) message_format: MessageFormat,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum MessageFormat {
    /// For people
    Text,
    /// For editors and scripts
    Json,
}

#[derive(Clone, Args)]
#[command(after_long_help = ALL_AROUND, after_help = "--help says more, with examples: panoramas, skyboxes for Bevy and three.js.")]
pub(super) struct Render {
    /// Built-in preset, .json file or .wgsl file
    #[arg(value_name = "PRESET|FILE")]
    pub(super) preset: String,
    #[command(flatten)]
    pub(super) viewing: Viewing,
    /// What the picture shows: what is ahead, or everything around; what the preset says unless told
    #[arg(long, value_enum, value_name = "NAME")]
    pub(super) projection: Option<Projection>,
    /// Of a cube, write six files: NAME_px, _nx, _py, _ny, _pz and _nz
    #[arg(long)]
    pub(super) faces: bool,
    /// Width and height in pixels, of a cube those of each face; 960x540 unless told, all around 2048x1024 or 512x512
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub(super) size: Option<(u32, u32)>,
    /// Frames to average for every picture, each with its rays moved inside the pixel
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub(super) samples: u32,
    /// The time of the (first) picture, in seconds; the preset's `frame.time` unless told
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = finite)]
    pub(super) time: Option<f32>,
    /// A drag of the mouse, which turns the camera: where it is now and where it was pressed, in pixels from the bottom
    /// left, as Shadertoy's iMouse; the preset's `frame.mouse` unless told
    #[arg(long, value_name = "X,Y,CLICKX,CLICKY", allow_hyphen_values = true, value_parser = mouse)]
    pub(super) mouse: Option<[f32; 4]>,
    /// Write a sequence of so many pictures, numbered
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(super) frames: Option<u32>,
    /// Pictures a second in a sequence
    #[arg(long, value_name = "F", default_value_t = 30.0, value_parser = rate, requires = "frames")]
    pub(super) fps: f32,
    #[command(flatten)]
    pub(super) baking: Baking,
    /// Stay, and draw again whenever the preset, one that it extends, or a fragment of it on disk is saved; what is wrong
    /// is said, and the picture stays as it was; Ctrl-C ends it
    #[arg(long)]
    pub(super) watch: bool,
    /// Part of the GPU adapter's name; WGPU_ADAPTER_NAME does the same
    #[arg(long, value_name = "NAME")]
    pub(super) adapter: Option<String>,
    /// Where to write: .png (8 bits, sRGB), .jpg (the same, smaller, not exact) or .exr (32-bit floats, linear);
    /// NAME.png unless told, of a view NAME_VIEW.png
    #[arg(short, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Projection {
    /// What is ahead, through a lens
    Perspective,
    /// Everything around in one picture, twice as wide as high
    Equirectangular,
    /// Everything around on the six faces of a cube: a skybox
    Cube,
}

#[derive(Args)]
pub(super) struct Params {
    /// Built-in preset, .json file, .wgsl file, or '<module>' of the library
    #[arg(value_name = "PRESET|FILE")]
    pub(super) preset: String,
    #[command(flatten)]
    pub(super) viewing: Viewing,
    /// How to write it
    #[arg(long, value_enum, default_value = "table")]
    pub(super) format: ParamsFormat,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum ParamsFormat {
    /// Aligned columns: name, type, value, range, what it is
    Table,
    /// All that the declarations say
    Json,
    /// A JSON Schema of the scene's presets
    Schema,
    /// A Markdown table
    Markdown,
}

#[derive(Args)]
pub(super) struct List {
    /// What to list
    #[arg(value_enum)]
    pub(super) what: Listing,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Listing {
    /// Built-in presets
    Presets,
    /// Fragments that are whole pictures
    Scenes,
    /// Debug views of a preset's land, for --view
    Views,
    /// All fragments
    Modules,
    /// What a preset can choose in any of them
    Options,
}

#[derive(Args)]
#[command(after_help = "\
The columns of the points are variables of the expression: 'name' is an f32, 'name:u32' and 'name:i32' are integers.
Columns x,y[,z[,w]] also make the vector p.

  orogen eval 'perlin_noise2(p, 7u)' --include '<noise/perlin.wgsl>' --points points.csv
  orogen eval 'terrain_height(p)' --include '<terrain/height.wgsl>' --preset alpine --points points.csv
  orogen eval 'pcg(i)' --include '<noise/pcg.wgsl>' --points indices.csv       # whose header is i:u32")]
pub(super) struct Eval {
    /// A WGSL expression
    #[arg(value_name = "EXPR", allow_hyphen_values = true)] // `-1.0` is one
    pub(super) expression: String,
    /// A fragment whose functions the expression calls: '<noise/perlin.wgsl>' of the library, or a file (repeatable)
    #[arg(long, value_name = "FRAGMENT")]
    pub(super) include: Vec<String>,
    /// The preset whose values the parameters have; their defaults unless told
    #[arg(long, value_name = "PRESET")]
    pub(super) preset: Option<String>,
    /// CSV of the points to evaluate at; '-' is standard input; without it, one evaluation
    #[arg(long, value_name = "FILE.csv|-")]
    pub(super) points: Option<PathBuf>,
    /// Part of the GPU adapter's name; WGPU_ADAPTER_NAME does the same
    #[arg(long, value_name = "NAME")]
    pub(super) adapter: Option<String>,
}

const TILES: &str = "\
Examples:
  orogen heightmap alpine -o land.png                     2048 m from the origin on, every 2 m
  orogen heightmap alpine --origin -9570,-6988 --size 1024 --pixels 513 -o a.r16
  orogen heightmap alpine --origin -8546,-6988 --size 1024 --pixels 513 -o b.r16
                                                          and its eastern neighbour
  orogen heightmap alpine --size 30000 --pixels 1025 --footprint 29 -o far.exr
                                                          far land, without aliasing

The samples reach from edge to edge, SIZE / (N - 1) apart: the last column of a tile is the first
of its eastern neighbour, bit for bit, in every format. So the next tile's origin is SIZE further.
Rows run from north to south (z), each from west to east (x); the origin is the north-western
sample.

What 16 bits mean is the same for all tiles of a preset: the heights that its land can have
anywhere, unless --range says otherwise. height = LOW + value / 65535 * (HIGH - LOW).
  Unreal    .r16 or .png, N = 1009, 2017, 4033; scale Z = 100 * (HIGH - LOW) / 512
  Unity     .r16 as RAW, 16 bit, Windows byte order, N = 513, 1025, 2049; height = HIGH - LOW
  Godot     .exr, 32-bit float, as it is
FILE.json, written beside, has range, origin, spacing, and the tile's lowest and highest height.";

#[derive(Args)]
#[command(after_long_help = TILES, after_help = "--help says more: how tiles fit together, and what engines want.")]
pub(super) struct Heightmap {
    /// Built-in preset, .json file or .wgsl file
    #[arg(value_name = "PRESET|FILE")]
    pub(super) preset: String,
    /// The north-western sample: metres east and south of the world's origin, to the millimetre
    #[arg(long, value_name = "X,Z", default_value = "0,0", allow_hyphen_values = true, value_parser = place)]
    pub(super) origin: [i64; 2],
    /// From the first sample to the last, each way, in metres, to the millimetre
    #[arg(long, value_name = "M", default_value = "2048", value_parser = width)]
    pub(super) size: u64,
    /// Samples each way, 2 to 16385
    #[arg(long, value_name = "N", default_value_t = 1025)]
    pub(super) pixels: u32,
    /// Leave out what is too small to be seen in a pixel this wide, in metres; 0 is the land as meshes stand on it
    #[arg(long, value_name = "M", default_value_t = 0.0)]
    pub(super) footprint: f32,
    /// Heights of black and white in 16-bit files, in metres; those that the preset's land can have, unless told
    #[arg(long, value_name = "LOW,HIGH", allow_hyphen_values = true, value_parser = range)]
    pub(super) range: Option<[f32; 2]>,
    /// Part of the GPU adapter's name; WGPU_ADAPTER_NAME does the same
    #[arg(long, value_name = "NAME")]
    pub(super) adapter: Option<String>,
    /// Where to write: .png (16-bit grey), .r16 or .raw (16-bit little-endian, no header) or .exr (32-bit float, metres);
    /// NAME_height.png unless told
    #[arg(short, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

/// `-9570,-6988.5` in mm.
fn place(text: &str) -> Result<[i64; 2], String> {
    let (x, z) = text.split_once(',').ok_or("write east and south, as in -9570,-6988.5")?;
    Ok([millimetres(x)?, millimetres(z)?])
}

fn width(text: &str) -> Result<u64, String> {
    let wrong = "write metres above 0, as in 2048";
    millimetres(text)?.try_into().ok().filter(|width| *width > 0).ok_or_else(|| wrong.into())
}

/// Metres with at most three decimals → whole millimetres: what was written, and nothing rounded.
fn millimetres(text: &str) -> Result<i64, String> {
    let wrong = || format!("`{text}` is no number of metres with at most three decimals");
    let (sign, digits) = match text.trim().strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text.trim()),
    };
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !(is_digits(whole) && is_digits(part)) || part.len() > 3 || whole.len() + part.len() == 0 {
        return Err(wrong());
    }
    let number = format!("{whole}{part:0<3}").parse::<i64>().map_err(|_| wrong())?;
    Ok(sign * number)
}

fn range(text: &str) -> Result<[f32; 2], String> {
    let wrong = "write the heights of black and white, as in -200,3000";
    let (low, high) = text.split_once(',').ok_or(wrong)?;
    let number = |text: &str| text.trim().parse().ok().filter(|value: &f32| value.is_finite());
    let range = number(low).zip(number(high)).filter(|(low, high)| low < high);
    range.map(|(low, high)| [low, high]).ok_or_else(|| wrong.into())
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let parts = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match parts {
        Some((0, _) | (_, 0)) => Err("a picture has at least one pixel each way".into()),
        Some(size) => Ok(size),
        None => Err("write WIDTHxHEIGHT, as in 960x540".into()),
    }
}

fn binding(text: &str) -> Result<(u32, u32), String> {
    let parts = text.split_once(',');
    let parts =
        parts.and_then(|(group, binding)| Some((group.trim().parse().ok()?, binding.trim().parse().ok()?)));
    parts.ok_or_else(|| "write GROUP,BINDING, as in 2,0".into())
}

fn glob(text: &str) -> Result<String, String> {
    let glob = text.trim();
    if glob.is_empty() {
        Err("write names with commas between, as in 'sun.*,sky'".into())
    } else {
        Ok(glob.into())
    }
}

fn finite(text: &str) -> Result<f32, String> {
    text.parse().ok().filter(|value: &f32| value.is_finite()).ok_or_else(|| "write seconds, as in 7.5".into())
}

fn mouse(text: &str) -> Result<[f32; 4], String> {
    let numbers =
        text.split(',').map(|number| number.trim().parse().ok().filter(|value: &f32| value.is_finite()));
    let four = numbers.collect::<Option<Vec<f32>>>().and_then(|numbers| numbers.try_into().ok());
    four.ok_or_else(|| "write four numbers of pixels, as in 400,300,200,300".into())
}

fn rate(text: &str) -> Result<f32, String> {
    let rate = text.parse().ok().filter(|value: &f32| value.is_finite() && *value > 0.0);
    rate.ok_or_else(|| "write pictures a second, as in 24".into())
}

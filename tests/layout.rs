//! The uniform buffer is laid out as naga lays it out, and as `encase` does; its bytes are the values.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use encase::{ShaderType, UniformBuffer};
use orogen::bake::Field;
use orogen::{Bake, Library, Preset, Shader};
use proptest::prelude::*;

const TYPES: [&str; 7] = ["bool", "i32", "u32", "f32", "vec2f", "vec3f", "vec4f"];

/// A vector as `encase` sees one.
macro_rules! vector {
    ($name:ident, $n:literal) => {
        #[derive(Debug, Clone, Copy, Default)]
        struct $name([f32; $n]);
        impl AsRef<[f32; $n]> for $name {
            fn as_ref(&self) -> &[f32; $n] {
                &self.0
            }
        }
        impl AsMut<[f32; $n]> for $name {
            fn as_mut(&mut self) -> &mut [f32; $n] {
                &mut self.0
            }
        }
        impl From<[f32; $n]> for $name {
            fn from(parts: [f32; $n]) -> Self {
                Self(parts)
            }
        }
        encase::impl_vector!($n, $name, f32; using AsRef AsMut From);
    };
}
vector!(V2, 2);
vector!(V3, 3);
vector!(V4, 4);

/// A parameter's components: whole numbers, so that they are the same in every type.
type Values = [u8; 4];

fn components(ty: &str) -> usize {
    match ty {
        "vec2f" => 2,
        "vec3f" => 3,
        "vec4f" => 4,
        _ => 1,
    }
}

fn written(ty: &str, values: &Values, open: char, close: char) -> String {
    match components(ty) {
        1 if ty == "bool" => (values[0] % 2 == 1).to_string(),
        1 => values[0].to_string(),
        n => {
            let list: Vec<_> = values[..n].iter().map(u8::to_string).collect();
            format!("{open}{}{close}", list.join(", "))
        }
    }
}

/// The groups that parameters belong to in turn.
const TWO: [&str; 2] = ["alpha", "beta"];

/// A fragment with a parameter of each of `types`, all of which it reads.
fn fragment(types: &[&str], groups: &[&str]) -> String {
    let zero = [0; 4];
    let params = types.iter().enumerate().map(|(n, ty)| {
        let group = groups[n % groups.len()];
        format!("#param {group}.p{n}: {ty} = {}\n", written(ty, &zero, '(', ')'))
    });
    let reads = types.iter().enumerate().map(|(n, _)| {
        let group = groups[n % groups.len()];
        format!("    _ = {group}.p{n};\n")
    });
    params.collect::<String>() + "\nfn read() {\n" + &reads.collect::<String>() + "}\n"
}

fn preset(types: &[&str], values: &[Values], groups: &[&str]) -> Preset {
    let mut preset = Preset::of_text("layout.wgsl", &fragment(types, groups));
    for (n, (ty, values)) in types.iter().zip(values).enumerate() {
        let group = groups[n % groups.len()];
        preset.set(&format!("{group}.p{n}={}", written(ty, values, '[', ']'))).unwrap();
    }
    preset
}

fn shader(types: &[&str], groups: &[&str]) -> Shader {
    let preset = preset(types, &[], groups);
    orogen::compose(&Library::empty(), &preset, &Bake::live(["*"])).unwrap()
}

/// Offset of each field but padding, and size of the whole, in naga's module.
fn of_naga(shader: &Shader) -> (Vec<u32>, u32) {
    let module = &shader.checked().module;
    let structs = module.types.iter().find_map(|(_, ty)| match &ty.inner {
        naga::TypeInner::Struct { members, span } => {
            let is_padding =
                |name: &Option<String>| name.as_ref().is_some_and(|name| name.starts_with("_pad"));
            let fields = members.iter().filter(|member| !is_padding(&member.name));
            Some((fields.map(|member| member.offset).collect(), *span))
        }
        _ => None,
    });
    structs.unwrap()
}

/// The numbers of the parameters of [`fragment`] in the order of the buffer: group by group.
fn order(count: usize) -> Vec<usize> {
    (0..count).step_by(2).chain((1..count).step_by(2)).collect()
}

/// Offset of each field and size of the whole, by `encase`'s alignments and sizes: each group as a struct of its own, which
/// starts at a multiple of 16 bytes.
fn of_encase(types: &[&str]) -> (Vec<u32>, u32) {
    let (mut end, mut alignment) = (0, 1);
    let mut offsets = Vec::new();
    for (position, number) in order(types.len()).into_iter().enumerate() {
        let ty = &types[number];
        if number == 1 && position > 0 {
            end = u64::next_multiple_of(end, 16);
        }
        let (align, size) = match *ty {
            "i32" => (i32::METADATA.alignment().get(), i32::METADATA.min_size().get()),
            "f32" => (f32::METADATA.alignment().get(), f32::METADATA.min_size().get()),
            "bool" | "u32" => (u32::METADATA.alignment().get(), u32::METADATA.min_size().get()),
            "vec2f" => (V2::METADATA.alignment().get(), V2::METADATA.min_size().get()),
            "vec3f" => (V3::METADATA.alignment().get(), V3::METADATA.min_size().get()),
            _ => (V4::METADATA.alignment().get(), V4::METADATA.min_size().get()),
        };
        let offset = u64::next_multiple_of(end, align);
        offsets.push(offset as u32);
        (end, alignment) = (offset + size, alignment.max(align));
    }
    (offsets, end.next_multiple_of(alignment) as u32)
}

fn value_of(field: &Field, bytes: &[u8]) -> Vec<f64> {
    let at = field.offset as usize;
    let words = bytes[at..at + field.size as usize].chunks(4).map(|word| <[u8; 4]>::try_from(word).unwrap());
    let read = words.map(|word| match field.ty {
        "i32" => f64::from(i32::from_le_bytes(word)),
        "u32" => f64::from(u32::from_le_bytes(word)),
        _ => f64::from(f32::from_le_bytes(word)),
    });
    read.collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn any_list_of_parameters_is_laid_out_as_naga_and_encase_do(
        list in prop::collection::vec((0..TYPES.len(), any::<Values>()), 1..24)
    ) {
        let types: Vec<_> = list.iter().map(|(ty, _)| TYPES[*ty]).collect();
        let values: Vec<_> = list.iter().map(|(_, values)| *values).collect();
        let shader = shader(&types, &TWO);
        let uniform = shader.interface().uniform.clone().unwrap();
        let offsets: Vec<_> = uniform.fields.iter().map(|field| field.offset).collect();
        let (of_naga, span) = of_naga(&shader);
        let (of_encase, size) = of_encase(&types);
        prop_assert_eq!(&offsets, &of_naga);
        prop_assert_eq!(&offsets, &of_encase);
        // Padding may be aligned to more than the fields are; a multiple of 16 bytes is what every back end gets.
        prop_assert_eq!(span.next_multiple_of(16), size.next_multiple_of(16));
        // Each group lies between multiples of 16 bytes, and nothing else does.
        for group in &uniform.groups {
            let inside = group.offset..group.offset + group.size;
            prop_assert_eq!((group.offset % 16, group.size % 16), (0, 0));
            for field in &uniform.fields {
                let own = field.parameter.starts_with(&format!("{}.", group.name));
                prop_assert_eq!(own, inside.contains(&field.offset));
            }
        }
        prop_assert_eq!(uniform.size, span.next_multiple_of(16));

        let bytes = shader.uniform_bytes(&preset(&types, &values, &TWO)).unwrap();
        prop_assert_eq!(bytes.len(), uniform.size as usize);
        let mut covered = vec![false; bytes.len()];
        for (field, number) in uniform.fields.iter().zip(order(types.len())) {
            let (ty, values) = (&types[number], &values[number]);
            let wanted: Vec<f64> = match *ty {
                "bool" => vec![f64::from(values[0] % 2)],
                ty => values[..components(ty)].iter().map(|value| f64::from(*value)).collect(),
            };
            prop_assert_eq!(value_of(field, &bytes), wanted);
            covered[field.offset as usize..(field.offset + field.size) as usize].fill(true);
        }
        for (byte, covered) in bytes.iter().zip(covered) {
            prop_assert!(covered || *byte == 0, "padding is zero");
        }
    }
}

/// What `encase` writes for a struct, and what we do for the same fields in the same order, in one group.
fn same_bytes(value: &(impl ShaderType + encase::internal::WriteInto), types: &[&str], values: &[Values]) {
    let mut buffer = UniformBuffer::new(Vec::new());
    buffer.write(value).unwrap();
    let mut theirs: Vec<u8> = buffer.into_inner();
    let ours = shader(types, &["alpha"]).uniform_bytes(&preset(types, values, &["alpha"])).unwrap();
    theirs.resize(ours.len(), 0);
    assert_eq!(ours, theirs, "{types:?}");
}

#[test]
fn the_bytes_are_those_of_encase() {
    #[derive(ShaderType)]
    struct Tight {
        a: V3,
        b: f32,
        c: V2,
        d: u32,
        e: i32,
    }
    same_bytes(
        &Tight { a: V3([1.0, 2.0, 3.0]), b: 4.0, c: V2([5.0, 6.0]), d: 7, e: 8 },
        &["vec3f", "f32", "vec2f", "u32", "i32"],
        &[[1, 2, 3, 0], [4, 0, 0, 0], [5, 6, 0, 0], [7, 0, 0, 0], [8, 0, 0, 0]],
    );
    #[derive(ShaderType)]
    struct Loose {
        a: f32,
        b: V2,
        c: f32,
        d: V4,
        e: u32,
        f: V3,
    }
    same_bytes(
        &Loose {
            a: 1.0,
            b: V2([2.0, 3.0]),
            c: 4.0,
            d: V4([5.0, 6.0, 7.0, 8.0]),
            e: 1,
            f: V3([9.0, 10.0, 11.0]),
        },
        &["f32", "vec2f", "f32", "vec4f", "bool", "vec3f"],
        &[[1, 0, 0, 0], [2, 3, 0, 0], [4, 0, 0, 0], [5, 6, 7, 8], [1, 0, 0, 0], [9, 10, 11, 0]],
    );
    #[derive(ShaderType)]
    struct One {
        a: f32,
    }
    same_bytes(&One { a: 9.0 }, &["f32"], &[[9, 0, 0, 0]]);
}

#[test]
fn angles_are_in_radians_in_the_buffer() {
    let text = "#param sun.azimuth: f32 = 90.0, unit deg\nfn f() -> f32 { return sun.azimuth; }\n";
    let mut preset = Preset::of_text("angle.wgsl", text);
    let shader = orogen::compose(&Library::empty(), &preset, &Bake::live(["sun"])).unwrap();
    let field = &shader.interface().uniform.as_ref().unwrap().fields[0];
    assert_eq!((field.unit.as_deref(), field.value.as_f64()), (Some("rad"), Some(1.5707964)));
    preset.set("sun.azimuth=180").unwrap();
    let bytes = shader.uniform_bytes(&preset).unwrap();
    assert_eq!(bytes[..4], std::f32::consts::PI.to_le_bytes());
}

#[test]
fn a_value_out_of_range_points_at_the_setting_and_at_the_declaration() {
    let text = "#param sun.power: f32 = 1.0, range 0 .. 2\nfn f() -> f32 { return sun.power; }\n";
    let shader =
        orogen::compose(&Library::empty(), &Preset::of_text("scene.wgsl", text), &Bake::live(["*"])).unwrap();
    let mut other = Preset::of_text("scene.wgsl", text);
    other.set("sun.power=1").unwrap();
    other.set("sun.power=3").unwrap();
    let error = shader.uniform_bytes(&other).unwrap_err();
    let places: Vec<_> = error.diagnostics()[0]
        .labels
        .iter()
        .map(|label| {
            let file = error.files().get(label.file);
            (&*file.name, file.slice(label.span))
        })
        .collect();
    assert_eq!(places, [("--set", "3"), ("scene.wgsl", "sun.power")]);
    assert!(error.json_lines().contains("scene.wgsl"));
}

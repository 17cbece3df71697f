//! What WGSL has and GLSL ES 3.00 lacks, or leaves undefined: small functions, written into the files that need them.
//!
//! Most are told for one component, and repeated for each of a vector's.

use std::collections::BTreeSet;

use super::super::typed::Scalar;
use super::spelling;
use crate::export::typed::Ty;

/// A function by its name without `wgsl_`, for values of so many components.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Helper {
    name: &'static str,
    scalar: Kind,
    size: u8,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Bool,
    Int,
    Uint,
    Float,
}

impl Kind {
    fn of(scalar: Scalar) -> Self {
        match scalar {
            Scalar::Bool => Self::Bool,
            Scalar::I32 | Scalar::AbstractInt => Self::Int,
            Scalar::U32 => Self::Uint,
            Scalar::F32 | Scalar::AbstractFloat => Self::Float,
        }
    }

    fn ty(self, size: u8) -> String {
        let scalar = match self {
            Self::Bool => Scalar::Bool,
            Self::Int => Scalar::I32,
            Self::Uint => Scalar::U32,
            Self::Float => Scalar::F32,
        };
        spelling::numeric(Ty::of(size, scalar))
    }
}

/// The type of a parameter or a result.
#[derive(Debug, Clone, Copy)]
enum Part {
    /// The one that the helper is asked for.
    T,
    /// As many components of another kind.
    Of(Kind),
    /// One component of another kind, whatever the size.
    One(Kind),
}

/// A function of one component.
struct Plain {
    name: &'static str,
    kind: Kind,
    takes: &'static [(Part, &'static str)],
    gives: Part,
    body: &'static str,
    uses: &'static [(&'static str, Kind)],
}

const AB: &[(Part, &str)] = &[(Part::T, "a"), (Part::T, "b")];
const X: &[(Part, &str)] = &[(Part::T, "x")];
const SELECT: &[(Part, &str)] = &[(Part::T, "f"), (Part::T, "t"), (Part::Of(Kind::Bool), "c")];
const EXTRACT: &[(Part, &str)] =
    &[(Part::T, "x"), (Part::One(Kind::Uint), "offset"), (Part::One(Kind::Uint), "count")];
const INSERT: &[(Part, &str)] =
    &[(Part::T, "x"), (Part::T, "bits"), (Part::One(Kind::Uint), "offset"), (Part::One(Kind::Uint), "count")];

const fn plain(
    name: &'static str,
    kind: Kind,
    takes: &'static [(Part, &'static str)],
    body: &'static str,
) -> Plain {
    Plain { name, kind, takes, gives: Part::T, body, uses: &[] }
}

/// One that does with the bits of an `int` what another does with those of a `uint`.
const fn as_uint(name: &'static str, body: &'static str, uses: &'static [(&'static str, Kind)]) -> Plain {
    Plain { name, kind: Kind::Int, takes: X, gives: Part::T, body, uses }
}

const PLAIN: [Plain; 36] = [
    plain("div", Kind::Int, AB, "return a / (b == 0 || (b == -1 && a == -2147483647 - 1) ? 1 : b);"),
    plain("div", Kind::Uint, AB, "return a / (b == 0u ? 1u : b);"),
    Plain {
        uses: &[("div", Kind::Int)],
        ..plain("rem", Kind::Int, AB, "return a - wgsl_div(a, b) * (b == 0 ? 1 : b);")
    },
    plain("rem", Kind::Uint, AB, "return a % (b == 0u ? 1u : b);"),
    plain("rem", Kind::Float, AB, "return a - b * trunc(a / b);"),
    Plain {
        gives: Part::Of(Kind::Int),
        ..plain("int", Kind::Float, X, "return int(clamp(x, -2147483648.0, 2147483520.0));")
    },
    Plain {
        gives: Part::Of(Kind::Uint),
        ..plain("uint", Kind::Float, X, "return uint(clamp(x, 0.0, 4294967040.0));")
    },
    // What a variable holds at this moment: operands that are variables are read after all calls around them, by some.
    plain("now", Kind::Bool, X, "return x;"),
    plain("now", Kind::Int, X, "return x;"),
    plain("now", Kind::Uint, X, "return x;"),
    plain("now", Kind::Float, X, "return x;"),
    plain("select", Kind::Bool, SELECT, "return c ? t : f;"),
    plain("select", Kind::Int, SELECT, "return c ? t : f;"),
    plain("select", Kind::Uint, SELECT, "return c ? t : f;"),
    plain("select", Kind::Float, SELECT, "return c ? t : f;"),
    plain("and", Kind::Bool, AB, "return a && b;"),
    plain("or", Kind::Bool, AB, "return a || b;"),
    plain(
        "count_one_bits",
        Kind::Uint,
        X,
        "x -= (x >> 1) & 0x55555555u;
    x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
    return (((x + (x >> 4)) & 0x0f0f0f0fu) * 0x01010101u) >> 24;",
    ),
    as_uint("count_one_bits", "return int(wgsl_count_one_bits(uint(x)));", &[("count_one_bits", Kind::Uint)]),
    plain(
        "reverse_bits",
        Kind::Uint,
        X,
        "x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);",
    ),
    as_uint("reverse_bits", "return int(wgsl_reverse_bits(uint(x)));", &[("reverse_bits", Kind::Uint)]),
    Plain {
        uses: &[("count_one_bits", Kind::Uint)],
        ..plain(
            "count_leading_zeros",
            Kind::Uint,
            X,
            "x |= x >> 1;
    x |= x >> 2;
    x |= x >> 4;
    x |= x >> 8;
    x |= x >> 16;
    return wgsl_count_one_bits(~x);",
        )
    },
    as_uint(
        "count_leading_zeros",
        "return int(wgsl_count_leading_zeros(uint(x)));",
        &[("count_leading_zeros", Kind::Uint)],
    ),
    Plain {
        uses: &[("count_one_bits", Kind::Uint)],
        ..plain("count_trailing_zeros", Kind::Uint, X, "return wgsl_count_one_bits(~x & (x - 1u));")
    },
    as_uint(
        "count_trailing_zeros",
        "return int(wgsl_count_trailing_zeros(uint(x)));",
        &[("count_trailing_zeros", Kind::Uint)],
    ),
    Plain {
        uses: &[("count_leading_zeros", Kind::Uint)],
        ..plain("first_leading_bit", Kind::Uint, X, "return 31u - wgsl_count_leading_zeros(x);")
    },
    as_uint(
        "first_leading_bit",
        "return int(wgsl_first_leading_bit(uint(x < 0 ? ~x : x)));",
        &[("first_leading_bit", Kind::Uint)],
    ),
    Plain {
        uses: &[("count_trailing_zeros", Kind::Uint)],
        ..plain(
            "first_trailing_bit",
            Kind::Uint,
            X,
            "return x == 0u ? 0xffffffffu : wgsl_count_trailing_zeros(x);",
        )
    },
    as_uint(
        "first_trailing_bit",
        "return int(wgsl_first_trailing_bit(uint(x)));",
        &[("first_trailing_bit", Kind::Uint)],
    ),
    plain(
        "extract_bits",
        Kind::Uint,
        EXTRACT,
        "uint low = min(offset, 32u);
    uint n = min(count, 32u - low);
    return n == 0u ? 0u : (x << (32u - n - low)) >> (32u - n);",
    ),
    plain(
        "extract_bits",
        Kind::Int,
        EXTRACT,
        "uint low = min(offset, 32u);
    uint n = min(count, 32u - low);
    return n == 0u ? 0 : (x << (32u - n - low)) >> (32u - n);",
    ),
    plain(
        "insert_bits",
        Kind::Uint,
        INSERT,
        "uint low = min(offset, 32u);
    uint n = min(count, 32u - low);
    if (n == 0u) {
        return x;
    }
    uint mask = (0xffffffffu >> (32u - n)) << low;
    return (x & ~mask) | ((bits << low) & mask);",
    ),
    Plain {
        uses: &[("insert_bits", Kind::Uint)],
        ..plain(
            "insert_bits",
            Kind::Int,
            INSERT,
            "return int(wgsl_insert_bits(uint(x), uint(bits), offset, count));",
        )
    },
    Plain {
        takes: &[(Part::T, "x"), (Part::Of(Kind::Int), "e")],
        ..plain(
            "ldexp",
            Kind::Float,
            X,
            "int low = clamp(e, -252, 254) / 2;
    int high = clamp(e, -252, 254) - low;
    return x * intBitsToFloat((low + 127) << 23) * intBitsToFloat((high + 127) << 23);",
        )
    },
    Plain {
        gives: Part::Of(Kind::Int),
        ..plain(
            "frexp_exponent",
            Kind::Float,
            X,
            "int bits = floatBitsToInt(x);
    return (bits & 0x7fffffff) == 0 ? 0 : ((bits >> 23) & 255) - 126;",
        )
    },
    plain(
        "frexp_part",
        Kind::Float,
        X,
        "int bits = floatBitsToInt(x);
    return (bits & 0x7fffffff) == 0 ? x : intBitsToFloat((bits & ~0x7f800000) | 0x3f000000);",
    ),
];

/// Functions that are what they are: name, text, and what they use.
const WHOLE: [(&str, &str); 12] = [
    (
        "quantize",
        "float wgsl_quantize(float x) {\n    return unpackHalf2x16(packHalf2x16(vec2(x, 0.0))).x;\n}\n",
    ),
    (
        "pack4x8snorm",
        "uint wgsl_pack4x8snorm(vec4 v) {
    ivec4 i = ivec4(floor(0.5 + 127.0 * clamp(v, -1.0, 1.0))) & 255;
    return uint(i.x | (i.y << 8) | (i.z << 16) | (i.w << 24));
}
",
    ),
    (
        "pack4x8unorm",
        "uint wgsl_pack4x8unorm(vec4 v) {
    uvec4 i = uvec4(floor(0.5 + 255.0 * clamp(v, 0.0, 1.0)));
    return i.x | (i.y << 8) | (i.z << 16) | (i.w << 24);
}
",
    ),
    (
        "pack4xI8",
        "uint wgsl_pack4xI8(ivec4 v) {
    ivec4 i = v & 255;
    return uint(i.x | (i.y << 8) | (i.z << 16) | (i.w << 24));
}
",
    ),
    (
        "pack4xU8",
        "uint wgsl_pack4xU8(uvec4 v) {
    uvec4 i = v & 255u;
    return i.x | (i.y << 8) | (i.z << 16) | (i.w << 24);
}
",
    ),
    (
        "pack4xI8Clamp",
        "uint wgsl_pack4xI8Clamp(ivec4 v) {
    ivec4 i = clamp(v, -128, 127) & 255;
    return uint(i.x | (i.y << 8) | (i.z << 16) | (i.w << 24));
}
",
    ),
    (
        "pack4xU8Clamp",
        "uint wgsl_pack4xU8Clamp(uvec4 v) {
    uvec4 i = min(v, 255u);
    return i.x | (i.y << 8) | (i.z << 16) | (i.w << 24);
}
",
    ),
    (
        "unpack4xI8",
        "ivec4 wgsl_unpack4xI8(uint x) {\n    return ivec4(int(x) << 24, int(x) << 16, int(x) << 8, int(x)) >> 24;\n}\n",
    ),
    (
        "unpack4xU8",
        "uvec4 wgsl_unpack4xU8(uint x) {\n    return uvec4(x, x >> 8, x >> 16, x >> 24) & 255u;\n}\n",
    ),
    (
        "unpack4x8snorm",
        "vec4 wgsl_unpack4x8snorm(uint x) {
    ivec4 i = ivec4(int(x) << 24, int(x) << 16, int(x) << 8, int(x)) >> 24;
    return max(vec4(i) / 127.0, -1.0);
}
",
    ),
    (
        "unpack4x8unorm",
        "vec4 wgsl_unpack4x8unorm(uint x) {\n    return vec4(uvec4(x, x >> 8, x >> 16, x >> 24) & 255u) / 255.0;\n}\n",
    ),
    (
        "dot4U8Packed",
        "uint wgsl_dot4U8Packed(uint a, uint b) {
    uvec4 p = uvec4(a, a >> 8, a >> 16, a >> 24) & 255u;
    uvec4 q = uvec4(b, b >> 8, b >> 16, b >> 24) & 255u;
    return p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w;
}
",
    ),
];

const DOT_I8: &str = "int wgsl_dot4I8Packed(uint a, uint b) {
    ivec4 p = ivec4(int(a) << 24, int(a) << 16, int(a) << 8, int(a)) >> 24;
    ivec4 q = ivec4(int(b) << 24, int(b) << 16, int(b) << 8, int(b)) >> 24;
    return p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w;
}
";

/// The helpers that a file needs.
#[derive(Debug, Default)]
pub(super) struct Helpers {
    wanted: BTreeSet<Helper>,
    whole: BTreeSet<&'static str>,
    /// Of `dot` for integers, `modf` and `frexp`: name, kind and size.
    shaped: BTreeSet<(&'static str, Kind, u8)>,
    /// How often one was asked for.
    asked: usize,
}

impl Helpers {
    /// How often one was asked for: where that does not change, a text calls none.
    pub(super) fn asked(&self) -> usize {
        self.asked
    }

    /// Asks for the helper `name` of one component's kind, and gives the name to call it by.
    pub(super) fn ask(&mut self, name: &'static str, ty: Ty) -> String {
        let scalar = ty.scalar().unwrap_or(Scalar::F32);
        self.asked += 1;
        self.want(name, Kind::of(scalar), ty.size());
        format!("wgsl_{name}")
    }

    fn want(&mut self, name: &'static str, kind: Kind, size: u8) {
        self.wanted.insert(Helper { name, scalar: kind, size: 1 });
        self.wanted.insert(Helper { name, scalar: kind, size });
        for (used, kind) in
            PLAIN.iter().find(|one| one.name == name && one.kind == kind).map_or(&[][..], |one| one.uses)
        {
            self.want(used, *kind, 1);
        }
    }

    /// Asks for one of those that have one type only; none if `name` is none of them.
    pub(super) fn ask_whole(&mut self, name: &str) -> Option<String> {
        let known =
            WHOLE.iter().map(|(known, _)| *known).chain(["dot4I8Packed"]).find(|known| *known == name)?;
        self.asked += 1;
        self.whole.insert(known);
        Some(format!("wgsl_{known}"))
    }

    /// Asks for `dot` of integers, or for the struct that `modf` and `frexp` give.
    pub(super) fn ask_shaped(&mut self, name: &'static str, ty: Ty) -> String {
        self.asked += 1;
        self.shaped.insert((name, Kind::of(ty.scalar().unwrap_or(Scalar::F32)), ty.size()));
        if name == "frexp" {
            self.want("frexp_part", Kind::Float, ty.size());
            self.want("frexp_exponent", Kind::Float, ty.size());
        }
        format!("wgsl_{name}")
    }

    /// Their text, each after those that it uses; empty where there are none.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        // In the order of the table, where what is used stands first; of each, one component first.
        for plain in &PLAIN {
            for size in 1..=4 {
                if self.wanted.contains(&Helper { name: plain.name, scalar: plain.kind, size }) {
                    text.push_str(&plain.text(size));
                }
            }
        }
        for (name, body) in &WHOLE {
            if self.whole.contains(name) {
                text.push_str(body);
            }
        }
        if self.whole.contains("dot4I8Packed") {
            text.push_str(DOT_I8);
        }
        for (name, kind, size) in &self.shaped {
            text.push_str(&shaped(name, *kind, *size));
        }
        text
    }
}

impl Plain {
    fn text(&self, size: u8) -> String {
        let spell = |part: Part, size: u8| match part {
            Part::T => self.kind.ty(size),
            Part::Of(kind) => kind.ty(size),
            Part::One(kind) => kind.ty(1),
        };
        let takes: Vec<_> =
            self.takes.iter().map(|(part, name)| format!("{} {name}", spell(*part, size))).collect();
        let head = format!("{} wgsl_{}({})", spell(self.gives, size), self.name, takes.join(", "));
        if size == 1 {
            return format!("{head} {{\n    {}\n}}\n", self.body);
        }
        let component = |letter: char| {
            let passed = self.takes.iter().map(|(part, name)| match part {
                Part::One(_) => (*name).to_owned(),
                _ => format!("{name}.{letter}"),
            });
            format!("wgsl_{}({})", self.name, passed.collect::<Vec<_>>().join(", "))
        };
        let components: Vec<_> = "xyzw".chars().take(size.into()).map(component).collect();
        format!("{head} {{\n    return {}({});\n}}\n", spell(self.gives, size), components.join(", "))
    }
}

/// The name of what `modf` or `frexp` gives for so many components.
pub(super) fn struct_name(name: &str, size: u8) -> String {
    format!("wgsl_{name}_{}", Kind::Float.ty(size))
}

fn shaped(name: &str, kind: Kind, size: u8) -> String {
    let ty = kind.ty(size);
    let of = struct_name(name, size);
    match name {
        "dot" => {
            let sum: Vec<_> = "xyzw".chars().take(size.into()).map(|c| format!("a.{c} * b.{c}")).collect();
            format!("{} wgsl_dot({ty} a, {ty} b) {{\n    return {};\n}}\n", kind.ty(1), sum.join(" + "))
        }
        "modf" => format!(
            "struct {of} {{\n    {ty} part;\n    {ty} whole;\n}};\n{of} wgsl_modf({ty} x) {{\n    return {of}(x - trunc(x), trunc(x));\n}}\n"
        ),
        _ => format!(
            "struct {of} {{\n    {ty} part;\n    {} exponent;\n}};\n{of} wgsl_frexp({ty} x) {{\n    return {of}(wgsl_frexp_part(x), wgsl_frexp_exponent(x));\n}}\n",
            Kind::Int.ty(size)
        ),
    }
}

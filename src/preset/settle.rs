//! A preset held against the declarations of its scene: [`Preset`] + [`Declarations`] → [`Settings`].

use rustc_hash::FxHashMap;

use super::error::{PresetError, PresetErrorKind};
use super::json::{Json, JsonKind};
use super::read::{Preset, Setting};
use crate::diagnostic::{ENOUGH, choices, nearest};
use crate::source::{FileId, Span};
use crate::syntax::{Key, OptionDecl, OptionKind, OptionValue, ParamDecl, Type, Value};

/// A declaration and where it stands.
#[derive(Debug, Clone)]
pub struct Declared<T> {
    /// The declaration; in an instance, with the instance's group.
    pub decl: T,
    /// The file that it stands in.
    pub file: FileId,
    /// Where its name stands.
    pub span: Span,
}

/// What a name in a preset stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Knob {
    /// The parameter of that number.
    Parameter(usize),
    /// The option of that number.
    Option(usize),
}

/// All parameters and options that any branch of a scene can reach, in the order of their declaration.
#[derive(Debug, Clone, Default)]
pub struct Declarations {
    /// The parameters.
    pub parameters: Vec<Declared<ParamDecl>>,
    /// The options.
    pub options: Vec<Declared<OptionDecl>>,
    by_key: FxHashMap<String, Knob>,
    /// Whether code can read from the group, or only presets set something in it.
    groups: FxHashMap<String, bool>,
    /// How many parameters and options code can read; all, where nothing is said.
    in_code: Option<(usize, usize)>,
}

impl Declarations {
    /// Takes a parameter in; where its name is taken, gives back who has it.
    pub fn add_parameter(&mut self, declared: Declared<ParamDecl>) -> Result<(), (FileId, Span)> {
        let (key, knob) = (declared.decl.key.clone(), Knob::Parameter(self.parameters.len()));
        self.claim(&key, knob)?;
        self.parameters.push(declared);
        Ok(())
    }

    /// Takes an option in; where its name is taken, gives back who has it.
    pub fn add_option(&mut self, declared: Declared<OptionDecl>) -> Result<(), (FileId, Span)> {
        let (key, knob) = (declared.decl.key.clone(), Knob::Option(self.options.len()));
        self.claim(&key, knob)?;
        self.options.push(declared);
        Ok(())
    }

    fn claim(&mut self, key: &Key, knob: Knob) -> Result<(), (FileId, Span)> {
        if let Some(taken) = self.by_key.get(&key.to_string()) {
            return Err(self.place(*taken));
        }
        self.by_key.insert(key.to_string(), knob);
        if !key.group.is_empty() {
            self.groups.entry(key.group.clone()).or_insert(self.in_code.is_none());
        }
        Ok(())
    }

    /// What is added from here on can be set, but is out of sight of the code.
    pub(crate) fn close_to_code(&mut self) {
        self.in_code = Some((self.parameters.len(), self.options.len()));
    }

    /// The parameters and options that code can read.
    pub(crate) fn in_code(&self) -> (&[Declared<ParamDecl>], &[Declared<OptionDecl>]) {
        let (parameters, options) = self.in_code.unwrap_or((self.parameters.len(), self.options.len()));
        (&self.parameters[..parameters], &self.options[..options])
    }

    /// Whether `name` is a group that code can read from.
    pub(crate) fn is_group_in_code(&self, name: &str) -> bool {
        self.groups.get(name).copied().unwrap_or_default()
    }

    /// Where `knob` is declared.
    pub fn place(&self, knob: Knob) -> (FileId, Span) {
        match knob {
            Knob::Parameter(index) => (self.parameters[index].file, self.parameters[index].span),
            Knob::Option(index) => (self.options[index].file, self.options[index].span),
        }
    }

    /// What `key` (`group.name`, or a name alone) stands for.
    pub fn find(&self, key: &str) -> Option<Knob> {
        self.by_key.get(key).copied()
    }

    /// Whether any name has the group `group`.
    pub fn has_group(&self, group: &str) -> bool {
        self.groups.contains_key(group)
    }

    /// Every name, as presets write it.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.by_key.keys().map(String::as_str)
    }
}

/// The value of every parameter and option of a scene.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// By the parameter's number, in the declared unit.
    pub parameters: Vec<Value>,
    /// By the option's number.
    pub options: Vec<OptionValue>,
}

/// Values for everything in `declarations`: what `preset` sets, and defaults for the rest.
///
/// # Errors
/// Every unknown name, wrong type and value out of range in the preset.
pub fn settle(preset: &Preset, declarations: &Declarations) -> Result<Settings, Vec<PresetError>> {
    let mut settings = Settings {
        parameters: declarations.parameters.iter().map(|p| p.decl.default).collect(),
        options: declarations.options.iter().map(|o| o.decl.default).collect(),
    };
    let mut errors = Vec::new();
    for setting in &preset.settings {
        let names_group = setting.key.name.is_empty() && setting.value.kind == JsonKind::Object(Vec::new());
        if names_group && declarations.has_group(&setting.key.group) {
            continue; // a group in which nothing is set
        }
        let key = if names_group { setting.key.group.clone() } else { setting.key.to_string() };
        let outcome = match declarations.find(&key) {
            None => Err(unknown(setting, key, declarations)),
            Some(Knob::Parameter(index)) => parameter(&declarations.parameters[index], &setting.value)
                .map(|value| settings.parameters[index] = value),
            Some(Knob::Option(index)) => option(&declarations.options[index], &setting.value)
                .map(|value| settings.options[index] = value),
        };
        if let Err((kind, span)) = outcome {
            if errors.len() >= ENOUGH {
                break;
            }
            errors.push(PresetError { kind, file: setting.file, span, pointer: setting.pointer.clone() });
        }
    }
    if errors.is_empty() { Ok(settings) } else { Err(errors) }
}

type Fault = (PresetErrorKind, Span);

fn unknown(setting: &Setting, key: String, declarations: &Declarations) -> Fault {
    // The group is more often right than the name in it.
    let in_group = format!("{}.", setting.key.group);
    let near = nearest(&key, declarations.keys().filter(|known| known.starts_with(&in_group)))
        .or_else(|| nearest(&key, declarations.keys()))
        .or_else(|| nearest(&key, declarations.groups.keys().map(String::as_str)));
    (PresetErrorKind::Unknown { key, nearest: near }, setting.key_span)
}

fn expected(what: impl Into<String>, found: &Json) -> Fault {
    let found_kind = found.kind.describe().into();
    (PresetErrorKind::Type { expected: what.into(), found: found_kind }, found.span)
}

fn parameter(declared: &Declared<ParamDecl>, json: &Json) -> Result<Value, Fault> {
    let decl = &declared.decl;
    let value = match (decl.ty, &json.kind) {
        (Type::Bool, JsonKind::Bool(on)) => Value::Bool(*on),
        (Type::I32, JsonKind::Number(number)) => Value::I32(whole(number, "i32", json)?),
        (Type::U32, JsonKind::Number(number)) => Value::U32(whole(number, "u32", json)?),
        (Type::F32, JsonKind::Number(_)) => Value::F32(float(json)?),
        (ty, JsonKind::String(text)) if decl.color && text.starts_with('#') => {
            color(ty, text).ok_or_else(|| {
                let found = format!("`{text}`");
                (PresetErrorKind::Type { expected: color_forms(ty).into(), found }, json.span)
            })?
        }
        (ty, JsonKind::Array(items)) if ty.components() > 1 => {
            let floats = items.iter().map(float).collect::<Result<Vec<_>, _>>()?;
            Value::from_floats(ty, &floats).ok_or_else(|| {
                let found = format!("a list of {}", floats.len());
                let kind = PresetErrorKind::Type { expected: describe(decl), found };
                (kind, json.span)
            })?
        }
        _ => return Err(expected(describe(decl), json)),
    };
    if let Some((low, high)) = decl.range
        && let Some(outside) = decl.outside(&value)
    {
        // In the author's digits: a value that was rounded to f32 first would look odd.
        let value = match &json.kind {
            JsonKind::Number(number) => number.clone(),
            _ => outside.to_string(),
        };
        let unit = decl.unit.clone().unwrap_or_default();
        let declared = (declared.file, declared.span);
        return Err((PresetErrorKind::Range { value, low, high, unit, declared }, json.span));
    }
    Ok(value)
}

fn describe(decl: &ParamDecl) -> String {
    match decl.ty {
        Type::Bool => "`true` or `false`".into(),
        Type::I32 | Type::U32 => "a whole number".into(),
        Type::F32 => "a number".into(),
        ty if decl.color => {
            format!("a list of {} numbers (linear sRGB), or {}", ty.components(), color_forms(ty))
        }
        ty => format!("a list of {} numbers", ty.components()),
    }
}

fn color_forms(ty: Type) -> &'static str {
    if ty == Type::Vec4f { "a colour \"#rrggbbaa\"" } else { "a colour \"#rrggbb\"" }
}

fn whole<T: std::str::FromStr>(number: &str, ty: &'static str, json: &Json) -> Result<T, Fault> {
    // JSON does not tell `4` from `4.0`.
    let plain = number.parse::<f64>().ok().filter(|value| value.fract() == 0.0 && value.abs() < 9e15);
    let parsed =
        number.parse().or_else(|error| plain.map_or(Err(error), |value| format!("{value:.0}").parse()));
    parsed.map_err(|_| {
        let digits = number.strip_prefix('-').unwrap_or(number);
        if digits.bytes().all(|byte| byte.is_ascii_digit()) {
            (PresetErrorKind::TooLarge { what: number.into(), ty }, json.span)
        } else {
            let kind =
                PresetErrorKind::Type { expected: "a whole number".into(), found: format!("`{number}`") };
            (kind, json.span)
        }
    })
}

fn float(json: &Json) -> Result<f32, Fault> {
    let JsonKind::Number(number) = &json.kind else { return Err(expected("a number", json)) };
    match number.parse::<f32>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err((PresetErrorKind::TooLarge { what: number.clone(), ty: "f32" }, json.span)),
    }
}

/// `#rrggbb` or `#rgb` in sRGB → linear; `#rrggbbaa` or `#rgba` for four components, alpha as it is.
fn color(ty: Type, text: &str) -> Option<Value> {
    let digits = text.strip_prefix('#')?;
    let values = digits.chars().map(|digit| digit.to_digit(16)).collect::<Option<Vec<_>>>()?;
    let bytes: Vec<u32> = match values.len() {
        3 | 4 => values.iter().map(|v| v * 17).collect(),
        6 | 8 => values.chunks(2).map(|pair| pair[0] * 16 + pair[1]).collect(),
        _ => return None,
    };
    let linear = |byte: u32| {
        let encoded = f64::from(byte) / 255.0;
        // IEC 61966-2-1
        let light = if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) };
        light as f32
    };
    let mut floats: Vec<f32> = bytes.iter().take(3).map(|byte| linear(*byte)).collect();
    if ty == Type::Vec4f {
        floats.push(bytes.get(3).map_or(1.0, |alpha| *alpha as f32 / 255.0));
    } else if bytes.len() > 3 {
        return None;
    }
    Value::from_floats(ty, &floats)
}

fn option(declared: &Declared<OptionDecl>, json: &Json) -> Result<OptionValue, Fault> {
    let decl = &declared.decl;
    let place = (declared.file, declared.span);
    match (&decl.kind, &json.kind) {
        (OptionKind::Choice(names), JsonKind::String(text)) => {
            let index = names.iter().position(|name| name == text);
            index.map(OptionValue::Choice).ok_or_else(|| {
                let kind = PresetErrorKind::Choice {
                    found: text.clone(),
                    key: decl.key.to_string(),
                    choices: choices(names.iter().map(String::as_str)),
                    nearest: nearest(text, names.iter().map(String::as_str)),
                    declared: place,
                };
                (kind, json.span)
            })
        }
        (OptionKind::Choice(names), _) => {
            Err(expected(format!("one of {}", choices(names.iter().map(String::as_str))), json))
        }
        (OptionKind::Bool, JsonKind::Bool(on)) => Ok(OptionValue::Bool(*on)),
        (OptionKind::Bool, _) => Err(expected("`true` or `false`", json)),
        (OptionKind::Integer(limits), JsonKind::Number(number)) => {
            let value = i64::from(whole::<i32>(number, "i32", json)?);
            if let Some((low, high)) = limits
                && (value < *low || value > *high)
            {
                let (low, high) = (*low as f64, *high as f64);
                let (value, unit) = (number.clone(), String::new());
                return Err((PresetErrorKind::Range { value, low, high, unit, declared: place }, json.span));
            }
            Ok(OptionValue::Integer(value))
        }
        (OptionKind::Integer(_), _) => Err(expected("a whole number", json)),
    }
}

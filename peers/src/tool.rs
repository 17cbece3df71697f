//! The contestants of composing, behind one face: open a graph, compose it, edit a file of it.
//!
//! Each gets what its makers mean for it: caches that are kept between compositions, and for the others the settings under
//! which they are fastest. Whatever a tool does, the end is a module that naga has validated.

use std::borrow::Cow;
use std::collections::HashMap;

use naga::valid::{ModuleInfo, ValidationFlags, Validator};
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor, ShaderDefValue};
use orogen::{Bake, Compose, Library, Preset, Shader, check, compose};
use wesl::syntax::ModulePath;
use wesl::{CompileOptions, Features, VirtualResolver, Wesl};

use crate::Outcome;
use crate::graph::{Dialect, Graph, Settings, settings};

/// A contestant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tool {
    Orogen,
    /// As `Composer::default()`: it can tell where an error is.
    NagaOil,
    /// As `Composer::non_validating()`, for shaders known to be right: it cannot.
    NagaOilLean,
    /// Without its own validation and without its source map.
    Wesl,
}

impl Tool {
    pub(crate) const ALL: [Self; 4] = [Self::Orogen, Self::NagaOil, Self::NagaOilLean, Self::Wesl];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Orogen => "orogen",
            Self::NagaOil => "naga_oil",
            Self::NagaOilLean => "naga_oil, non-validating",
            Self::Wesl => "wesl",
        }
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|tool| tool.name() == name)
    }

    pub(crate) fn dialect(self) -> Dialect {
        match self {
            Self::Orogen => Dialect::Orogen,
            Self::NagaOil | Self::NagaOilLean => Dialect::NagaOil,
            Self::Wesl => Dialect::Wesl,
        }
    }
}

/// A composed and validated shader.
pub(crate) enum Composed {
    Orogen(Box<Shader>),
    Module(Box<naga::Module>),
    Text(String, Box<naga::Module>),
}

impl Composed {
    pub(crate) fn module(&self) -> &naga::Module {
        match self {
            Self::Orogen(shader) => &shader.checked().module,
            Self::Module(module) | Self::Text(_, module) => module,
        }
    }

    /// As WGSL. Of what is only a module, naga writes it.
    pub(crate) fn wgsl(&self) -> Outcome<Cow<'_, str>> {
        match self {
            Self::Orogen(shader) => Ok(shader.wgsl().into()),
            Self::Text(text, _) => Ok(text.into()),
            Self::Module(module) => {
                let flags = naga::back::wgsl::WriterFlags::empty();
                Ok(naga::back::wgsl::write_string(module, &validated(module)?, flags)?.into())
            }
        }
    }
}

/// A tool with a graph in its hands.
pub(crate) enum Session<'a> {
    Orogen { library: Library, root: Preset, compose: Box<Compose> },
    NagaOil { composer: Box<Composer>, graph: &'a Graph, edited: HashMap<&'a str, Cow<'a, str>> },
    Wesl { graph: &'a Graph, compiler: Wesl<VirtualResolver<'a>>, modules: HashMap<&'a str, Cow<'a, str>> },
}

impl<'a> Session<'a> {
    /// Hands `graph` over; nothing is composed yet.
    pub(crate) fn open(tool: Tool, graph: &'a Graph) -> Outcome<Self> {
        match tool {
            Tool::Orogen => {
                let mut library = Library::empty();
                for file in &graph.modules {
                    library = library.with_file(format!("{}.wgsl", file.name), file.text.clone());
                }
                if let Some(text) = settings(Dialect::Orogen, Settings::default()) {
                    library = library.with_file("settings.wgsl", text);
                }
                let root = Preset::of_text("root.wgsl", &graph.root);
                Ok(Self::Orogen { library, root, compose: Box::default() })
            }
            Tool::NagaOil | Tool::NagaOilLean => {
                let composer = match tool {
                    Tool::NagaOil => Composer::default(),
                    _ => Composer::non_validating(),
                };
                let composer = composer.with_capabilities(check::capabilities());
                let mut session = Self::NagaOil { composer: composer.into(), graph, edited: HashMap::new() };
                session.add_missing()?;
                Ok(session)
            }
            Tool::Wesl => {
                let modules = graph.modules.iter().map(|file| (file.name.as_str(), (&*file.text).into()));
                let mut session = Self::Wesl {
                    graph,
                    compiler: Wesl::new_barebones().set_custom_resolver(VirtualResolver::new()),
                    modules: modules.collect(),
                };
                session.load(Settings::default())?;
                Ok(session)
            }
        }
    }

    /// As [`Session::compose`], for those who will not compose again: what a tool has no more use for may go.
    pub(crate) fn compose_once(mut self, values: Settings) -> Outcome<Composed> {
        match self {
            Self::Orogen { library, root, .. } => {
                Ok(Composed::Orogen(compose(&library, &with(&root, values)?, &Bake::constants())?.into()))
            }
            _ => self.compose(values),
        }
    }

    /// Composes the graph under `values` and has naga validate what comes out.
    pub(crate) fn compose(&mut self, values: Settings) -> Outcome<Composed> {
        match self {
            Self::Orogen { library, root, compose } => {
                let preset = with(root, values)?;
                Ok(Composed::Orogen(compose.run(library, &preset, &Bake::constants())?.into()))
            }
            Self::NagaOil { composer, graph, .. } => {
                let validates = composer.validate;
                let made = composer.make_naga_module(NagaModuleDescriptor {
                    source: &graph.root,
                    file_path: "root",
                    shader_defs: definitions(values),
                    ..Default::default()
                });
                let module = made.map_err(|error| error.emit_to_string(composer))?;
                if !validates {
                    validated(&module)?;
                }
                Ok(Composed::Module(module.into()))
            }
            Self::Wesl { .. } => {
                self.load(values)?;
                let Self::Wesl { compiler, .. } = self else { return Err("no session of wesl".into()) };
                let text = compiler.compile(&path("root"))?.to_string();
                let module =
                    naga::front::wgsl::parse_str(&text).map_err(|error| error.emit_to_string(&text))?;
                validated(&module)?;
                Ok(Composed::Text(text, module.into()))
            }
        }
    }

    /// Puts another text in the place of a module's.
    pub(crate) fn edit(&mut self, name: &'a str, text: &'a str) -> Outcome {
        match self {
            Self::Orogen { library, .. } => {
                let owned = std::mem::replace(library, Library::empty());
                *library = owned.with_file(format!("{name}.wgsl"), text);
                Ok(())
            }
            Self::NagaOil { composer, edited, .. } => {
                // It drops whoever depends on the module, and they have to be handed over again.
                composer.remove_composable_module(name);
                edited.insert(name, text.into());
                self.add_missing()
            }
            Self::Wesl { modules, .. } => {
                modules.insert(name, text.into());
                Ok(())
            }
        }
    }

    /// naga_oil: hands over what it does not have, or has no more.
    fn add_missing(&mut self) -> Outcome {
        let Self::NagaOil { composer, graph, edited } = self else { return Ok(()) };
        for file in &graph.modules {
            if !composer.contains_module(&file.name) {
                let source = edited.get(file.name.as_str()).map_or(&*file.text, |text| text);
                let added = composer.add_composable_module(ComposableModuleDescriptor {
                    source,
                    file_path: &file.name,
                    ..Default::default()
                });
                if let Err(error) = added {
                    return Err(error.emit_to_string(composer).into());
                }
            }
        }
        Ok(())
    }

    /// wesl: a compiler over the texts as they are now.
    fn load(&mut self, values: Settings) -> Outcome {
        let Self::Wesl { graph, compiler, modules } = self else { return Ok(()) };
        let mut resolver = VirtualResolver::new();
        for (name, text) in modules {
            resolver.add_module(path(name), text.clone());
        }
        resolver.add_module(path("root"), graph.root.as_str().into());
        if let Some(text) = settings(Dialect::Wesl, values) {
            resolver.add_module(path("settings"), text.into());
        }
        let flags = HashMap::from([("fine".to_owned(), values.fine.into())]);
        let features = Features { flags, ..Features::default() };
        let mut new = Wesl::new_barebones().set_custom_resolver(resolver);
        new.set_options(CompileOptions { validate: false, features, ..CompileOptions::default() });
        new.set_mangler(wesl::ManglerKind::Escape);
        *compiler = new;
        Ok(())
    }
}

/// The root with its values.
fn with(root: &Preset, values: Settings) -> Outcome<Preset> {
    let mut preset = root.clone();
    preset.set(&format!("detail.fine={}", values.fine))?;
    preset.set(&format!("detail.gain={}", values.gain))?;
    Ok(preset)
}

fn definitions(values: Settings) -> HashMap<String, ShaderDefValue> {
    HashMap::from([
        ("FINE".to_owned(), ShaderDefValue::Bool(values.fine)),
        ("GAIN".to_owned(), ShaderDefValue::Int(values.gain)),
    ])
}

/// A module's path in WESL, from the root of its package.
pub(crate) fn path(name: &str) -> ModulePath {
    ModulePath::new(wesl::syntax::PathOrigin::Absolute, vec![name.to_owned()])
}

/// What naga's validator has to say of `module`.
pub(crate) fn validated(module: &naga::Module) -> Outcome<ModuleInfo> {
    let mut validator = Validator::new(ValidationFlags::all(), check::capabilities());
    validator.validate(module).map_err(|error| error.into_inner().into())
}

//! The whole pipeline in one call: [`compose`] → [`Shader`].

use crate::bake::{self, Bake, Interface};
use crate::check::{self, Checked};
use crate::compose::{self as stage, Cache, Request};
use crate::diagnostic::Error;
use crate::export::{Stage, entry_point};
use crate::preset::{Declarations, Declared, Preset};
use crate::source::{Library, Source, Templates};

/// Composes `preset` out of `library`, puts its values in as `bake` says, and checks the result.
///
/// # Errors
/// Everything that is wrong with the preset, the fragments or the composed WGSL, told in the author's files.
pub fn compose(library: &Library, preset: &Preset, bake: &Bake) -> Result<Shader, Error> {
    Compose::default().run(library, preset, bake)
}

/// How to compose, for those who need more than [`compose`]. Keeps what it has read: composing again after a change reads
/// only what changed.
#[derive(Default)]
pub struct Compose {
    /// Which entry point a scene gets that has only `main_image`.
    pub stage: Stage,
    /// The debug view that is drawn in the scene's place: `steps` is the library's `inspect/steps.wgsl`, and
    /// [`views`](crate::compose::views) names them all. The preset's values count for it as far as it reads them.
    pub view: Option<String>,
    /// Keep declarations that no entry point reaches.
    pub keep_unused: bool,
    /// What the result looks like.
    pub templates: Templates,
    /// A fragment to be put in beside the scene; the scene has no entry point then, not even its own.
    pub(crate) beside: Option<Source>,
    cache: Cache,
}

impl Compose {
    /// Composes, bakes and checks.
    ///
    /// # Errors
    /// As [`compose`].
    pub fn run(&mut self, library: &Library, preset: &Preset, bake: &Bake) -> Result<Shader, Error> {
        let baked = self.bake(library, preset, bake)?;
        let parameters = baked.composition.parameters.iter();
        let mut declarations = Declarations::default();
        for parameter in parameters {
            let declared =
                Declared { decl: parameter.decl.clone(), file: parameter.at.0, span: parameter.at.1 };
            let _ = declarations.add_parameter(declared); // each once, as `compose` has seen to
        }
        for option in &baked.composition.options {
            let declared = Declared { decl: option.decl.clone(), file: option.at.0, span: option.at.1 };
            let _ = declarations.add_option(declared);
        }
        Ok(Shader { checked: check::check(baked)?, declarations })
    }

    /// Composes and bakes, and leaves the checking.
    ///
    /// # Errors
    /// As [`compose`], but what only a WGSL compiler can tell.
    pub fn bake(&mut self, library: &Library, preset: &Preset, bake: &Bake) -> Result<bake::Baked, Error> {
        let request = self.request(preset)?;
        let composition = stage::compose(library, &mut self.cache, &request)?;
        bake::bake(composition, bake, &self.templates)
    }

    /// What the scene of `preset` offers to be set, and the value of each.
    ///
    /// # Errors
    /// As [`compose`], as far as parameters, options and includes go.
    pub fn survey(&mut self, library: &Library, preset: &Preset) -> Result<stage::Survey, Error> {
        let request = self.request(preset)?;
        stage::survey(library, &mut self.cache, &request)
    }

    fn request<'a>(&self, preset: &'a Preset) -> Result<Request<'a>, Error> {
        let beside = self.beside.clone();
        let wrapper = match beside {
            None => Some(entry_point(self.stage, &self.templates)?),
            Some(_) => None,
        };
        Ok(Request { preset, view: self.view.clone(), wrapper, beside, keep_unused: self.keep_unused })
    }
}

/// A shader: composed, baked and checked.
pub struct Shader {
    checked: Checked,
    declarations: Declarations,
}

impl Shader {
    /// Its text.
    pub fn wgsl(&self) -> &str {
        &self.checked.baked.text
    }

    /// Entry points, bindings, the uniform buffer's layout, overrides.
    pub fn interface(&self) -> &Interface {
        &self.checked.interface
    }

    /// naga's module, the source map and all else that is known of it.
    pub fn checked(&self) -> &Checked {
        &self.checked
    }

    /// The bytes of the uniform buffer with the values of `preset`; empty where no parameter is live.
    ///
    /// Only live parameters come from `preset`: what was baked in as a constant stays.
    ///
    /// # Errors
    /// Where `preset` sets what the scene does not have, or out of range.
    pub fn uniform_bytes(&self, preset: &Preset) -> Result<Vec<u8>, Error> {
        let files = &self.checked.baked.composition.files;
        bake::uniform_bytes(&self.checked.interface, &self.declarations, files, preset)
    }

    /// What `wgpu` makes a shader module of.
    #[cfg(feature = "render")]
    pub fn descriptor(&self) -> wgpu::ShaderModuleDescriptor<'_> {
        wgpu::ShaderModuleDescriptor {
            label: Some(&self.checked.baked.composition.name),
            source: wgpu::ShaderSource::Wgsl(self.wgsl().into()),
        }
    }
}

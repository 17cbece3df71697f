//! The whole pipeline in one call: [`compose`] → [`Shader`].

use std::ops::Range;

use crate::bake::{self, Bake, Baked, Interface};
#[cfg(feature = "check")]
use crate::check::{self, Checked};
use crate::compose::{self as stage, Cache, Prefix, Request};
use crate::diagnostic::Error;
use crate::export::{Stage, entry_point};
use crate::preset::{Declarations, Declared, Preset};
use crate::source::{Library, Source, Templates};

/// Composes `preset` out of `library`, puts its values in as `bake` says, and checks the result (feature `check`).
///
/// # Errors
/// Everything that is wrong with the preset, the fragments or the composed WGSL, told in the author's files.
pub fn compose(library: &Library, preset: &Preset, bake: &Bake) -> Result<Shader, Error> {
    // What is known for the next time goes before naga comes: there is none.
    let baked = Compose::default().bake(library, preset, bake)?;
    finished(baked)
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
    /// The fragment of the library that stands in the scene's place, on its own: `terrain/height.wgsl`. The preset's values
    /// count for it as far as it reads them. [`Library::module`] is the short way.
    pub module: Option<String>,
    /// Of what the scene or the module declares, what is wanted, with all that it reaches; everything where nothing is
    /// named.
    pub only: Vec<String>,
    /// What every name of module scope starts with in the result, so that it collides with nothing of a host's.
    pub prefix: Prefix,
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
        finished(self.bake(library, preset, bake)?)
    }

    /// Composes and bakes, and leaves the checking.
    ///
    /// # Errors
    /// As [`compose`], but what only a WGSL compiler can tell.
    pub fn bake(&mut self, library: &Library, preset: &Preset, bake: &Bake) -> Result<Baked, Error> {
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

    /// How much composing has done so far: what was known already is not counted.
    pub fn work(&self) -> stage::Work {
        self.cache.work()
    }

    fn request<'a>(&self, preset: &'a Preset) -> Result<Request<'a>, Error> {
        let beside = self.beside.clone();
        let wrapper = match beside {
            None => Some(entry_point(self.stage, &self.templates)?),
            Some(_) => None,
        };
        Ok(Request {
            preset,
            view: self.view.clone(),
            module: self.module.clone(),
            only: self.only.clone(),
            prefix: self.prefix.clone(),
            wrapper,
            beside,
            keep_unused: self.keep_unused,
        })
    }
}

/// Checks what is baked, and keeps what uniform buffers are filled by.
fn finished(baked: Baked) -> Result<Shader, Error> {
    let parameters = baked.composition.parameters.iter();
    let mut declarations = Declarations::default();
    for parameter in parameters {
        let declared = Declared { decl: parameter.decl.clone(), file: parameter.at.0, span: parameter.at.1 };
        let _ = declarations.add_parameter(declared); // each once, as `compose` has seen to
    }
    for option in &baked.composition.options {
        let declared = Declared { decl: option.decl.clone(), file: option.at.0, span: option.at.1 };
        let _ = declarations.add_option(declared);
    }
    #[cfg(feature = "check")]
    let baked = check::check(baked)?;
    Ok(Shader { baked, declarations })
}

/// A shader: composed and baked, and with the feature `check`, checked.
pub struct Shader {
    #[cfg(feature = "check")]
    baked: Checked,
    #[cfg(not(feature = "check"))]
    baked: Baked,
    declarations: Declarations,
}

impl Shader {
    /// The same shader in another text.
    #[cfg(feature = "check")]
    pub(crate) fn with(&self, baked: Baked) -> Result<Self, Error> {
        Ok(Self { baked: check::check(baked)?, declarations: self.declarations.clone() })
    }

    /// Its text.
    pub fn wgsl(&self) -> &str {
        &self.baked().text
    }

    /// The uniform buffer's layout, overrides, and with the feature `check`, entry points and bindings.
    pub fn interface(&self) -> &Interface {
        &self.baked.interface
    }

    /// The text's source map, what each parameter became, and what it was composed of.
    #[cfg(feature = "check")]
    pub fn baked(&self) -> &Baked {
        &self.baked.baked
    }

    /// The text's source map, what each parameter became, and what it was composed of.
    #[cfg(not(feature = "check"))]
    pub fn baked(&self) -> &Baked {
        &self.baked
    }

    /// naga's module, and what validation has found out about it.
    #[cfg(feature = "check")]
    pub fn checked(&self) -> &Checked {
        &self.baked
    }

    /// The bytes of the uniform buffer with the values of `preset`; empty where no parameter is live.
    ///
    /// Only live parameters come from `preset`: what was baked in as a constant stays.
    ///
    /// # Errors
    /// Where `preset` sets what the scene does not have, or out of range.
    pub fn uniform_bytes(&self, preset: &Preset) -> Result<Vec<u8>, Error> {
        let files = &self.baked().composition.files;
        bake::uniform_bytes(self.interface(), &self.declarations, files, preset)
    }

    /// Makes `bytes` those of `preset`, and gives back the one stretch of them that changed, in whole words; an empty one
    /// where none did. Nothing is composed for it.
    ///
    /// ```
    /// # let mut preset = orogen::Preset::named("alpine")?;
    /// # let bake = orogen::Bake::live(["sun.*"]);
    /// # let shader = orogen::compose(&orogen::Library::standard(), &preset, &bake)?;
    /// let mut bytes = shader.uniform_bytes(&preset)?; // what the buffer was created with
    /// preset.set("sun.elevation=4")?;
    /// let changed = shader.update_uniform(&mut bytes, &preset)?;
    /// assert_eq!(changed.len(), 4); // queue.write_buffer(&buffer, changed.start as u64, &bytes[changed])
    /// # Ok::<(), orogen::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Shader::uniform_bytes`]; `bytes` are then as they were.
    pub fn update_uniform(&self, bytes: &mut Vec<u8>, preset: &Preset) -> Result<Range<usize>, Error> {
        const WORD: usize = 4;
        let new = self.uniform_bytes(preset)?;
        let differs = |word: &usize| bytes.get(*word..word + WORD) != new.get(*word..word + WORD);
        let mut words = (0..new.len()).step_by(WORD).filter(differs);
        let first = words.next();
        let last = words.next_back().or(first);
        let changed = first.zip(last).map_or(0..0, |(first, last)| first..last + WORD);
        *bytes = new;
        Ok(changed)
    }

    /// What `wgpu` makes a shader module of.
    #[cfg(feature = "render")]
    pub fn descriptor(&self) -> wgpu::ShaderModuleDescriptor<'_> {
        wgpu::ShaderModuleDescriptor {
            label: Some(&self.baked().composition.name),
            source: wgpu::ShaderSource::Wgsl(self.wgsl().into()),
        }
    }
}

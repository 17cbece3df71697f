//! What can go wrong on the way to a picture or a table, and how each is told.

use crate::diagnostic::{Diagnostic, Error};

const NO_ADAPTER: &str = "OR0901";

/// A fault on the way to a picture or a table.
#[derive(Debug, Clone, thiserror::Error)]
pub enum RenderError {
    /// `OR0901`
    #[error("there is no GPU adapter on this machine")]
    NoAdapter,
    /// `OR0902`
    #[error("there is no GPU adapter whose name contains `{name}`")]
    UnknownAdapter {
        /// What was asked for.
        name: String,
        /// The adapters there are.
        found: Vec<String>,
    },
    /// `OR0903`
    #[error("the GPU adapter `{adapter}` cannot be opened")]
    Device {
        /// The adapter.
        adapter: String,
        /// wgpu's reason.
        why: String,
    },
    /// `OR0904`
    #[error("the GPU device was lost")]
    Lost(String),
    /// `OR0905`
    #[error("there is not enough memory")]
    OutOfMemory,
    /// `OR0906`
    #[error("wgpu refuses the work")]
    Refused(String),
    /// `OR0907`
    #[error("wgpu panicked")]
    Panicked(String),
    /// `OR0908`
    #[error("a picture of {width}×{height} pixels cannot be drawn")]
    Size {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
        /// The most the device can.
        limit: u32,
    },
    /// `OR0909`
    #[error("{why}")]
    Shot {
        /// What is wrong with it.
        why: &'static str,
        /// What to do.
        help: &'static str,
    },
    /// `OR0910`
    #[error("the shader has no fragment entry point to draw with")]
    NoFragment {
        /// The entry points it has.
        has: Vec<String>,
    },
    /// `OR0911`
    #[error("the shader needs something bound that only its host has: {}", .names.join(", "))]
    Bindings {
        /// What, each with its kind and place.
        names: Vec<String>,
    },
    /// `OR0912`
    #[error("`{file}` does not say which format the picture shall have")]
    Format {
        /// The file.
        file: String,
    },
    /// `OR0913`
    #[error("the picture cannot be encoded: {0}")]
    Encode(String),
    /// `OR0914`
    #[error("the scene has no option `camera.projection`: it cannot be drawn `{name}`")]
    Projection {
        /// What it should be drawn as.
        name: &'static str,
    },
}

/// Whether `error` says that the machine has no GPU adapter: exit status 3 of the command line.
pub fn is_no_adapter(error: &Error) -> bool {
    error.diagnostics().iter().any(|diagnostic| diagnostic.code == NO_ADAPTER)
}

impl From<RenderError> for Error {
    fn from(error: RenderError) -> Self {
        Self::bare(error.into())
    }
}

impl From<RenderError> for Diagnostic {
    fn from(error: RenderError) -> Self {
        use RenderError as E;
        let message = error.to_string();
        let d = |code, help: &str| Diagnostic::error(code, message.clone()).help(Some(help.to_owned()));
        match error {
            E::NoAdapter => d(NO_ADAPTER, INSTALL).notes(ELSEWHERE.iter().map(|note| (*note).to_owned())),
            E::UnknownAdapter { found, .. } => d("OR0902", "name one of them, or a part of its name, in any case")
                .notes(found.into_iter().map(|name| format!("there is `{name}`"))),
            E::Device { why, .. } => {
                d("OR0903", "choose another adapter with `--adapter NAME` or the variable WGPU_ADAPTER_NAME")
                    .note(why)
            }
            E::Lost(why) => d(
                "OR0904",
                "drivers give up on work that takes too long: lower `quality` or the size, or choose a software adapter \
                 (`--adapter llvmpipe`)",
            )
            .notes((!why.trim().is_empty()).then(|| why.trim().to_owned())),
            E::OutOfMemory => d("OR0905", "make the picture smaller: it takes 16 bytes a pixel, on the GPU and off it"),
            E::Refused(why) => d(
                "OR0906",
                "`orogen check` finds what is wrong with a shader by itself; what is left is how it is used here: a \
                 fragment entry point that returns `@location(0) vec4f`, and three vertices without buffers",
            )
            .notes(lines(&why)),
            E::Panicked(why) => {
                d("OR0907", "this is a fault of wgpu or of the driver; try another adapter with `--adapter NAME`")
                    .notes(lines(&why))
            }
            E::Size { width, height, limit } if width == 0 || height == 0 => {
                let _ = limit;
                d("OR0908", "both sides are at least 1 pixel, as in `--size 960x540`")
            }
            E::Size { limit, .. } => {
                d("OR0908", &format!("this adapter draws at most {limit}×{limit}"))
            }
            E::Shot { help, .. } => d("OR0909", help),
            E::NoFragment { has } => d(
                "OR0910",
                "give it `fn main_image(frag_coord: vec2f) -> vec4f`, or a `@fragment` entry point of its own",
            )
            .note(if has.is_empty() {
                "it has no entry point at all".to_owned()
            } else {
                format!("it has {}", has.join(", "))
            }),
            E::Bindings { .. } => d(
                "OR0911",
                "without a host there are only the parameters; export the shader and bind the rest in your own renderer",
            ),
            E::Format { .. } => d("OR0912", "end its name in `.png` or `.jpg` (8-bit sRGB), or in `.exr` (linear light, 32-bit float)"),
            E::Encode(_) => d("OR0913", "a smaller picture may do"),
            E::Projection { .. } => d(
                "OR0914",
                "include `<camera/camera.wgsl>` and ask its `camera_ray` for the ray of each pixel: all projections come with it",
            ),
        }
    }
}

/// What wgpu says, without its heading and its empty lines.
fn lines(why: &str) -> Vec<String> {
    let lines = why.lines().map(str::trim).filter(|line| !line.is_empty());
    lines.filter(|line| !matches!(*line, "Validation Error" | "Caused by:")).map(str::to_owned).collect()
}

/// The one command that brings a software adapter.
const INSTALL: &str = if cfg!(target_os = "linux") {
    "install Mesa's software adapter: `apt-get install -y mesa-vulkan-drivers libvulkan1`"
} else if cfg!(windows) {
    "install a Vulkan loader with `winget install KhronosGroup.VulkanRT`, and your GPU's driver"
} else if cfg!(target_vendor = "apple") {
    "Metal needs a GPU; in a virtual machine, turn its graphics acceleration on"
} else {
    "wgpu has no back end for this system: export the shader, and draw it elsewhere"
};

/// And where that command is another one.
const ELSEWHERE: &[&str] = if cfg!(target_os = "linux") {
    &[
        "in a checkout of Orogen, `cargo xtask demo` installs one and goes on",
        "on Fedora: `dnf install -y mesa-vulkan-drivers vulkan-loader`",
        "on Arch: `pacman -S vulkan-swrast vulkan-icd-loader`",
    ]
} else {
    &[]
};

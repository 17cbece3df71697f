//! A name, or none → [`Gpu`]: an adapter with a device open on it.

use std::sync::{Arc, Mutex, PoisonError};

use super::error::RenderError;
use crate::check::guarded;
use crate::diagnostic::Error;

/// The variable that names the adapter where the command line does not.
const ADAPTER: &str = "WGPU_ADAPTER_NAME";

/// A GPU, or a software one, ready for work. It may be shared between threads; a clone is the same one.
#[derive(Clone)]
pub struct Gpu {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    name: String,
    software: bool,
    lost: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens the adapter whose name contains `name`, in whatever case; without `name`, the one that the environment
    /// variable `WGPU_ADAPTER_NAME` names; without either, the fastest kind there is.
    ///
    /// # Errors
    /// Where there is no adapter at all ([`is_no_adapter`](super::is_no_adapter) tells), none of that name, or its
    /// device cannot be opened.
    pub fn new(name: Option<&str>) -> Result<Self, Error> {
        let from_environment = std::env::var(ADAPTER).ok().filter(|name| !name.trim().is_empty());
        let name = name.map(str::to_owned).or(from_environment);
        let opened =
            guarded(|| open(name.as_deref())).unwrap_or_else(|why| Err(RenderError::Panicked(why.0)));
        opened.map_err(Error::from)
    }

    /// The host's own device. Its callbacks for lost devices and uncaptured errors stay the host's: what goes wrong with
    /// work that is done here comes back as an error.
    pub fn of(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let info = device.adapter_info();
        Self {
            device: device.clone(),
            queue: queue.clone(),
            name: info.name,
            software: info.device_type == wgpu::DeviceType::Cpu,
            lost: Arc::default(),
        }
    }

    /// The adapter's name, as its driver gives it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether it runs on the CPU.
    pub fn is_software(&self) -> bool {
        self.software
    }

    /// The largest width and height of a picture.
    pub fn max_size(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }

    /// Why the device is gone, if it is.
    pub(super) fn lost(&self) -> Option<String> {
        self.lost.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

fn open(name: Option<&str>) -> Result<Gpu, RenderError> {
    if wgpu::Instance::enabled_backend_features().is_empty() {
        return Err(RenderError::NoAdapter);
    }
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        flags: wgpu::InstanceFlags::empty(), // validation layers print to stderr, and wgpu validates anyway
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let mut adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    adapters.sort_by_key(|adapter| rank(adapter.get_info().device_type));
    if adapters.is_empty() {
        return Err(RenderError::NoAdapter);
    }
    let names: Vec<_> = adapters.iter().map(|adapter| adapter.get_info().name).collect();
    let wanted = name.unwrap_or_default().trim().to_lowercase();
    let found = names.iter().position(|name| name.to_lowercase().contains(&wanted));
    let Some(index) = found else {
        return Err(RenderError::UnknownAdapter { name: name.unwrap_or_default().into(), found: names });
    };
    let adapter = &adapters[index];
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("orogen"),
        required_limits: limits(&adapter.limits()),
        memory_hints: wgpu::MemoryHints::MemoryUsage,
        ..Default::default()
    }))
    .map_err(|why| RenderError::Device { adapter: names[index].clone(), why: why.to_string() })?;
    let lost = Arc::new(Mutex::new(None));
    let slot = lost.clone();
    device.set_device_lost_callback(move |_, why| {
        *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(why);
    });
    // Error scopes catch what is caused here; wgpu's own handler for anything else would panic.
    device.on_uncaptured_error(Arc::new(|_| {}));
    let software = adapter.get_info().device_type == wgpu::DeviceType::Cpu;
    Ok(Gpu { device, queue, name: names[index].clone(), software, lost })
}

/// Fast kinds first.
fn rank(kind: wgpu::DeviceType) -> u8 {
    match kind {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    }
}

/// What WebGPU guarantees; more only where a bigger picture or table comes of it.
fn limits(adapter: &wgpu::Limits) -> wgpu::Limits {
    let guaranteed = wgpu::Limits::defaults();
    wgpu::Limits {
        max_texture_dimension_2d: adapter.max_texture_dimension_2d.max(guaranteed.max_texture_dimension_2d),
        max_buffer_size: adapter.max_buffer_size.max(guaranteed.max_buffer_size),
        ..guaranteed
    }
}

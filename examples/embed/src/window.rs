//! A window: the engine in a loop, and Orogen's fragments watched from a thread beside it.

#![allow(clippy::print_stderr, reason = "an example says what it does")]

use std::collections::HashSet;
use std::sync::Arc;
use std::time::{Duration, Instant};

use orogen::watch::{Made, Recipe, Watch};
use orogen::{Bake, Error};
use winit::application::ApplicationHandler;
use winit::event::{ElementState, MouseButton, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::keyboard::{KeyCode, PhysicalKey};
use winit::window::{Window, WindowId};

use crate::camera::Camera;
use crate::engine::{Engine, Targets};
use crate::landscape::{self, Landscape};
use crate::world;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;
/// What the thread that watches has to say.
type News = Result<Box<Made>, Error>;

/// Steps and turns of a second.
const WALK: f32 = 40.0;
const TURN: f32 = 0.002;
const SUN: f32 = 10.0;

/// So long may a picture take that somebody waits for; on a slow GPU it is a rough one, and a fine one comes after it.
const SOON: Duration = Duration::from_millis(40);
/// Pixels that share one of light, each way, while it is not known what a pixel takes, and at most.
const ROUGH: u32 = 8;
const ROUGHEST: u32 = 16;

/// While the preset is edited, all its numbers are live: saving another value of one compiles nothing.
fn edited() -> Bake {
    Bake::live(["*"]).at_binding(1, 0)
}

/// Opens a window of `size`, and stays until it is closed.
pub fn run(size: [u32; 2], set: &[String]) -> Fallible<()> {
    let events = EventLoop::<News>::with_user_event().build()?;
    events.set_control_flow(ControlFlow::Wait);
    watch(events.create_proxy(), set.to_vec())?;
    let mut app = App { size, set: set.to_vec(), view: None, failed: None };
    events.run_app(&mut app)?;
    app.failed.map_or(Ok(()), Err)
}

/// Hot reload: whenever a file of the world is saved, its shader is composed again, and sent to the window.
fn watch(proxy: EventLoopProxy<News>, set: Vec<String>) -> Fallible<()> {
    let mut recipe = Recipe::new(landscape::library()?, edited(), move |_, _| world::preset(&set));
    recipe.files.push(world::PRESET.into());
    let mut watch = Watch::new(recipe)?;
    let _ = watch.next(Duration::ZERO); // what there is by now, the window has by itself
    std::thread::spawn(move || {
        while let Some(news) = watch.next(Duration::MAX) {
            if proxy.send_event(news.map(Box::new)).is_err() {
                return; // the window is closed
            }
        }
    });
    Ok(())
}

struct App {
    size: [u32; 2],
    set: Vec<String>,
    view: Option<View>,
    failed: Option<Box<dyn std::error::Error>>,
}

struct View {
    window: Arc<Window>,
    surface: wgpu::Surface<'static>,
    settings: wgpu::SurfaceConfiguration,
    engine: Engine,
    targets: Targets,
    /// For pictures that are to come soon: room for them, and how many pixels share one of light in it, each way.
    rough: Option<(u32, Targets)>,
    /// Whether this window has seen a picture of these pipelines: drivers compile while they draw the first.
    is_warm: bool,
    /// What a pixel of light takes, where that is known.
    pace: Option<Duration>,
    camera: Camera,
    keys: HashSet<KeyCode>,
    cursor: [f32; 2],
    is_turning: bool,
    last: Instant,
    /// When the file was saved of which the next picture is, and whether ground and sun are to be asked for anew after it.
    saved: Option<(Instant, bool)>,
}

impl ApplicationHandler<News> for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        match View::open(events, self.size, &self.set) {
            Ok(view) => self.view = Some(view),
            Err(why) => self.fail(events, why),
        }
    }

    fn user_event(&mut self, _: &ActiveEventLoop, news: News) {
        let Some(view) = &mut self.view else { return };
        let outcome = news.map_err(Into::into).and_then(|made| {
            let saved = Instant::now().checked_sub(made.took).unwrap_or_else(Instant::now);
            let is_tuned = view.engine.retune(&made.shader, &made.preset);
            if !is_tuned {
                let landscape = Landscape::new(&view.engine.device, made.shader, made.preset);
                view.engine.set_landscape(landscape)?;
                world::stand(&mut view.engine)?;
                (view.is_warm, view.pace) = (false, None);
            }
            view.saved = Some((saved, is_tuned));
            Ok(())
        });
        if let Err::<_, Box<dyn std::error::Error>>(why) = outcome {
            eprintln!("{why}\nthe picture stays as it was");
        }
        view.window.request_redraw();
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(view) = &mut self.view else { return };
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::Resized(size) => view.resize([size.width, size.height]),
            WindowEvent::MouseInput { state, button: MouseButton::Left, .. } => {
                view.is_turning = state == ElementState::Pressed;
                view.window.request_redraw();
            }
            WindowEvent::CursorMoved { position, .. } => {
                let (x, y) = (position.x as f32, position.y as f32);
                if view.is_turning {
                    view.camera.azimuth += TURN * (x - view.cursor[0]);
                    view.camera.elevation =
                        (view.camera.elevation - TURN * (y - view.cursor[1])).clamp(-1.5, 1.5);
                    view.window.request_redraw();
                }
                view.cursor = [x, y];
            }
            WindowEvent::KeyboardInput { event, .. } => {
                let PhysicalKey::Code(key) = event.physical_key else { return };
                if view.keys.is_empty() {
                    view.last = Instant::now(); // it stood still until now
                }
                match event.state {
                    ElementState::Pressed => view.keys.insert(key),
                    ElementState::Released => view.keys.remove(&key),
                };
                view.window.request_redraw();
            }
            WindowEvent::RedrawRequested => {
                if let Err(why) = view.draw() {
                    self.fail(events, why);
                }
            }
            _ => {}
        }
    }
}

impl App {
    fn fail(&mut self, events: &ActiveEventLoop, why: Box<dyn std::error::Error>) {
        self.failed = Some(why);
        events.exit();
    }
}

impl View {
    fn open(events: &ActiveEventLoop, [width, height]: [u32; 2], set: &[String]) -> Fallible<Self> {
        let attributes = Window::default_attributes()
            .with_title("embed")
            .with_inner_size(winit::dpi::PhysicalSize::new(width, height));
        let window = Arc::new(events.create_window(attributes)?);
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_with_display_handle(Box::new(
            events.owned_display_handle(),
        )));
        let surface = instance.create_surface(window.clone())?;
        let (adapter, device, queue) = world::device(&instance, Some(&surface))?;
        let formats = surface.get_capabilities(&adapter).formats;
        let format = formats.iter().find(|format| format.is_srgb()).or(formats.first());
        let format = *format.ok_or("the window takes no format")?;
        let size = window.inner_size();
        let mut settings = surface
            .get_default_config(&adapter, size.width.max(1), size.height.max(1))
            .ok_or("the adapter cannot draw onto this window")?;
        settings.format = format;
        surface.configure(&device, &settings);
        let mut engine = world::engine(device, queue, format, set, &edited())?;
        let camera = world::camera(&mut engine)?;
        let targets = engine.targets([settings.width, settings.height], 1, world::EXPOSURE);
        let (keys, last) = (HashSet::new(), Instant::now());
        Ok(Self {
            window,
            surface,
            settings,
            engine,
            targets,
            rough: None,
            is_warm: false,
            pace: None,
            camera,
            keys,
            cursor: [0.0; 2],
            is_turning: false,
            last,
            saved: None,
        })
    }

    fn resize(&mut self, [width, height]: [u32; 2]) {
        (self.settings.width, self.settings.height) = (width.max(1), height.max(1));
        self.surface.configure(&self.engine.device, &self.settings);
        self.targets = self.engine.targets([self.settings.width, self.settings.height], 1, world::EXPOSURE);
        self.rough = None;
        self.window.request_redraw();
    }

    /// How many pixels are to share one of light, each way: one, unless that takes too long for who waits.
    fn share(&self) -> u32 {
        let is_waited_for = self.saved.is_some() || self.is_turning || !self.keys.is_empty();
        match self.pace {
            None => ROUGH,
            Some(pace) if is_waited_for => {
                let pixels = f64::from(self.settings.width) * f64::from(self.settings.height);
                let long = pace.as_secs_f64() * pixels / SOON.as_secs_f64();
                (long.sqrt().ceil() as u32).clamp(1, ROUGHEST)
            }
            Some(_) => 1,
        }
    }

    /// Draws onto `display`, finely or roughly, and learns what that takes.
    fn paint(&mut self, display: &wgpu::TextureView) -> Fallible<()> {
        let share = self.share();
        if share > 1 && self.rough.as_ref().is_none_or(|(known, _)| *known != share) {
            let size = [self.settings.width, self.settings.height];
            self.rough = Some((share, self.engine.rough_targets(size, share, world::EXPOSURE)));
        }
        let targets = match &self.rough {
            Some((_, rough)) if share > 1 => rough,
            _ => &self.targets,
        };
        let start = Instant::now();
        self.engine.draw(&self.camera, targets, display)?;
        self.engine.device.poll(wgpu::PollType::wait_indefinitely())?;
        // A rough picture takes longer by the pixel: it counts only until there is a fine one.
        if self.is_warm && (share == 1 || self.pace.is_none()) {
            self.pace = Some(start.elapsed() / (targets.size[0] * targets.size[1]).max(1));
        }
        self.is_warm = true;
        if share > 1 {
            self.window.request_redraw(); // a fine one, unless somebody still waits
        }
        Ok(())
    }

    fn draw(&mut self) -> Fallible<()> {
        self.walk();
        use wgpu::CurrentSurfaceTexture as Current;
        match self.surface.get_current_texture() {
            Current::Success(frame) | Current::Suboptimal(frame) => {
                self.paint(&frame.texture.create_view(&Default::default()))?;
                self.window.pre_present_notify();
                self.engine.queue.present(frame);
            }
            Current::Outdated | Current::Lost => {
                self.surface.configure(&self.engine.device, &self.settings);
                self.window.request_redraw();
            }
            Current::Timeout | Current::Occluded => {}
            Current::Validation => return Err("the window cannot be drawn onto".into()),
        }
        if let Some((saved, is_tuned)) = self.saved.take() {
            eprintln!("drawn {:?} after the save", saved.elapsed());
            if is_tuned {
                // The picture came first; now things go where the ground is by now.
                self.engine.settle()?;
                world::stand(&mut self.engine)?;
                self.window.request_redraw();
            }
        }
        if !self.keys.is_empty() {
            self.window.request_redraw();
        }
        Ok(())
    }

    /// Moves as far as the keys that are held say.
    fn walk(&mut self) {
        let seconds = self.last.elapsed().as_secs_f32().min(0.2);
        self.last = Instant::now();
        let held = |keys: &[KeyCode]| if keys.iter().any(|key| self.keys.contains(key)) { 1.0 } else { 0.0 };
        let forward = held(&[KeyCode::KeyW, KeyCode::ArrowUp]) - held(&[KeyCode::KeyS, KeyCode::ArrowDown]);
        let right = held(&[KeyCode::KeyD, KeyCode::ArrowRight]) - held(&[KeyCode::KeyA, KeyCode::ArrowLeft]);
        let up = held(&[KeyCode::PageUp]) - held(&[KeyCode::PageDown]);
        let sun = held(&[KeyCode::BracketRight]) - held(&[KeyCode::BracketLeft]);
        let ahead = self.camera.forward();
        let aside = ahead.cross(glam::Vec3::Y).normalize();
        self.camera.eye += WALK * seconds * (forward * ahead + right * aside + up * glam::Vec3::Y);
        if sun != 0.0 {
            self.engine.turn_sun(SUN * seconds * sun);
        }
    }
}

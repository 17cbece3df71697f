//! Work for wgpu → its result, or what wgpu says about it. Scopes catch errors, nothing is printed and nothing aborts.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::Duration;

use super::adapter::Gpu;
use super::error::RenderError;
use crate::check::{Panicked, guarded};

/// How often, and how long each time, an idle GPU is waited for.
const TRIES: u32 = 600;
const TRY: Duration = Duration::from_millis(100);

impl Gpu {
    /// Runs `work` on a deep stack: naga, inside wgpu, recurses as deep as expressions nest.
    pub(super) fn guarded<T: Send>(
        &self,
        work: impl FnOnce() -> Result<T, RenderError> + Send,
    ) -> Result<T, RenderError> {
        let outcome = guarded(work).unwrap_or_else(|Panicked(why)| Err(RenderError::Panicked(why)));
        match self.lost() {
            Some(why) if outcome.is_err() => Err(RenderError::Lost(why)), // the cause of whatever else was said
            _ => outcome,
        }
    }

    /// Runs `work`; an error of wgpu on the way is the result.
    pub(super) fn scoped<T>(&self, work: impl FnOnce() -> Result<T, RenderError>) -> Result<T, RenderError> {
        let scopes =
            [wgpu::ErrorFilter::Validation, wgpu::ErrorFilter::Internal, wgpu::ErrorFilter::OutOfMemory];
        let scopes = scopes.map(|filter| self.device.push_error_scope(filter));
        let outcome = work();
        let mut first = None;
        for scope in scopes.into_iter().rev() {
            first = first.or(pollster::block_on(scope.pop()));
        }
        match first {
            None => outcome,
            Some(wgpu::Error::OutOfMemory { .. }) => Err(RenderError::OutOfMemory),
            Some(wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. }) => {
                Err(RenderError::Refused(description))
            }
        }
    }

    /// Submits `commands` and waits; then gives the first `len` bytes of `buffer` to `take`.
    pub(super) fn submit_and_read(
        &self,
        commands: wgpu::CommandEncoder,
        buffer: &wgpu::Buffer,
        len: u64,
        take: impl FnOnce(&[u8]),
    ) -> Result<(), RenderError> {
        self.scoped(|| {
            let (sender, receiver) = mpsc::channel();
            self.queue.submit([commands.finish()]);
            buffer.map_async(wgpu::MapMode::Read, ..len, move |outcome| drop(sender.send(outcome)));
            self.wait(&receiver)?;
            let view = buffer.get_mapped_range(..len).map_err(|why| RenderError::Refused(why.to_string()))?;
            take(&view);
            drop(view);
            buffer.unmap();
            Ok(())
        })
    }

    /// Waits for the GPU, and then for the buffer: where threads share a device, another one's poll may be the one that
    /// hands it over, a moment after this one's has returned.
    fn wait(&self, mapped: &Receiver<Result<(), wgpu::BufferAsyncError>>) -> Result<(), RenderError> {
        for _ in 0..TRIES {
            self.device
                .poll(wgpu::PollType::wait_indefinitely())
                .map_err(|why| RenderError::Refused(why.to_string()))?;
            if let Some(why) = self.lost() {
                return Err(RenderError::Lost(why));
            }
            match mapped.recv_timeout(TRY) {
                Ok(outcome) => return outcome.map_err(|why| RenderError::Refused(why.to_string())),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        Err(RenderError::Refused("the result was never handed over".into()))
    }
}

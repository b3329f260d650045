//! What bytes travel over.

use std::collections::VecDeque;
use std::fmt;
use std::io;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Most bytes handed to a link in one write. Larger writes to a serial driver can hang past their timeout.
pub const LARGEST_WRITE: usize = 64;

/// A connection that carries bytes both ways; dropping it closes it.
///
/// Calls may take longer than their timeout where a driver misbehaves, so a link belongs to a thread that nobody waits for.
pub trait Link: Send + fmt::Debug {
    /// Writes some of `bytes` (at most [`LARGEST_WRITE`]); returns how many were taken, 0 if none within `timeout`.
    ///
    /// # Errors
    /// The connection is gone or the driver failed.
    fn write_some(&mut self, bytes: &[u8], timeout: Duration) -> io::Result<usize>;

    /// Reads what is there into `buffer`; returns how many bytes, 0 if none came within `timeout`.
    ///
    /// # Errors
    /// The connection is gone ([`io::ErrorKind::BrokenPipe`]) or the driver failed.
    fn read_some(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize>;

    /// Bytes that were taken but have not gone out yet, as far as the driver tells.
    ///
    /// # Errors
    /// The connection is gone.
    fn queued(&mut self) -> io::Result<usize>;

    /// Forgets bytes that were taken but have not gone out yet, as far as the driver can.
    fn discard_queued(&mut self);
}

impl Link for Box<dyn Link> {
    fn write_some(&mut self, bytes: &[u8], timeout: Duration) -> io::Result<usize> {
        (**self).write_some(bytes, timeout)
    }

    fn read_some(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        (**self).read_some(buffer, timeout)
    }

    fn queued(&mut self) -> io::Result<usize> {
        (**self).queued()
    }

    fn discard_queued(&mut self) {
        (**self).discard_queued();
    }
}

/// One direction of a pipe.
#[derive(Debug, Default)]
struct Lane {
    state: Mutex<LaneState>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct LaneState {
    bytes: VecDeque<u8>,
    closed: bool,
}

impl Lane {
    fn lock(&self) -> MutexGuard<'_, LaneState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until `ready` or closed or the timeout.
    fn wait(&self, timeout: Duration, ready: impl Fn(&LaneState) -> bool) -> MutexGuard<'_, LaneState> {
        let until = Instant::now() + timeout;
        let mut state = self.lock();
        while !ready(&state) && !state.closed {
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                break;
            }
            state = self.changed.wait_timeout(state, left).unwrap_or_else(PoisonError::into_inner).0;
        }
        state
    }

    fn close(&self) {
        self.lock().closed = true;
        self.changed.notify_all();
    }
}

/// One end of a pipe within this process. Like a wire, it holds only few bytes: a writer notices that nobody reads.
#[derive(Debug)]
pub struct PipeEnd {
    incoming: Arc<Lane>,
    outgoing: Arc<Lane>,
}

/// Two connected ends.
#[must_use]
pub fn pipe() -> (PipeEnd, PipeEnd) {
    let (a, b) = (Arc::<Lane>::default(), Arc::<Lane>::default());
    (PipeEnd { incoming: Arc::clone(&a), outgoing: Arc::clone(&b) }, PipeEnd { incoming: b, outgoing: a })
}

impl Link for PipeEnd {
    fn write_some(&mut self, bytes: &[u8], timeout: Duration) -> io::Result<usize> {
        let mut state = self.outgoing.wait(timeout, |lane| lane.bytes.len() < LARGEST_WRITE);
        if state.closed {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let count = bytes.len().min(LARGEST_WRITE.saturating_sub(state.bytes.len()));
        state.bytes.extend(bytes.iter().take(count));
        self.outgoing.changed.notify_all();
        Ok(count)
    }

    fn read_some(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        let mut state = self.incoming.wait(timeout, |lane| !lane.bytes.is_empty());
        if state.closed && state.bytes.is_empty() {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let count = state.bytes.len().min(buffer.len());
        for (slot, byte) in buffer.iter_mut().zip(state.bytes.drain(..count)) {
            *slot = byte;
        }
        self.incoming.changed.notify_all();
        Ok(count)
    }

    fn queued(&mut self) -> io::Result<usize> {
        let state = self.outgoing.lock();
        if state.closed { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(state.bytes.len()) }
    }

    fn discard_queued(&mut self) {
        self.outgoing.lock().bytes.clear();
    }
}

impl Drop for PipeEnd {
    fn drop(&mut self) {
        self.incoming.close();
        self.outgoing.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_cross_in_both_directions() {
        let (mut a, mut b) = pipe();
        let mut buffer = [0; 8];
        assert_eq!(a.write_some(b"abc", Duration::ZERO).unwrap(), 3);
        assert_eq!(a.queued().unwrap(), 3);
        assert_eq!(b.read_some(&mut buffer, Duration::ZERO).unwrap(), 3);
        assert_eq!(&buffer[..3], b"abc");
        assert_eq!(b.write_some(b"d", Duration::ZERO).unwrap(), 1);
        assert_eq!(a.read_some(&mut buffer, Duration::ZERO).unwrap(), 1);
        assert_eq!(a.read_some(&mut buffer, Duration::ZERO).unwrap(), 0);
    }

    #[test]
    fn a_full_pipe_takes_nothing_and_a_closed_one_says_so() {
        let (mut a, b) = pipe();
        assert_eq!(a.write_some(&[7; 100], Duration::ZERO).unwrap(), LARGEST_WRITE);
        assert_eq!(a.write_some(&[7; 100], Duration::from_millis(1)).unwrap(), 0);
        a.discard_queued();
        assert_eq!(a.queued().unwrap(), 0);
        drop(b);
        assert_eq!(a.write_some(b"x", Duration::ZERO).unwrap_err().kind(), io::ErrorKind::BrokenPipe);
        assert_eq!(a.read_some(&mut [0], Duration::ZERO).unwrap_err().kind(), io::ErrorKind::BrokenPipe);
    }
}

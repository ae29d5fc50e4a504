//! Work without the interpreter, which an interrupt ends.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::Builder;
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::{PyResult, Python};

/// How often it is looked whether the user wants to end it.
const TICK: Duration = Duration::from_millis(50);
/// Stack of a thread that does what the main one would, in bytes.
const STACK: usize = 8 << 20;
/// Most threads that wait for the next work: no more are busy at a time than Python threads solve.
const MOST_WAITING: usize = 8;

/// What came of it.
pub(crate) enum Ended<T> {
    /// It came to its end.
    Done(T),
    /// The time was over before.
    Late,
}

type Job = Box<dyn FnOnce() + Send>;

/// A thread that does one piece of work after another, until its sender is dropped. To start one, and to fill its memory anew, takes longer than a short solve may.
struct Worker(Sender<Job>);

impl Worker {
    fn start() -> std::io::Result<Self> {
        let (sender, jobs) = channel::<Job>();
        Builder::new().stack_size(STACK).spawn(move || jobs.into_iter().for_each(|job| job()))?;
        Ok(Self(sender))
    }
}

/// Workers of one process that wait. The lock is taken while the interpreter is held, as it is where a process forks: no fork finds it locked.
struct Waiting {
    process: u32,
    workers: Vec<Worker>,
}

static WAITING: Mutex<Waiting> = Mutex::new(Waiting { process: 0, workers: Vec::new() });

fn waiting<T>(_holds_the_interpreter: Python<'_>, change: impl FnOnce(&mut Vec<Worker>) -> T) -> T {
    let mut waiting = WAITING.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    if waiting.process != process {
        // A fork has none of the threads, and one of them may have held a lock of its channel then: what is left of them is not touched.
        std::mem::forget(std::mem::take(&mut waiting.workers));
        waiting.process = process;
    }
    change(&mut waiting.workers)
}

/// Does `work` on another thread, without holding the interpreter, until it ends, the time is over or the user interrupts. In both other cases the flag that
/// `work` is given is set, and what it still does is left to itself.
pub(crate) fn run<T: Send + 'static>(
    py: Python<'_>,
    limit: Option<Duration>,
    work: impl FnOnce(&Arc<AtomicBool>) -> T + Send + 'static,
) -> PyResult<Ended<T>> {
    let stop = Arc::new(AtomicBool::new(false));
    let (sender, receiver) = channel();
    let end = limit.and_then(|limit| Instant::now().checked_add(limit));
    let theirs = Arc::clone(&stop);
    let job: Job = Box::new(move || {
        // Nobody listens any more where the user interrupted.
        let _ = sender.send(work(&theirs));
    });
    let refused = |error| PyRuntimeError::new_err(format!("no thread can be started: {error}"));
    let worker = waiting(py, Vec::pop).map_or_else(Worker::start, Ok).map_err(refused)?;
    worker
        .0
        .send(job)
        .map_err(|_| PyRuntimeError::new_err("a thread ended: please report the problem"))?;
    let ended = py.detach(|| {
        // The channel is of this thread alone.
        let receiver = receiver;
        loop {
            let left = end.map(|end| end.saturating_duration_since(Instant::now()));
            match receiver.recv_timeout(left.map_or(TICK, |left| left.min(TICK))) {
                Ok(found) => return Ok(Ended::Done(found)),
                Err(RecvTimeoutError::Disconnected) => {
                    let message = "the solver ended without an answer: please report the problem";
                    return Err(PyRuntimeError::new_err(message));
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
            let is_late = left.is_some_and(|left| left.is_zero());
            #[allow(
                clippy::redundant_closure_for_method_calls,
                reason = "the method itself is for one lifetime only"
            )]
            let signals = Python::attach(|py| py.check_signals());
            if signals.is_err() || is_late {
                stop.store(true, Ordering::Relaxed);
                return signals.map(|()| Ended::Late);
            }
        }
    });
    if matches!(ended, Ok(Ended::Done(_))) {
        waiting(py, |workers| {
            if workers.len() < MOST_WAITING {
                workers.push(worker);
            }
        });
    }
    ended
}

/// The result of work without a time limit, which an interrupt leaves to itself.
pub(crate) fn done<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    match run(py, None, |_| work())? {
        Ended::Done(found) => Ok(found),
        Ended::Late => Err(PyRuntimeError::new_err("there was no time limit")),
    }
}

//! Processes that compute.

use std::io::{self, BufReader, ErrorKind};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::sync::Semaphore;
use tokio::task::spawn_blocking;
use tokio::time::timeout;

use crate::frame;

/// Why there is no answer of a worker.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Unanswered {
    #[error("this took longer than {} s and was ended", .0.as_secs_f64())]
    Late(Duration),
    #[error("too many questions are waiting")]
    Crowded,
    #[error("the process that computed this has ended: {0}")]
    Ended(io::Error),
}

/// Workers, each a process of the program itself, kept while they are idle.
pub(crate) struct Pool {
    program: PathBuf,
    arguments: Vec<String>,
    idle: Mutex<Vec<Worker>>,
    places: Semaphore,
    limit: Duration,
    patience: Duration,
}

impl Pool {
    /// At most `size` workers at once, each of which runs `program` with `arguments`; a question waits for its turn up to `patience`, and may then take up to `limit`.
    pub(crate) fn new(
        program: PathBuf,
        arguments: Vec<String>,
        size: usize,
        [limit, patience]: [Duration; 2],
    ) -> Self {
        let idle = Mutex::new(Vec::with_capacity(size));
        Self { program, arguments, idle, places: Semaphore::new(size), limit, patience }
    }

    /// What a worker answers. Whoever asks no more ends the worker, unless it had answered.
    pub(crate) async fn answer(self: &Arc<Self>, question: Vec<u8>) -> Result<Vec<u8>, Unanswered> {
        let place = timeout(self.patience, self.places.acquire()).await;
        let Ok(Ok(_place)) = place else { return Err(Unanswered::Crowded) };
        let idle = lock(&self.idle).pop();
        let worker = match idle {
            Some(worker) => worker,
            None => Worker::start(&self.program, &self.arguments).map_err(Unanswered::Ended)?,
        };
        let mut ended = EndOnDrop(Some(Arc::clone(&worker.process)));
        let exchange = spawn_blocking(move || {
            let mut worker = worker;
            worker.exchange(&question).map(|answer| (worker, answer))
        });
        match timeout(self.limit, exchange).await {
            Err(_) => Err(Unanswered::Late(self.limit)),
            Ok(Err(error)) => Err(Unanswered::Ended(io::Error::other(error))),
            Ok(Ok(Err(error))) => Err(Unanswered::Ended(error)),
            Ok(Ok(Ok((worker, answer)))) => {
                ended.0 = None;
                lock(&self.idle).push(worker);
                Ok(answer)
            }
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

struct Worker {
    process: Arc<Mutex<Child>>,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Worker {
    fn start(program: &PathBuf, arguments: &[String]) -> io::Result<Self> {
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = command.spawn()?;
        let missing = || io::Error::from(ErrorKind::BrokenPipe);
        let input = process.stdin.take().ok_or_else(missing)?;
        let output = BufReader::new(process.stdout.take().ok_or_else(missing)?);
        Ok(Self { process: Arc::new(Mutex::new(process)), input, output })
    }

    fn exchange(&mut self, question: &[u8]) -> io::Result<Vec<u8>> {
        frame::write(&mut self.input, question)?;
        frame::read(&mut self.output)
    }
}

/// Ends the process unless it is taken out before.
struct EndOnDrop(Option<Arc<Mutex<Child>>>);

impl Drop for EndOnDrop {
    fn drop(&mut self) {
        let Some(process) = self.0.take() else { return };
        let end = move || {
            let mut process = lock(&process);
            // It may have ended by itself.
            let _ = process.kill();
            let _ = process.wait();
        };
        // Waiting for it takes a moment, which others need not wait for.
        drop(std::thread::Builder::new().spawn(end));
    }
}

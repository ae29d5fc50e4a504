//! Processes that compute.

use std::io::{self, BufReader, ErrorKind};
use std::path::PathBuf;
use std::pin::pin;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::task::spawn_blocking;
use tokio::time::{Instant, timeout, timeout_at};

use crate::frame;
use crate::lane::{Lane, Place};

/// Why there is no answer of a worker.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Unanswered {
    #[error("this took longer than {} s and was ended: fewer waves, kinks or measured points take less, and `shtaerman solve` in a terminal waits as long as it takes", .0.as_secs_f64())]
    Late(Duration),
    #[error("too many questions are waiting")]
    Crowded,
    #[error("the process that computed this has ended: {0}")]
    Ended(io::Error),
}

/// Workers, each a process of the program itself, kept while they are idle.
///
/// There are two lanes, so that what takes long does not keep what is short waiting, whoever asks it. A question begins among the quick ones. One that is not answered in a moment moves on to the long
/// ones where these have a place, and computes on. Where they have none it stays, until others wait for its place: then it gives way, and begins anew when its turn among the long ones comes.
pub(crate) struct Pool {
    program: PathBuf,
    arguments: Vec<String>,
    idle: Mutex<Vec<Worker>>,
    quick: Arc<Lane>,
    long: Arc<Lane>,
    times: Times,
}

/// How long questions wait and compute.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Times {
    /// From here on a question is not quick any more.
    pub(crate) moment: Duration,
    /// A question that computes longer is ended.
    pub(crate) limit: Duration,
    /// A question waits for its turn in a lane up to this.
    pub(crate) patience: Duration,
}

/// How often a question that is not quick any more looks whether it can move on, or has to give way.
const GLANCE: Duration = Duration::from_millis(20);

impl Pool {
    /// At most `size` workers at once in each lane, each of which runs `program` with `arguments`.
    pub(crate) fn new(program: PathBuf, arguments: Vec<String>, size: usize, times: Times) -> Self {
        let idle = Mutex::new(Vec::with_capacity(2 * size));
        Self { program, arguments, idle, quick: Lane::new(size), long: Lane::new(size), times }
    }

    /// What a worker answers. Whoever asks no more ends the worker, unless it had answered.
    pub(crate) async fn answer(&self, question: Vec<u8>) -> Result<Vec<u8>, Unanswered> {
        let question: Arc<[u8]> = question.into();
        if let Some(answer) = self.begun(&question).await? {
            return Ok(answer);
        }
        let _place = self.place(&self.long).await?;
        let late = |_| Unanswered::Late(self.times.limit);
        timeout(self.times.limit, self.exchange(question)).await.map_err(late)?
    }

    async fn place(&self, lane: &Arc<Lane>) -> Result<Place, Unanswered> {
        timeout(self.times.patience, lane.place()).await.map_err(|_| Unanswered::Crowded)
    }

    /// The answer to a question that begins among the quick ones; none where it had to give way.
    async fn begun(&self, question: &Arc<[u8]>) -> Result<Option<Vec<u8>>, Unanswered> {
        let place = self.place(&self.quick).await?;
        let Times { moment, limit, .. } = self.times;
        let end = Instant::now() + limit;
        let mut exchange = pin!(self.exchange(Arc::clone(question)));
        let mut glance = Instant::now() + moment;
        loop {
            if let Ok(answer) = timeout_at(glance.min(end), &mut exchange).await {
                return answer.map(Some);
            }
            if Instant::now() >= end {
                return Err(Unanswered::Late(limit));
            }
            if let Some(_long) = self.long.free_place() {
                drop(place);
                let answer = timeout_at(end, exchange).await;
                return answer.map_err(|_| Unanswered::Late(limit))?.map(Some);
            }
            if self.quick.is_crowded() {
                return Ok(None);
            }
            glance = Instant::now() + GLANCE;
        }
    }

    async fn exchange(&self, question: Arc<[u8]>) -> Result<Vec<u8>, Unanswered> {
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
        match exchange.await {
            Err(error) => Err(Unanswered::Ended(io::Error::other(error))),
            Ok(Err(error)) => Err(Unanswered::Ended(error)),
            Ok(Ok((worker, answer))) => {
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

//! The server.

use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::num::NonZero;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use http_body_util::{BodyExt, Full, LengthLimitError, Limited};
use hyper::body::{Body, Bytes, Incoming};
use hyper::header::{CONTENT_TYPE, HeaderValue};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Request, Response, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpStream;
use tokio::sync::Semaphore;
use tokio::time::{sleep, timeout};

use crate::assets::ASSETS;
use crate::guard;
use crate::pool::{Pool, Times, Unanswered};

/// The port that is tried first, so that links and what the browser keeps stay the same from one day to the next.
pub const DEFAULT_PORT: u16 = 4117;

const JSON: &str = "application/json";
const TEXT: &str = "text/plain; charset=utf-8";
/// Workers for what is quick, and as many for what takes long: more than one, so that a map does not keep a curve waiting.
const WORKERS: [usize; 2] = [2, 4];
/// Where the page asks what it begins with, which needs no worker.
const START: &str = "/api/start";

/// What may be asked of the server.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// The largest question, in bytes.
    pub body: usize,
    /// The time for the head of a request, and for its body.
    pub reading: Duration,
    /// The time that a computation may take; its process is ended then.
    pub computation: Duration,
    /// The time for which a question is quick: after that it gives way where others wait and what takes long fills its own places, and begins anew when its turn comes.
    pub moment: Duration,
    /// The time that a question waits for its turn.
    pub patience: Duration,
    /// Connections at once; more of them wait.
    pub connections: usize,
    /// The time after which a connection is ended, whatever is going on.
    pub lifetime: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            body: 16 << 20,
            reading: Duration::from_secs(10),
            computation: Duration::from_secs(20),
            moment: Duration::from_millis(500),
            patience: Duration::from_secs(60),
            connections: 128,
            lifetime: Duration::from_secs(600),
        }
    }
}

/// A place on the loopback: the port asked for, or [`DEFAULT_PORT`] and, where that is taken, any other.
///
/// # Errors
/// Those of the system, where the port asked for is taken or not permitted.
pub fn bind(port: Option<u16>) -> io::Result<TcpListener> {
    let on = |port| TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port)));
    match port {
        Some(port) => on(port),
        None => on(DEFAULT_PORT).or_else(|_| on(0)),
    }
}

/// Shows an address in the browser of the user.
///
/// # Errors
/// Those of the system, where there is no browser.
pub fn show(address: &str) -> io::Result<()> {
    open::that_detached(address)
}

/// The page on a port.
pub struct Server {
    port: u16,
    start: Bytes,
    pool: Pool,
    limits: Limits,
}

impl Server {
    /// The page that begins with `start` (JSON), and whose questions are answered by `program` with `arguments`, which calls [`work`](crate::work).
    #[must_use]
    pub fn new(
        port: u16,
        start: String,
        program: PathBuf,
        arguments: Vec<String>,
        limits: Limits,
    ) -> Self {
        let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
        let size = processors.clamp(WORKERS[0], WORKERS[1]);
        let Limits { moment, computation, patience, .. } = limits;
        let times = Times { moment, limit: computation, patience };
        let pool = Pool::new(program, arguments, size, times);
        Self { port, start: Bytes::from(start), pool, limits }
    }

    /// Serves until the process ends.
    ///
    /// # Errors
    /// Those of the system, before anything is served.
    pub fn run(self, listener: TcpListener) -> io::Result<Infallible> {
        listener.set_nonblocking(true)?;
        let runtime =
            tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build()?;
        runtime.block_on(Arc::new(self).accept(listener))
    }

    async fn accept(self: Arc<Self>, listener: TcpListener) -> io::Result<Infallible> {
        let listener = tokio::net::TcpListener::from_std(listener)?;
        let places = Arc::new(Semaphore::new(self.limits.connections));
        loop {
            let Ok(place) = Arc::clone(&places).acquire_owned().await else {
                return Err(io::Error::other("no connection can be taken any more"));
            };
            match listener.accept().await {
                Ok((stream, _)) => {
                    let server = Arc::clone(&self);
                    tokio::spawn(async move {
                        server.connection(stream).await;
                        drop(place);
                    });
                }
                // Too many open files, or one that left: others may come.
                Err(_) => sleep(Duration::from_millis(10)).await,
            }
        }
    }

    async fn connection(self: Arc<Self>, stream: TcpStream) {
        // Small answers go at once.
        let _ = stream.set_nodelay(true);
        let lifetime = self.limits.lifetime;
        let service = service_fn(|request| {
            let server = Arc::clone(&self);
            async move { Ok::<_, Infallible>(server.respond(request).await) }
        });
        let mut http = http1::Builder::new();
        http.timer(TokioTimer::new()).header_read_timeout(self.limits.reading);
        // What goes wrong on a connection is the end of it, and of nothing else.
        let _ = timeout(lifetime, http.serve_connection(TokioIo::new(stream), service)).await;
    }

    async fn respond(&self, request: Request<Incoming>) -> Response<Full<Bytes>> {
        let path = request.uri().path().to_owned();
        let mut response = match guard::check(request.method(), &path, request.headers(), self.port)
        {
            Err(refused) => {
                let mut response = told(refused.status(), &refused.to_string());
                refused.headers(response.headers_mut());
                response
            }
            Ok(()) => match path.strip_prefix(guard::API) {
                Some(_) if path == START => body(JSON, self.start.clone()),
                Some(operation) => self.answer(operation, request.into_body()).await,
                None => file(&path),
            },
        };
        guard::secure(response.headers_mut());
        response
    }

    async fn answer(&self, operation: &str, incoming: Incoming) -> Response<Full<Bytes>> {
        let too_large = || {
            let message = format!("a question has at most {} bytes", self.limits.body);
            told(StatusCode::PAYLOAD_TOO_LARGE, &message)
        };
        // What it says of its own length is enough to refuse it.
        if incoming.size_hint().lower() > self.limits.body as u64 {
            return too_large();
        }
        let limited = Limited::new(incoming, self.limits.body).collect();
        let read = match timeout(self.limits.reading, limited).await {
            Err(_) => {
                return told(StatusCode::REQUEST_TIMEOUT, "the question did not come to its end");
            }
            Ok(Err(error)) if error.is::<LengthLimitError>() => return too_large(),
            Ok(Err(_)) => return told(StatusCode::BAD_REQUEST, "the question broke off"),
            Ok(Ok(read)) => read.to_bytes(),
        };
        let question = [operation.as_bytes(), b"\n", &read].concat();
        match self.pool.answer(question).await {
            Ok(answer) => body(JSON, answer.into()),
            Err(unanswered @ Unanswered::Crowded) => {
                told(StatusCode::SERVICE_UNAVAILABLE, &unanswered.to_string())
            }
            Err(unanswered @ Unanswered::Late(_)) => {
                told(StatusCode::GATEWAY_TIMEOUT, &unanswered.to_string())
            }
            Err(unanswered @ Unanswered::Ended(_)) => {
                told(StatusCode::BAD_GATEWAY, &unanswered.to_string())
            }
        }
    }
}

fn file(path: &str) -> Response<Full<Bytes>> {
    match ASSETS.iter().find(|asset| asset.path == path) {
        Some(asset) => body(asset.content_type, Bytes::from_static(asset.bytes)),
        None => {
            let missing = guard::Refused::Missing;
            told(missing.status(), &missing.to_string())
        }
    }
}

fn body(kind: &'static str, bytes: Bytes) -> Response<Full<Bytes>> {
    let mut response = Response::new(Full::new(bytes));
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response
}

fn told(status: StatusCode, message: &str) -> Response<Full<Bytes>> {
    let mut response = body(TEXT, Bytes::from(format!("{message}\n")));
    *response.status_mut() = status;
    response
}

use std::io::{self, Write};
use std::net::TcpStream;
use std::str::FromStr as _;
use std::sync::Arc;
use std::time::Duration;

use re_grpc_client::write::{Client, ClientConnectionState, Options};
use re_log_encoding::DecoderApp;
use re_uri::ProxyUri;

use crate::recording::rerun_file::RerunStream;
use crate::recording::{RecordingError, Subject};
use crate::telemetry::Samples;

/// A Rerun viewer that is open and shows the run as it goes.
pub struct LiveViewer {
    address: String,
    client: Arc<Client>,
    recording: RerunStream<Relay>,
}

/// The bytes of an `.rrd`, on their way to a viewer as messages.
struct Relay {
    decoder: DecoderApp,
    client: Arc<Client>,
}

impl LiveViewer {
    /// How long a viewer that has answered may take for what is still on its way at the end.
    const PATIENCE: Duration = Duration::from_mins(10);

    /// Sends everything that is known before the first sample to the viewer at `address`, such as
    /// `rerun+http://127.0.0.1:9876/proxy`, which is where a viewer listens unless told otherwise.
    ///
    /// # Errors
    /// If the address is none, or no viewer answers there.
    pub fn connect(subject: &Subject, address: &str) -> Result<Self, RecordingError> {
        let refused = |source| RecordingError::NoViewer { address: address.into(), source };
        let uri = ProxyUri::from_str(address).map_err(|error| refused(io::Error::other(error.to_string())))?;
        // The client below tries for ever: whether anybody is there is asked first.
        let host = uri.origin.format_host();
        TcpStream::connect((host.trim_matches(['[', ']']), uri.origin.port)).map_err(refused)?;
        let client = Arc::new(Client::new(uri, Options::default()));
        let relay = Relay { decoder: DecoderApp::new(), client: Arc::clone(&client) };
        let recording = RerunStream::begin(subject, relay, address.into())?;
        let viewer = Self { address: address.into(), client, recording };
        viewer.flush()?;
        Ok(viewer)
    }

    /// Sends one batch; waits where the viewer is slower than the run.
    ///
    /// # Errors
    /// If the viewer has gone.
    pub fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        self.recording.write(samples)
    }

    /// Waits until the viewer has everything.
    ///
    /// # Errors
    /// If it has gone.
    pub fn finish(mut self) -> Result<(), RecordingError> {
        self.recording.complete()?;
        self.flush()
    }

    fn flush(&self) -> Result<(), RecordingError> {
        let flushed = self.client.flush_blocking(Self::PATIENCE);
        flushed.map_err(|error| RecordingError::NoViewer {
            address: self.address.clone(),
            source: io::Error::other(error.to_string()),
        })
    }
}

impl Write for Relay {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.decoder.push_byte_chunk(bytes.to_vec());
        while let Some(message) = self.decoder.try_read().map_err(|error| io::Error::other(error.to_string()))? {
            self.client.send_blocking(message);
        }
        // A message for a viewer that has gone is dropped without a word.
        match self.client.status() {
            ClientConnectionState::Disconnected(_) => {
                Err(io::Error::new(io::ErrorKind::BrokenPipe, "the viewer has gone"))
            }
            _ => Ok(bytes.len()),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl std::fmt::Debug for LiveViewer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LiveViewer").field("address", &self.address).finish_non_exhaustive()
    }
}

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::RecordingError;

/// A file that has its name only once it is whole: until [`Self::publish`] it is `NAME.part`, in the same folder.
///
/// What was written reaches the operating system about once a second, at the end of a batch, so the part file of a
/// killed run is readable that far. It is locked while it is being written: a second run into the same name is refused. The part file that a
/// killed run left is refused like a finished one, as it may be all there is of that run, and replaced on overwriting.
///
/// The first failure is the last write: every later call fails too, so a file with a hole is never published.
#[derive(Debug)]
pub struct PartFile {
    path: PathBuf,
    part: PathBuf,
    overwrite: bool,
    buffer: BufWriter<Disk>,
    bytes: u64,
    flushed: Instant,
    flush_every: Duration,
    failure: Option<String>,
    published: bool,
}

/// The file behind the buffer, and how many bytes it still takes.
#[derive(Debug)]
struct Disk {
    file: File,
    room: u64,
}

impl PartFile {
    /// Gathers small writes; what is larger, as chunks of recordings are, goes to the system without being copied.
    const BUFFER: usize = 1 << 16;
    const FLUSH_EVERY: Duration = Duration::from_secs(1);

    /// Creates `NAME.part` beside `path`, empty and locked.
    ///
    /// # Errors
    /// If `path` is a folder; if it exists, or the part file of a killed run, and `overwrite` is not set; if another
    /// run is writing to it; if the operating system refuses.
    pub fn create(path: &Path, overwrite: bool) -> Result<Self, RecordingError> {
        Self::create_as(path, part_path(path), overwrite)
    }

    /// The same with `NAME.word.mcap.part` for a part file: `NAME.mcap.part` may be what is being read.
    ///
    /// # Errors
    /// As [`Self::create`].
    pub fn create_apart(path: &Path, word: &str, overwrite: bool) -> Result<Self, RecordingError> {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        Self::create_as(path, part_path(&path.with_extension(format!("{word}.{extension}"))), overwrite)
    }

    fn create_as(path: &Path, part: PathBuf, overwrite: bool) -> Result<Self, RecordingError> {
        if path.is_dir() {
            return Err(io_error("write", path, ErrorKind::IsADirectory.into()));
        }
        if !overwrite && exists(path)? {
            return Err(RecordingError::Exists { path: path.into() });
        }
        clear_the_way(&part, overwrite)?;
        let created = OpenOptions::new().write(true).create_new(true).open(&part);
        let file = created.map_err(|source| io_error("create", &part, source))?;
        lock(&file, &part)?;
        if !is_at(&file, &part) {
            return Err(being_written(&part));
        }
        Ok(Self {
            path: path.into(),
            part,
            overwrite,
            buffer: BufWriter::with_capacity(Self::BUFFER, Disk { file, room: u64::MAX }),
            bytes: 0,
            flushed: Instant::now(),
            flush_every: Self::FLUSH_EVERY,
            failure: None,
            published: false,
        })
    }

    /// The same file on a disk that is full after `bytes` more bytes: for quotas, and to see what a full disk does.
    #[must_use]
    pub fn with_room_for(mut self, bytes: u64) -> Self {
        self.buffer.get_mut().room = bytes;
        self
    }

    /// The same file, of whose last `interval` of writing a killed run may lose what it wrote, and not of the last
    /// second.
    #[must_use]
    pub fn flushing_every(mut self, interval: Duration) -> Self {
        self.flush_every = interval;
        self
    }

    /// Hands everything that was written to the operating system, if that was last done long enough ago. Sinks call it
    /// after each batch, so that a part file holds whole batches however long the next one takes.
    ///
    /// # Errors
    /// If that fails, or something failed before.
    pub fn flush_if_due(&mut self) -> io::Result<()> {
        if self.flushed.elapsed() >= self.flush_every { self.flush() } else { Ok(()) }
    }

    /// The name it gets when it is published.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The name it has until then.
    #[must_use]
    pub fn part(&self) -> &Path {
        &self.part
    }

    /// How many bytes were written to it.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Brings everything that was written to the disk itself.
    ///
    /// # Errors
    /// If that fails, or something failed before.
    pub fn sync(&mut self) -> Result<(), RecordingError> {
        self.flush().map_err(|source| io_error("write", &self.part, source))?;
        let synced = self.buffer.get_ref().file.sync_all();
        self.remember(synced).map_err(|source| io_error("sync", &self.part, source))
    }

    /// Makes the file durable and gives it its name. A file that got that name meanwhile is not overwritten, unless
    /// overwriting was asked for.
    ///
    /// # Errors
    /// If that fails, or something failed before; the part file then stays.
    pub fn publish(mut self) -> Result<(), RecordingError> {
        self.sync()?;
        if self.overwrite {
            self.rename()?;
        } else {
            self.rename_to_free_name()?;
        }
        self.published = true;
        let path = self.path.clone();
        // Closed first: where no more files may be open, this makes room for the folder.
        drop(self);
        sync_folder(&path).map_err(|source| io_error("sync the folder of", &path, source))
    }

    /// Removes what was written: there is nothing in it that anybody would want.
    ///
    /// # Errors
    /// If that fails.
    pub fn discard(mut self) -> Result<(), RecordingError> {
        // Not to be removed a second time: the name may be another's by then.
        self.published = true;
        fs::remove_file(&self.part).map_err(|source| io_error("remove", &self.part, source))
    }

    fn rename(&self) -> Result<(), RecordingError> {
        fs::rename(&self.part, &self.path).map_err(|source| io_error("rename", &self.part, source))
    }

    /// A rename replaces what is there; a hard link never does. File systems without hard links get a look first.
    fn rename_to_free_name(&self) -> Result<(), RecordingError> {
        match fs::hard_link(&self.part, &self.path) {
            Ok(()) => fs::remove_file(&self.part).map_err(|source| io_error("remove", &self.part, source)),
            Err(refused) if refused.kind() == ErrorKind::AlreadyExists => {
                Err(RecordingError::Exists { path: self.path.clone() })
            }
            Err(_) if exists(&self.path)? => Err(RecordingError::Exists { path: self.path.clone() }),
            Err(_) => self.rename(),
        }
    }

    /// Passes a result on, after noting that nothing may be written after a failure.
    fn remember<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        if let Err(error) = &result {
            self.failure.get_or_insert_with(|| error.to_string());
        }
        result
    }

    fn refuse_after_failure(&self) -> io::Result<()> {
        match &self.failure {
            Some(failure) => Err(io::Error::other(format!("an earlier write failed: {failure}"))),
            None => Ok(()),
        }
    }
}

impl Write for PartFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.refuse_after_failure()?;
        let written = self.buffer.write(bytes);
        let written = self.remember(written)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.refuse_after_failure()?;
        self.flushed = Instant::now();
        let flushed = self.buffer.flush();
        self.remember(flushed)
    }
}

impl Drop for PartFile {
    /// An unpublished part file stays, unless nothing was ever written to it.
    fn drop(&mut self) {
        if !self.published && self.bytes == 0 {
            // Nobody is left to tell, and an empty part file is in nobody's way.
            let _ = fs::remove_file(&self.part);
        }
    }
}

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = usize::try_from(self.room).unwrap_or(usize::MAX).min(bytes.len());
        if taken == 0 && !bytes.is_empty() {
            return Err(io::Error::new(ErrorKind::StorageFull, "no room left for this file"));
        }
        let written = self.file.write(&bytes[..taken])?;
        self.room -= written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for Disk {
    /// Closing would not do: a process that this one starts meanwhile holds the same lock until it is under way.
    fn drop(&mut self) {
        // A file system without locks has none to give back.
        let _ = self.file.unlock();
    }
}

/// Removes the part file of a run that is no more: an empty one always, another one on overwriting.
///
/// It is removed, not truncated: a run killed between naming its file and removing the part has both names on one file.
fn clear_the_way(part: &Path, overwrite: bool) -> Result<(), RecordingError> {
    let stale = match OpenOptions::new().write(true).open(part) {
        Ok(file) => file,
        Err(missing) if missing.kind() == ErrorKind::NotFound => return Ok(()),
        Err(source) => return Err(io_error("open", part, source)),
    };
    lock(&stale, part)?;
    let bytes = stale.metadata().map_err(|source| io_error("open", part, source))?.len();
    if bytes > 0 && !overwrite {
        return Err(RecordingError::Exists { path: part.into() });
    }
    match fs::remove_file(part) {
        Err(source) if source.kind() != ErrorKind::NotFound => Err(io_error("remove", part, source)),
        _ => Ok(()),
    }
}

/// Takes the lock that says "being written", until the file is dropped. A file system without locks is taken as it is.
fn lock(file: &File, part: &Path) -> Result<(), RecordingError> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(being_written(part)),
        Err(TryLockError::Error(source)) if source.kind() != ErrorKind::Unsupported => {
            Err(io_error("lock", part, source))
        }
        _ => Ok(()),
    }
}

/// Whether `part` still names `file`: between creation and lock, another run may take it for an empty leftover.
#[cfg(unix)]
fn is_at(file: &File, part: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |metadata: fs::Metadata| (metadata.dev(), metadata.ino());
    let ours = file.metadata().map(identity);
    let named = fs::metadata(part).map(identity);
    matches!((ours, named), (Ok(ours), Ok(named)) if ours == named)
}

/// Elsewhere the standard library cannot tell.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Opens a part file that nobody is writing, and keeps others from writing it until it is closed.
pub(super) fn hold(part: &Path) -> Result<File, RecordingError> {
    let file = File::open(part).map_err(|source| io_error("open", part, source))?;
    match file.try_lock_shared() {
        Err(TryLockError::WouldBlock) => Err(being_written(part)),
        Err(TryLockError::Error(source)) if source.kind() != ErrorKind::Unsupported => {
            Err(io_error("lock", part, source))
        }
        _ => Ok(file),
    }
}

fn being_written(part: &Path) -> RecordingError {
    io_error("lock", part, io::Error::new(ErrorKind::WouldBlock, "another run is writing it"))
}

fn part_path(path: &Path) -> PathBuf {
    let mut part = OsString::from(path);
    part.push(".part");
    part.into()
}

fn exists(path: &Path) -> Result<bool, RecordingError> {
    path.try_exists().map_err(|source| io_error("look for", path, source))
}

/// Makes a rename durable. Only Unix opens folders.
fn sync_folder(path: &Path) -> io::Result<()> {
    if !cfg!(unix) {
        return Ok(());
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    File::open(folder)?.sync_all()
}

fn io_error(attempt: &'static str, path: &Path, source: io::Error) -> RecordingError {
    RecordingError::Io { attempt, path: path.into(), source }
}

#[cfg(test)]
mod tests {
    use std::io::Write as _;

    use super::PartFile;

    #[test]
    fn a_name_is_free_once_its_writer_is_gone_though_a_child_has_inherited_the_file() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("run.csv");
        let mut file = PartFile::create(&path, true).expect("a free name");
        file.write_all(b"time_s\n").expect("room");
        // What a fork does to an open file.
        let inherited = file.buffer.get_ref().file.try_clone().expect("a second descriptor");
        assert!(PartFile::create(&path, true).is_err(), "it is being written");
        drop(file);
        assert!(PartFile::create(&path, true).is_ok(), "nobody writes it any more");
        drop(inherited);
    }
}

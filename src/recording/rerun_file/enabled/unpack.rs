use std::panic::{AssertUnwindSafe, catch_unwind};

use re_chunk::Chunk;
use re_chunk::external::arrow::ipc::root_as_message;
use re_log_encoding::external::lz4_flex::block::decompress;
use re_log_encoding::{CachingApplicationIdInjector, Compression, CrateVersion, ToApplication as _};
use re_log_types::{ArrowMsg as Batch, LogMsg};
use re_protos::log_msg::v1alpha1::ArrowMsg;
use re_protos::log_msg::v1alpha1::log_msg::Msg;

/// The most that a compressed chunk may claim to unpack to: the claim is allocated before it is tested.
const LARGEST: u64 = 1 << 30;
/// The most that one byte of LZ4 unpacks to: a byte of length stands for 255.
const MOST_OF_A_BYTE: u64 = 255;

/// What a message of a file means, the file not being trusted.
///
/// # Errors
/// What is wrong with it.
pub(super) fn message(
    message: Msg,
    ids: &mut CachingApplicationIdInjector,
    version: CrateVersion,
) -> Result<LogMsg, String> {
    let message = match message {
        Msg::ArrowMsg(chunk) => Msg::ArrowMsg(unpack(chunk)?),
        other => other,
    };
    guarded(|| message.to_application((ids, Some(version))).map_err(|error| error.to_string()))
}

/// The chunk in a message.
///
/// # Errors
/// What is wrong with it.
pub(super) fn chunk(batch: &Batch) -> Result<Chunk, String> {
    guarded(|| Chunk::from_arrow_msg(batch).map_err(|error| error.to_string()))
}

/// Arrow's reader panics at some damaged offsets rather than returning an error. What it had in hand is dropped, so
/// nothing is left half done.
pub(super) fn guarded<T>(read: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| Err("a chunk that Arrow cannot take apart".to_owned()))
}

/// Undoes the compression, and holds every length against what is there: Arrow's reader allocates before it reads, and
/// no one survives a failed allocation.
fn unpack(mut chunk: ArrowMsg) -> Result<ArrowMsg, String> {
    if Compression::from(chunk.compression()) == Compression::LZ4 {
        let size = chunk.uncompressed_size;
        if size > LARGEST || size > MOST_OF_A_BYTE * chunk.payload.len() as u64 {
            return Err(format!("a chunk that claims {size} bytes"));
        }
        let size = usize::try_from(size).map_err(|error| error.to_string())?;
        chunk.payload = decompress(&chunk.payload, size).map_err(|error| error.to_string())?.into();
        chunk.set_compression(Compression::Off.into());
    }
    check_lengths(&chunk.payload)?;
    Ok(chunk)
}

/// Walks an Arrow stream: to each message belong a mark (four bytes 0xff), a length, that much metadata, and a body whose
/// length stands in the metadata.
fn check_lengths(mut rest: &[u8]) -> Result<(), String> {
    const MARK: [u8; 4] = [0xff; 4];
    while let Some((mark, after)) = rest.split_first_chunk::<4>() {
        let (length, after) = match (mark, after.split_first_chunk::<4>()) {
            (&MARK, Some((length, after))) => (length, after),
            (&MARK, None) => return Err("a chunk that breaks off".to_owned()),
            (length, _) => (length, after),
        };
        let length = usize::try_from(i32::from_le_bytes(*length)).map_err(|error| error.to_string())?;
        if length == 0 {
            return Ok(());
        }
        let (metadata, after) = after.split_at_checked(length).ok_or("a chunk whose head is longer than it is")?;
        let body = root_as_message(metadata).map_err(|error| error.to_string())?.bodyLength();
        let body = usize::try_from(body).map_err(|error| error.to_string())?;
        rest = after.get(body..).ok_or("a chunk whose body is longer than it is")?;
    }
    Ok(())
}

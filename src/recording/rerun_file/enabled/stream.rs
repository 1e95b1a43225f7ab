use std::io::Write;
use std::path::PathBuf;

use re_chunk::external::arrow::array::RecordBatch;
use re_chunk::external::arrow::datatypes::Schema;
use re_chunk::external::arrow::ipc::writer::StreamWriter;
use re_chunk::{Chunk, ChunkComponents, ChunkId, EntityPath, RowId, Span, TimeColumn};
use re_log_encoding::{
    Compression, Encodable as _, EncodingOptions, MessageHeader, MessageKind, RRD_FOURCC, RrdManifestBuilder,
    Serializer, StreamFooter, StreamHeader, ToTransport as _,
};
use re_log_types::{BlueprintActivationCommand, LogMsg, SetStoreInfo, StoreId, StoreInfo, StoreSource};
use re_protos::log_msg::v1alpha1::log_msg::Msg;
use re_protos::log_msg::v1alpha1::{ArrowMsg, Encoding, RrdFooter};
use re_sdk_types::{AsComponents, SerializedComponentColumn};
use re_tuid::Tuid;

use crate::recording::{PartFile, RecordingError};

/// The byte level of an `.rrd`: header, messages, and the footer that says where each chunk is.
///
/// Every id is counted, none is drawn or timed, and no hash map decides an order: the same calls give the same bytes.
pub(super) struct Stream<W> {
    writer: W,
    path: PathBuf,
    position: u64,
    buffer: Vec<u8>,
    /// A chunk as Arrow serialises it.
    payload: Vec<u8>,
    row_ids: Vec<RowId>,
    stores: Vec<(StoreId, RrdManifestBuilder)>,
    next_id: u64,
    compression: Compression,
}

/// One of a stream's stores.
#[derive(Debug, Clone, Copy)]
pub(super) struct Store(usize);

/// The rows of a chunk: how many, and when; without timelines they are static.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rows<'a> {
    pub(super) count: usize,
    pub(super) times: &'a [TimeColumn],
}

impl<W: Write> Stream<W> {
    /// Begins a stream; `path` is what messages name. Uncompressed: mantissas do not compress, and LZ4 costs more time than
    /// the rest saves.
    ///
    /// # Errors
    /// If the writer refuses.
    pub(super) fn begin(writer: W, path: PathBuf) -> Result<Self, RecordingError> {
        Self::begin_as(writer, path, Compression::Off)
    }

    /// The same of few samples, whose chunks are mostly words.
    ///
    /// # Errors
    /// If the writer refuses.
    pub(super) fn begin_compressed(writer: W, path: PathBuf) -> Result<Self, RecordingError> {
        Self::begin_as(writer, path, Compression::LZ4)
    }

    fn begin_as(writer: W, path: PathBuf, compression: Compression) -> Result<Self, RecordingError> {
        let mut stream = Self {
            writer,
            path,
            position: 0,
            buffer: Vec::new(),
            payload: Vec::new(),
            row_ids: Vec::new(),
            stores: Vec::new(),
            next_id: 1,
            compression,
        };
        let header = StreamHeader {
            fourcc: RRD_FOURCC,
            version: re_build_info::CrateVersion::LOCAL.to_bytes(),
            options: EncodingOptions { compression, serializer: Serializer::Protobuf },
        };
        header.to_rrd_bytes(&mut stream.buffer).map_err(|error| stream.refused(error))?;
        stream.send()?;
        Ok(stream)
    }

    /// Declares a store.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn open(&mut self, id: StoreId) -> Result<Store, RecordingError> {
        let row_id = self.reserve(0);
        let source = StoreSource::Other(concat!("polhode ", env!("CARGO_PKG_VERSION")).to_owned());
        let info = StoreInfo::new(id.clone(), source);
        self.stores.push((id, RrdManifestBuilder::default()));
        self.message(&LogMsg::SetStoreInfo(SetStoreInfo { row_id, info }))?;
        Ok(Store(self.stores.len() - 1))
    }

    /// Makes a store of layout the one that the viewer shows, now and after a reset.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn activate(&mut self, store: Store) -> Result<(), RecordingError> {
        let blueprint_id = self.stores[store.0].0.clone();
        let command = BlueprintActivationCommand { blueprint_id, make_active: true, make_default: true };
        self.message(&LogMsg::BlueprintActivationCommand(command))
    }

    /// Logs an archetype once, at `times` or for ever.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn once(
        &mut self,
        store: Store,
        entity: &str,
        times: &[TimeColumn],
        archetype: &dyn AsComponents,
    ) -> Result<(), RecordingError> {
        let columns = archetype.as_serialized_batches().into_iter().map(SerializedComponentColumn::from);
        self.columns(store, entity, Rows { count: 1, times }, columns)
    }

    /// Logs many rows of one entity; every column has one list a row.
    ///
    /// # Errors
    /// If the columns do not fit together, or cannot be written.
    pub(super) fn columns(
        &mut self,
        store: Store,
        entity: &str,
        rows: Rows<'_>,
        columns: impl IntoIterator<Item = SerializedComponentColumn>,
    ) -> Result<(), RecordingError> {
        let id = ChunkId::from_tuid(self.reserve(rows.count as u64));
        let first = self.next_id - rows.count as u64;
        self.row_ids.clear();
        self.row_ids.extend((first..self.next_id).map(|number| RowId::from_tuid(tuid(number))));
        let timelines = rows.times.iter().map(|column| (*column.timeline().name(), column.clone())).collect();
        let components: ChunkComponents =
            columns.into_iter().map(|column| (column.descriptor, column.list_array)).collect();
        let chunk =
            Chunk::from_native_row_ids(id, EntityPath::from(entity), Some(true), &self.row_ids, timelines, components)
                .map_err(|error| self.refused(error))?;
        let batch = chunk.to_chunk_batch().map_err(|error| self.refused(error))?;
        let message = self.serialized(store, &chunk, &RecordBatch::from(&batch))?;
        let uncompressed_size = message.uncompressed_size;
        let message = Msg::ArrowMsg(message);
        let length = message.to_rrd_bytes(&mut self.buffer).map_err(|error| self.refused(error))?;
        let header = MessageHeader::ENCODED_SIZE_BYTES as u64;
        let span = Span { start: self.position + header, len: length - header };
        let manifest = &mut self.stores[store.0].1;
        manifest.append(&batch, span, uncompressed_size).map_err(|error| self.refused(error))?;
        if let Msg::ArrowMsg(message) = message {
            // The allocation comes back to be filled anew.
            self.payload = message.payload.into();
        }
        self.send()
    }

    /// What the library's own conversion makes of a chunk, without parsing the chunk once more and in memory that is used
    /// again: fresh memory costs as much as filling it.
    fn serialized(&mut self, store: Store, chunk: &Chunk, batch: &RecordBatch) -> Result<ArrowMsg, RecordingError> {
        if self.compression != Compression::Off {
            return self.compressed(store, chunk, batch);
        }
        self.payload.clear();
        StreamWriter::try_new(&mut self.payload, batch.schema_ref())
            .and_then(|mut writer| {
                writer.write(batch)?;
                writer.finish()
            })
            .map_err(|error| self.refused(error))?;
        Ok(ArrowMsg {
            store_id: Some(self.stores[store.0].0.clone().into()),
            chunk_id: Some(chunk.id().as_tuid().into()),
            compression: re_protos::common::v1alpha1::Compression::None as i32,
            uncompressed_size: self.payload.len() as u64,
            encoding: Encoding::ArrowIpc as i32,
            payload: std::mem::take(&mut self.payload).into(),
            is_static: Some(chunk.is_static()),
        })
    }

    /// The library's own conversion: what is compressed is small.
    fn compressed(&self, store: Store, chunk: &Chunk, batch: &RecordBatch) -> Result<ArrowMsg, RecordingError> {
        let id = self.stores[store.0].0.clone();
        let message = re_log_types::ArrowMsg { chunk_id: chunk.id().as_tuid(), batch: batch.clone(), on_release: None };
        message.to_transport((id, self.compression)).map_err(|error| self.refused(error))
    }

    /// Ends the stream with its footer and gives the writer back, unflushed.
    ///
    /// # Errors
    /// If the footer cannot be built or written.
    pub(super) fn end(mut self) -> Result<W, RecordingError> {
        let mut manifests = Vec::with_capacity(self.stores.len());
        for (store, manifest) in std::mem::take(&mut self.stores) {
            let mut manifest = manifest.build(store).map_err(|error| self.refused(error))?;
            // The builder keeps the fields in a hash map: without an order of our own the bytes would vary.
            let mut fields = manifest.sorbet_schema.fields().to_vec();
            fields.sort();
            manifest.sorbet_schema = Schema::new(fields);
            manifests.push(manifest.to_transport(()).map_err(|error| self.refused(error))?);
        }
        let mut payload = Vec::new();
        RrdFooter { manifests }.to_rrd_bytes(&mut payload).map_err(|error| self.refused(error))?;
        MessageHeader { kind: MessageKind::End, len: payload.len() as u64 }
            .to_rrd_bytes(&mut self.buffer)
            .map_err(|error| self.refused(error))?;
        let start = self.position + self.buffer.len() as u64;
        self.buffer.extend_from_slice(&payload);
        StreamFooter::from_rrd_footer_bytes(start, &payload)
            .to_rrd_bytes(&mut self.buffer)
            .map_err(|error| self.refused(error))?;
        self.send()?;
        Ok(self.writer)
    }

    /// A library's refusal, with the file's name.
    pub(super) fn refused(&self, reason: impl std::fmt::Display) -> RecordingError {
        RecordingError::Encode { path: self.path.clone(), reason: reason.to_string() }
    }

    fn message(&mut self, message: &LogMsg) -> Result<(), RecordingError> {
        message
            .to_transport(self.compression)
            .and_then(|transport| transport.to_rrd_bytes(&mut self.buffer))
            .map_err(|error| self.refused(error))?;
        self.send()
    }

    /// Hands the buffer to the writer and empties it.
    fn send(&mut self) -> Result<(), RecordingError> {
        self.writer.write_all(&self.buffer).map_err(|source| RecordingError::Io {
            attempt: "write",
            path: self.path.clone(),
            source,
        })?;
        self.position += self.buffer.len() as u64;
        self.buffer.clear();
        Ok(())
    }

    /// An id with `rows` ids after it, all unique in this stream.
    fn reserve(&mut self, rows: u64) -> Tuid {
        let id = tuid(self.next_id);
        self.next_id += rows + 1;
        id
    }
}

impl Stream<PartFile> {
    /// Flushes what was sent, from time to time.
    ///
    /// # Errors
    /// If that fails.
    pub(super) fn flush_if_due(&mut self) -> Result<(), RecordingError> {
        let flushed = self.writer.flush_if_due();
        flushed.map_err(|source| RecordingError::Io { attempt: "write", path: self.path.clone(), source })
    }
}

/// Ids hold a time and a counter; the time is a constant here.
fn tuid(number: u64) -> Tuid {
    Tuid::from_nanos_and_inc(1, number)
}

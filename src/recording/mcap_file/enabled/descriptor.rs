//! `google.protobuf.FileDescriptorSet`, as far as it is used: a schema's own description, embedded in the file.

use prost::Message;

#[derive(Clone, PartialEq, Message)]
pub(super) struct FileDescriptorSet {
    #[prost(message, repeated, tag = "1")]
    pub file: Vec<FileDescriptor>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct FileDescriptor {
    #[prost(string, tag = "1")]
    pub name: String,
    #[prost(string, tag = "2")]
    pub package: String,
    #[prost(string, repeated, tag = "3")]
    pub dependency: Vec<String>,
    #[prost(message, repeated, tag = "4")]
    pub message_type: Vec<MessageDescriptor>,
    #[prost(string, tag = "12")]
    pub syntax: String,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct MessageDescriptor {
    #[prost(string, tag = "1")]
    pub name: String,
    #[prost(message, repeated, tag = "2")]
    pub field: Vec<FieldDescriptor>,
    #[prost(message, repeated, tag = "8")]
    pub oneof_decl: Vec<OneofDescriptor>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct FieldDescriptor {
    #[prost(string, tag = "1")]
    pub name: String,
    #[prost(int32, tag = "3")]
    pub number: i32,
    #[prost(int32, tag = "4")]
    pub label: i32,
    #[prost(int32, tag = "5")]
    pub kind: i32,
    #[prost(string, optional, tag = "6")]
    pub type_name: Option<String>,
    #[prost(int32, optional, tag = "9")]
    pub oneof_index: Option<i32>,
    #[prost(string, optional, tag = "10")]
    pub json_name: Option<String>,
    #[prost(bool, optional, tag = "17")]
    pub proto3_optional: Option<bool>,
}

#[derive(Clone, PartialEq, Message)]
pub(super) struct OneofDescriptor {
    #[prost(string, tag = "1")]
    pub name: String,
}

impl FieldDescriptor {
    const OPTIONAL: i32 = 1;
    const DOUBLE: i32 = 1;
    const INT64: i32 = 3;
    const INT32: i32 = 5;
    const MESSAGE: i32 = 11;

    pub fn double(name: &str, number: i32) -> Self {
        Self { name: name.into(), number, label: Self::OPTIONAL, kind: Self::DOUBLE, ..Self::default() }
    }

    pub fn message(name: &str, number: i32, type_name: &str) -> Self {
        Self { kind: Self::MESSAGE, type_name: Some(type_name.into()), ..Self::double(name, number) }
    }

    pub fn int64(name: &str, number: i32) -> Self {
        Self { kind: Self::INT64, ..Self::double(name, number) }
    }

    pub fn int32(name: &str, number: i32) -> Self {
        Self { kind: Self::INT32, ..Self::double(name, number) }
    }
}

impl MessageDescriptor {
    pub fn new(name: &str) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    pub fn with(mut self, field: FieldDescriptor) -> Self {
        self.field.push(field);
        self
    }

    /// Adds a number that can be absent, which is not the same as zero: proto3 says so by a "oneof" of its own.
    pub fn with_optional(mut self, field: FieldDescriptor) -> Self {
        let oneof_index = i32::try_from(self.oneof_decl.len()).ok();
        self.oneof_decl.push(OneofDescriptor { name: format!("_{}", field.name) });
        self.with(FieldDescriptor { oneof_index, proto3_optional: Some(true), ..field })
    }
}

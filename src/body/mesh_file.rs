use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use nalgebra::Vector3;

use super::error::positive;
use super::{BodyError, TriangleMesh};

/// Largest file read: over a million triangles of a binary STL. Reading takes up to some thirty times its memory.
const MOST_BYTES: u64 = 64 << 20;

/// Of one triangle, in the order of its file.
type Corners = [Vector3<f64>; 3];

const STL_HEADER_BYTES: usize = 84;
const STL_TRIANGLE_BYTES: usize = 50;

impl TriangleMesh {
    /// Reads an STL (text or binary) or OBJ file, known by its extension; `scale` is the length of its unit in m.
    ///
    /// Vertices are merged where their coordinates are equal. Of an OBJ, only vertices and faces are read, all objects
    /// as one mesh; faces of more than three corners are cut into a fan.
    ///
    /// # Errors
    /// If the scale is not positive, the extension another, or the file unreadable, damaged, empty, too large, or of
    /// several STL solids. Whether the mesh is closed is [`Self::check_closed`]'s matter.
    pub fn read(path: &Path, scale: f64) -> Result<Self, BodyError> {
        positive("scale of a mesh file", scale, "m")?;
        let refused = |reason: String| BodyError::MeshFile { path: path.display().to_string(), reason };
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let parse = match extension.to_ascii_lowercase().as_str() {
            "stl" => parse_stl,
            "obj" => parse_obj,
            _ => return Err(refused(format!("its extension is {extension:?}: it must be stl or obj"))),
        };
        let corners = read_bytes(path).and_then(parse).map_err(refused)?;
        if corners.is_empty() {
            return Err(refused("it has no triangles".into()));
        }
        let corners: Vec<Corners> = corners.into_iter().map(|triangle| triangle.map(|corner| corner * scale)).collect();
        if let Some(corner) = corners.iter().flatten().find(|corner| !corner.iter().all(|value| value.is_finite())) {
            return Err(refused(format!("a vertex lies at {:?} m: coordinates must be finite", corner.as_slice())));
        }
        Ok(merged(&corners))
    }
}

/// The whole file, unless it is too large; reads no more than the limit even of a file without end.
fn read_bytes(path: &Path) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| error.to_string())?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(format!("it is larger than {MOST_BYTES} bytes"));
    }
    Ok(bytes)
}

/// Text and binary are told apart by size, not by the word `solid`, with which binary files may begin too.
fn parse_stl(mut bytes: Vec<u8>) -> Result<Vec<Corners>, String> {
    let declared = bytes.get(80..STL_HEADER_BYTES).and_then(|count| <[u8; 4]>::try_from(count).ok());
    let declared = declared.map(u32::from_le_bytes);
    let expected = declared.map(|count| STL_HEADER_BYTES as u64 + STL_TRIANGLE_BYTES as u64 * u64::from(count));
    if expected == Some(bytes.len() as u64) {
        // A header that begins with `solid ` would send the reader down the text path.
        bytes[..80].fill(0);
    } else if bytes.starts_with(b"solid") {
        normalise_text_stl(&mut bytes)?;
    } else {
        let [declared, expected] = [declared.map(u64::from), expected].map(Option::unwrap_or_default);
        let found = bytes.len();
        return Err(format!("binary STL of {declared} triangles takes {expected} bytes, but there are {found}"));
    }
    let mut cursor = Cursor::new(bytes);
    let triangles = stl_io::create_stl_reader(&mut cursor).map_err(|error| error.to_string())?;
    let corners = |triangle: stl_io::Triangle| triangle.vertices.map(|corner| Vector3::from(corner.0.map(f64::from)));
    triangles.map(|triangle| triangle.map(corners).map_err(|error| error.to_string())).collect()
}

/// Makes the first line one that the reader knows (it wants a space after `solid`, and a name in UTF-8), and refuses
/// several solids, of which the reader would take the first.
fn normalise_text_stl(bytes: &mut Vec<u8>) -> Result<(), String> {
    let first_line = bytes.iter().position(|&byte| byte == b'\n').unwrap_or(bytes.len());
    bytes.splice(..first_line, *b"solid ");
    let ends = |line: &&[u8]| line.trim_ascii_start().starts_with(b"endsolid");
    match bytes.split(|&byte| byte == b'\n').filter(ends).count() {
        0 | 1 => Ok(()),
        several => Err(format!("it holds {several} solids: there must be one")),
    }
}

/// Only positions and the first index of each corner are handed on: colours, normals, textures, groups and materials
/// have no bearing here, split one skin into several models, and may name other files.
fn parse_obj(bytes: Vec<u8>) -> Result<Vec<Corners>, String> {
    let text = String::from_utf8(bytes).map_err(|error| error.to_string())?;
    let mut skin = String::with_capacity(text.len());
    for line in text.lines() {
        let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
        let kept: Vec<&str> = match words.next() {
            Some("v") => ["v"].into_iter().chain(words.take(3)).collect(),
            Some("f") => {
                ["f"].into_iter().chain(words.map(|corner| corner.split('/').next().unwrap_or(corner))).collect()
            }
            _ => continue,
        };
        if kept[0] == "f" && kept.len() < 4 {
            return Err(format!("face {line:?} has fewer than three corners"));
        }
        writeln!(skin, "{}", kept.join(" ")).map_err(|error| error.to_string())?;
    }
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &Path| Err(tobj::LoadError::GenericFailure);
    let (models, _) =
        tobj::load_obj_buf(&mut Cursor::new(skin), &options, no_materials).map_err(|error| error.to_string())?;
    let Some(mesh) = models.into_iter().next().map(|model| model.mesh) else { return Ok(Vec::new()) };
    let vertices: Vec<Vector3<f64>> = mesh.positions.chunks_exact(3).map(Vector3::from_column_slice).collect();
    // The reader has checked the indices.
    let corners = |&[a, b, c]: &[u32; 3]| [a, b, c].map(|index| vertices[index as usize]);
    Ok(mesh.indices.as_chunks::<3>().0.iter().map(corners).collect())
}

/// The mesh of these triangles, with one vertex for all corners that are in the same place.
fn merged(triangles: &[Corners]) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    let mut known = HashMap::new();
    let mut index_of = |corner: Vector3<f64>| {
        // Adding zero makes −0 the same place as 0.
        *known.entry(<[f64; 3]>::from(corner).map(|value| (value + 0.0).to_bits())).or_insert_with(|| {
            mesh.vertices.push(corner);
            // Far fewer than 2³², by the size of the file.
            u32::try_from(mesh.vertices.len() - 1).unwrap_or(u32::MAX)
        })
    };
    mesh.triangles = triangles.iter().map(|triangle| triangle.map(&mut index_of)).collect();
    mesh
}

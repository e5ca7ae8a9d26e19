//! Things to draw, on the GPU: field triangles and corners of shapes, in buffers that grow and are kept.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use scumble_solve::{FieldTriangle, Shape};

use crate::gpu::Gpu;

/// Three corners of a shape.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct ShapeItem([ShapeCorner; 3]);

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct ShapeCorner {
    position_du: [f32; 2],
    color: [u8; 4],
    depth: f32,
}

/// Where depths begin to have gaps: multiples of its inverse, up to 1, are exact.
const DEPTHS: f32 = (1 << 24) as f32;

/// What one of these buffers holds at most; a power of two well below any device's limit. A frame has time to write one
/// with WebGL 2, where it is copied three times.
const BUFFER_BYTES: usize = 1 << 22;

/// As much as so many buffers hold is rather written at once, so that colours follow the pen.
const BUFFERS_AT_ONCE: usize = 4;

/// How the vertex shader of the field reads its buffer: one triangle, as it is, an instance.
pub(crate) const FIELD_LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<FieldTriangle>() as u64,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![
        0 => Float32x2, 1 => Float32x2, 2 => Float32x2, 3 => Float32x4, 4 => Float32x4,
        5 => Float32x4, 6 => Float32x4, 7 => Float32x4, 8 => Float32x4,
    ],
};

/// How the vertex shader of shapes reads its buffer: one item three vertices.
pub(crate) const SHAPE_LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<ShapeCorner>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x2, 1 => Unorm8x4, 2 => Float32],
};

/// The triangles of shapes, those of each shape at one depth, the depths rising above `depth_below`.
///
/// Up to 2²³ shapes, above a depth of 0 or 0.5, have depths of their own.
pub(crate) fn shape_items(shapes: &[Shape], depth_below: f32) -> Vec<ShapeItem> {
    let mut items = Vec::with_capacity(shapes.iter().map(|shape| shape.triangles.len()).sum());
    for (rank, shape) in (1_u32..).zip(shapes) {
        let (color, depth) = (shape.color.0, depth_below + rank as f32 / DEPTHS);
        let corner = |position_du| ShapeCorner { position_du, color, depth };
        items.extend(shape.triangles.iter().map(|corners| ShapeItem(corners.map(corner))));
    }
    items
}

/// Items of one kind on the GPU, in as many buffers as they need.
#[derive(Debug, Default)]
pub(crate) struct Items(Vec<Part>);

#[derive(Debug)]
struct Part {
    buffer: wgpu::Buffer,
    count: u32,
}

impl Items {
    /// Follows a list of items, which outside some places are as in the last call.
    pub(crate) fn write<T: Pod>(&mut self, gpu: &Gpu, items: &[T], places: &Range<usize>) {
        let [start, end] = [places.start, places.end].map(|place| place.min(items.len()) * size_of::<T>());
        self.write_bytes(gpu, bytemuck::cast_slice(items), start..end, size_of::<T>());
    }

    /// The same with items of any kind, of so many bytes each.
    fn write_bytes(&mut self, gpu: &Gpu, bytes: &[u8], changed: Range<usize>, item_bytes: usize) {
        let chunk_bytes = BUFFER_BYTES / item_bytes * item_bytes;
        let chunks = bytes.chunks(chunk_bytes);
        self.0.truncate(chunks.len().max(1));
        self.0.iter_mut().for_each(|part| part.count = 0);
        for (i, chunk) in chunks.enumerate() {
            let within = |place: usize| place.saturating_sub(i * chunk_bytes).min(chunk.len());
            let mut changed = within(changed.start)..within(changed.end);
            if self.0.get(i).is_none_or(|part| part.buffer.size() < chunk.len() as u64) {
                self.0.truncate(i);
                self.0.push(Part::new(&gpu.device, chunk.len()));
                changed = 0..chunk.len();
            }
            if !changed.is_empty() {
                gpu.queue.write_buffer(&self.0[i].buffer, changed.start as u64, &chunk[changed]);
            }
            self.0[i].count = (chunk.len() / item_bytes) as u32;
        }
    }

    /// The buffers that hold something, and how many items each holds.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (&wgpu::Buffer, u32)> {
        self.0.iter().filter(|part| part.count > 0).map(|part| (&part.buffer, part.count))
    }
}

/// Items on their way to the GPU, a buffer at a time.
#[derive(Debug, Default)]
pub(crate) struct Coming {
    pub(crate) items: Items,
    buffers_there: usize,
}

impl Coming {
    /// Takes a buffer more of a list, which outside some places is as in the last call, or all of it where much of what was
    /// there is not as it was; tells whether that is all.
    pub(crate) fn go_on<T: Pod>(&mut self, gpu: &Gpu, list: &[T], places: &Range<usize>) -> bool {
        let there = self.buffers_there * per_buffer::<T>();
        let is_stale = is_long::<T>(&(places.start.min(there)..places.end.min(there)));
        self.buffers_there += 1;
        let end = if is_stale { list.len() } else { list.len().min(there + per_buffer::<T>()) };
        self.items.write(gpu, &list[..end], places);
        end == list.len()
    }
}

/// Whether so many items are more than what is rather written at once.
pub(crate) fn is_long<T>(places: &Range<usize>) -> bool {
    places.len() > BUFFERS_AT_ONCE * per_buffer::<T>()
}

fn per_buffer<T>() -> usize {
    BUFFER_BYTES / size_of::<T>()
}

impl Part {
    fn new(device: &wgpu::Device, bytes: usize) -> Self {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("items"),
            size: bytes.next_power_of_two() as u64,
            usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { buffer, count: 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scumble_core::Rgba8;

    #[test]
    fn shapes_rise_in_depth_by_steps_that_are_exact() {
        let shape = Shape { triangles: [[[0.0; 2]; 3]].into(), color: Rgba8([1, 2, 3, 4]) };
        for depth_below in [0.0, 0.5] {
            let items = shape_items(&vec![shape.clone(); 100_000], depth_below);
            for (rank, item) in (1..).zip(items) {
                let exact = f64::from(depth_below) + f64::from(rank) / 16_777_216.0;
                assert_eq!(item.0.map(|corner| f64::from(corner.depth)), [exact; 3]);
            }
        }
    }
}

//! How much memory the picture of a made drawing takes.

use scumble_core::Settings;
use scumble_solve::Picture;

use crate::made;
use crate::stages;

/// Cells in a row, for about 1,000, 10,000, 100,000 and 300,000 pieces.
const CELLS: [u32; 4] = [1, 8, 50, 96];

const BYTES_PER_MB: f64 = 1e6;

/// Opens made drawings, from the smallest on, each with scribbles, and prints how much memory the process has had at most.
///
/// # Errors
/// When a made drawing has no picture.
pub(crate) fn run() -> anyhow::Result<()> {
    println!("{:>9} {:>9} {:>9} {:>20}", "pieces", "triangles", "unknowns", "memory at most, MB");
    for cells in CELLS {
        let mut picture = Picture::new(&made::drawing(cells))?;
        stages::spread(&mut picture, &made::scribbles(), &[], &Settings::default())?;
        let pieces = picture.map().pieces().len();
        let solver = picture.mesh();
        let most_mb =
            most_bytes().map_or("unknown".into(), |bytes| format!("{:.0}", bytes as f64 / BYTES_PER_MB));
        println!("{pieces:>9} {:>9} {:>9} {most_mb:>20}", solver.triangle_count(), solver.unknown_count());
    }
    Ok(())
}

/// What this process has had at most, where the system tells. The memory of a wasm module never shrinks.
#[cfg(target_arch = "wasm32")]
fn most_bytes() -> Option<u64> {
    const PAGE_BYTES: u64 = 1 << 16;
    Some(core::arch::wasm32::memory_size(0) as u64 * PAGE_BYTES)
}

#[cfg(not(target_arch = "wasm32"))]
fn most_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    most.trim().strip_suffix(" kB")?.parse::<u64>().ok().map(|kilobytes| 1024 * kilobytes)
}

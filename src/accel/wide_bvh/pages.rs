//! Memory in large pages.
#![cfg_attr(
    all(feature = "mmap", target_os = "linux"),
    expect(
        unsafe_code,
        reason = "an advice to the system about memory goes by address"
    )
)]

/// Pages of 2 MB, where the system has them.
const LARGE: usize = 2 << 20;

/// A list with room for n items, in large pages if it is long.
///
/// A processor keeps the addresses of a few thousand pages at hand; in pages of 4 KB that is a few megabytes, less than a tree
/// of a hundred thousand triangles. Rays that go anywhere then look up an address for nearly every node.
pub(super) fn list<T>(n: usize) -> Vec<T> {
    let list = Vec::with_capacity(n);
    let bytes = n * size_of::<T>();
    if bytes >= LARGE {
        advise(list.as_ptr() as usize, bytes);
    }
    list
}

/// A copy of a list, in large pages if it is long.
pub(super) fn copy<T: Clone>(of: &[T]) -> Vec<T> {
    let mut copy = list(of.len());
    copy.extend_from_slice(of);
    copy
}

#[cfg(all(feature = "mmap", target_os = "linux"))]
fn advise(start: usize, bytes: usize) {
    const PAGE: usize = 4096;
    let from = start.next_multiple_of(PAGE);
    let to = (start + bytes) / PAGE * PAGE;
    if from < to {
        // SAFETY: `list` alone calls this, with the address and the size of a list that it has just made. The pages are whole and
        // within the list, for `from` is rounded up and `to` down; this advice changes neither their contents nor their rights.
        // If the system does not follow it, nothing is lost.
        let _ = unsafe {
            rustix::mm::madvise(
                from as *mut std::ffi::c_void,
                to - from,
                rustix::mm::Advice::LinuxHugepage,
            )
        };
    }
}

#[cfg(not(all(feature = "mmap", target_os = "linux")))]
fn advise(_start: usize, _bytes: usize) {}

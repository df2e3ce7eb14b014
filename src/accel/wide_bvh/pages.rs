//! Memory in large pages.
#![cfg_attr(
    all(feature = "mmap", target_os = "linux"),
    expect(
        unsafe_code,
        reason = "an advice to the system about memory goes by address"
    )
)]

/// A list with room for n items, in large pages if it is long.
///
/// A processor keeps the addresses of a few thousand pages at hand; in pages of 4 KB that is a few megabytes, less than a tree
/// of a hundred thousand triangles. Rays that go anywhere then look up an address for nearly every node.
pub(super) fn list<T>(n: usize) -> Vec<T> {
    let list = Vec::with_capacity(n);
    advise(list.as_ptr() as usize, n * size_of::<T>());
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
    use rustix::mm::{Advice, madvise};

    /// The size of a large page, where the system has them: 2 MB.
    const LARGE: usize = 2 << 20;
    let (from, to) = (
        start.next_multiple_of(LARGE),
        (start + bytes) / LARGE * LARGE,
    );
    if from < to {
        let at = from as *mut std::ffi::c_void;
        // Where an earlier list was, small pages are left; they are given back first, for they would stay.
        for advice in [Advice::LinuxDontNeed, Advice::LinuxHugepage] {
            // SAFETY: `list` alone calls this, with the address and the size of a list that it has just made, in which nothing is
            // yet: so its contents may be lost. The pages are whole and within the list, for `from` is rounded up and `to` down, to
            // multiples of 2 MB and so of any page; their rights do not change. If the system does not follow, nothing is lost.
            let _ = unsafe { madvise(at, to - from, advice) };
        }
    }
}

#[cfg(not(all(feature = "mmap", target_os = "linux")))]
fn advise(_start: usize, _bytes: usize) {}

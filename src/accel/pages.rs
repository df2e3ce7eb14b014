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
pub(crate) fn list<T>(n: usize) -> Vec<T> {
    let list = Vec::with_capacity(n);
    advise(list.as_ptr() as usize, n * size_of::<T>());
    list
}

/// These items as a list in large pages, if it is long; it has no room for more.
pub(crate) fn packed<T, I: IntoIterator<Item = T, IntoIter: ExactSizeIterator>>(
    items: I,
) -> Vec<T> {
    let items = items.into_iter();
    let mut packed = list(items.len());
    packed.extend(items);
    packed
}

#[cfg(all(feature = "mmap", target_os = "linux"))]
fn advise(start: usize, bytes: usize) {
    use libc::{MADV_DONTNEED, MADV_HUGEPAGE, madvise};
    use std::ops::Range;

    /// The size of a large page, where the system has them: 2 MB.
    const LARGE: usize = 2 << 20;
    let end = start + bytes;
    let inside = start.next_multiple_of(LARGE)..end / LARGE * LARGE;
    // A list of some megabytes is seldom at the begin of a page: its first and its last one are shared with what is beside it.
    let around = start / LARGE * LARGE..end.next_multiple_of(LARGE);
    let advise = |range: Range<usize>, advice| {
        if bytes >= LARGE && !range.is_empty() {
            let at = range.start as *mut std::ffi::c_void;
            // SAFETY: `list` alone calls this, with the address and the size of a list that it has just made, in which nothing is
            // yet. `MADV_DONTNEED` loses what is in its pages: they are those inside of the list. `MADV_HUGEPAGE` changes neither
            // what is in pages nor who may do what with them, so it may also be said of those around. Both ends are multiples
            // of 2 MB and so of any page. If the system does not follow, nothing is lost.
            let _ = unsafe { madvise(at, range.len(), advice) };
        }
    };
    // Where an earlier list was, small pages are left; they are given back first, for they would stay.
    advise(inside, MADV_DONTNEED);
    advise(around, MADV_HUGEPAGE);
}

#[cfg(not(all(feature = "mmap", target_os = "linux")))]
fn advise(_start: usize, _bytes: usize) {}

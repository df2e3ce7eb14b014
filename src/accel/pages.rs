//! Memory in large pages.
#![cfg_attr(
    all(feature = "mmap", target_os = "linux"),
    expect(
        unsafe_code,
        reason = "an advice to the system about memory goes by address"
    )
)]

/// An empty list with room for n items, in large pages (2 MB) if it is long.
///
/// A processor caches the addresses of a few thousand pages (TLB). With pages of 4 KB these are a few megabytes, less than the
/// tree of a hundred thousand triangles, and random rays must look up an address for nearly every node.
pub(crate) fn list<T>(n: usize) -> Vec<T> {
    let list = Vec::with_capacity(n);
    advise(list.as_ptr() as usize, n * size_of::<T>());
    list
}

/// The items as a list without room for more, in large pages if the list is long.
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
    // A list seldom begins at the beginning of a large page: its first and its last page are shared with neighbouring data.
    let around = start / LARGE * LARGE..end.next_multiple_of(LARGE);
    let advise = |range: Range<usize>, advice| {
        if bytes >= LARGE && !range.is_empty() {
            let at = range.start as *mut std::ffi::c_void;
            // SAFETY: only `list` calls this, with the address and the size of a list that it has just made and that is still
            // empty. `MADV_DONTNEED` discards the contents of the pages `inside`, all of which belong to the list.
            // `MADV_HUGEPAGE` changes neither the contents of pages nor the rights to them, so it is allowed for the pages
            // `around` too. Both ends are multiples of 2 MB, and so of any page. If the system refuses, nothing is lost.
            let _ = unsafe { madvise(at, range.len(), advice) };
        }
    };
    // An earlier list at this place may have left small pages, which would stay small: they are given back first.
    advise(inside, MADV_DONTNEED);
    advise(around, MADV_HUGEPAGE);
}

#[cfg(not(all(feature = "mmap", target_os = "linux")))]
fn advise(_start: usize, _bytes: usize) {}

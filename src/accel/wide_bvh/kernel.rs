//! Which instructions a search uses: chosen when the program runs.

#[cfg(target_arch = "x86_64")]
use super::avx2::Avx2;
#[cfg(target_arch = "x86_64")]
use super::avx512::Avx512;
use super::fours::Fours;
use super::lanes::Work;
use super::portable::Portable;

/// The instructions by which a [`WideBvh`](super::WideBvh) is searched. The answers are the same, bit for bit.
#[derive(Clone, Copy, Debug)]
pub struct Kernel(Choice);

#[derive(Clone, Copy, Debug)]
enum Choice {
    Portable,
    Fours(&'static str),
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
}

impl Kernel {
    /// Plain arithmetic, which every processor has.
    pub const PORTABLE: Self = Self(Choice::Portable);

    /// All that this processor has, the fastest first; the last one is [`Kernel::PORTABLE`].
    pub fn all() -> Vec<Self> {
        #[cfg(target_arch = "x86_64")]
        let special = [
            Avx512::detect().map(Choice::Avx512),
            Avx2::detect().map(Choice::Avx2),
        ];
        #[cfg(not(target_arch = "x86_64"))]
        let special = [None];
        let fours = Fours::NAME.map(Choice::Fours);
        let fast = special.into_iter().chain([fours]).flatten().map(Self);
        fast.chain([Self::PORTABLE]).collect()
    }

    /// What these instructions are called.
    pub fn name(self) -> &'static str {
        match self.0 {
            Choice::Portable => "portable",
            Choice::Fours(name) => name,
            #[cfg(target_arch = "x86_64")]
            Choice::Avx2(_) => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Choice::Avx512(_) => "AVX-512",
        }
    }

    /// Does the work.
    #[inline(always)]
    pub(super) fn run<W: Work>(self, work: W) -> W::Answer {
        match self.0 {
            Choice::Portable => Portable.run(work),
            Choice::Fours(_) => Fours.run(work),
            #[cfg(target_arch = "x86_64")]
            Choice::Avx2(avx2) => avx2.run(work),
            #[cfg(target_arch = "x86_64")]
            Choice::Avx512(avx512) => avx512.run(work),
        }
    }
}

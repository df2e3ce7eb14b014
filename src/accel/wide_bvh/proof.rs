//! Proofs that a processor has the instructions that a kernel is compiled for.

/// Makes a type that proves that this processor has some instructions: only its `detect` makes a value. With the proof, the
/// functions `boxes` and `triangles` of the module, which are compiled for these instructions only, are
/// [`Lanes`](super::lanes::Lanes).
macro_rules! proof {
    ($(#[$doc:meta])* $name:ident: $($feature:tt),+) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(super) struct $name(());

        impl $name {
            /// The proof, if it can be given.
            pub(super) fn detect() -> Option<Self> {
                ($(is_x86_feature_detected!($feature))&&+).then_some(Self(()))
            }

            /// Does the work, compiled for this processor.
            #[inline(always)]
            pub(super) fn run<W: Work>(self, work: W) -> W::Answer {
                #[target_feature($(enable = $feature),+)]
                fn compiled<W: Work>(lanes: $name, work: W) -> W::Answer {
                    work.with(lanes)
                }
                // SAFETY: this processor has these instructions. `self` is the proof: only `detect` makes one, for the field
                // is private to the kernel's module.
                unsafe { compiled(self, work) }
            }
        }

        impl Lanes for $name {
            #[inline(always)]
            fn boxes(self, node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]) {
                // SAFETY: this processor has these instructions; `self` is the proof, as above.
                unsafe { boxes(node, ray, max) }
            }

            #[inline(always)]
            fn triangles(self, leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck> {
                // SAFETY: this processor has these instructions; `self` is the proof, as above.
                unsafe { triangles(leaf, ray, max) }
            }

            #[inline(always)]
            fn fetch_next(self, tree: &Tree, link: Link) {
                prefetch::<_MM_HINT_T0>(tree, link);
            }

            #[inline(always)]
            fn fetch_met(self, tree: &Tree, link: Link) {
                prefetch::<_MM_HINT_T1>(tree, link);
            }
        }
    };
}

pub(super) use proof;

//! Choices as rows: a word says which kind it is, and the words of that kind follow.

/// Makes a row of an enum whose variants hold one row each.
macro_rules! choice_of {
    ($name:ty { $($word:literal: $variant:ident($kind:ty)),+ $(,)? }) => {
        impl crate::row::Row for $name {
            fn names(_name: &str) -> Vec<String> {
                let kinds = [$([
                    vec![$word.to_owned()],
                    <$kind as crate::row::Row>::names($word),
                ].concat().join(" ")),+];
                vec![format!("({})", kinds.join(" | "))]
            }

            fn write(&self) -> String {
                match self {
                    $(Self::$variant(value) => format!("{} {}", $word, crate::row::Row::write(value))),+
                }
            }

            fn read(
                words: &mut crate::row::Words<'_>,
                name: &str,
            ) -> Result<Self, crate::row::RowError> {
                $(if words.take($word) {
                    return <$kind as crate::row::Row>::read(words, name).map(Self::$variant);
                })+
                words.next(name, concat!("one of the words" $(, " ", $word)+), |_| None)
            }
        }
    };
}

pub(crate) use choice_of;

//! Keys of a terminal, each as it is pressed. The terminal is changed only while a key is waited for.

use std::time::Duration;

/// What came while a key was waited for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pressed {
    /// This key.
    Key(char),
    /// No key in this time, or there is no terminal.
    Nothing,
    /// The terminal is gone.
    Closed,
}

#[cfg(unix)]
pub(crate) use terminal::as_before;
pub use terminal::{are_there, restore, wait};

#[cfg(unix)]
mod terminal {
    use super::{Duration, Pressed};
    use crate::mutex::lock;
    use crate::suspend::suspend;
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    use rustix::io::{Errno, read};
    use rustix::process::getpgrp;
    use rustix::termios::{
        LocalModes, OptionalActions, SpecialCodeIndex, Termios, isatty, tcgetattr, tcgetpgrp,
        tcsetattr,
    };
    use std::io::stdin;
    use std::sync::Mutex;
    use std::thread::sleep;

    /// How the terminal was, as long as it is changed.
    static BEFORE: Mutex<Option<Termios>> = Mutex::new(None);

    /// Ctrl-Z, and the code of a key that does nothing of its own.
    const SUSPEND: char = '\u{1a}';
    const DISABLED: u8 = if cfg!(target_os = "linux") { 0 } else { 255 };

    /// Whether somebody can press keys: not where the command runs in the background of a terminal, which then belongs to others.
    pub fn are_there() -> bool {
        isatty(stdin()) && tcgetpgrp(stdin()).is_ok_and(|group| group == getpgrp())
    }

    /// Waits for a key, at most this time. Ctrl-Z suspends the command, with the terminal as it was before.
    pub fn wait(time: Duration) -> Pressed {
        let Some(changed) = are_there().then(Changed::new).flatten() else {
            sleep(time);
            return Pressed::Nothing;
        };
        let pressed = press(time);
        drop(changed);
        if pressed == Pressed::Key(SUSPEND) {
            suspend();
            return Pressed::Nothing;
        }
        pressed
    }

    fn press(time: Duration) -> Pressed {
        let input = stdin();
        let mut waited_for = [PollFd::new(&input, PollFlags::IN)];
        let time = Timespec::try_from(time).ok();
        let mut byte = [0];
        match poll(&mut waited_for, time.as_ref()) {
            Ok(1..) => match read(&input, &mut byte) {
                Ok(1..) => Pressed::Key(byte[0].into()),
                Err(Errno::INTR | Errno::AGAIN) => Pressed::Nothing,
                Ok(0) | Err(_) => Pressed::Closed,
            },
            _ => Pressed::Nothing,
        }
    }

    /// The terminal gives each key at once and does not show it, until this is dropped: at a panic too.
    struct Changed;

    impl Changed {
        fn new() -> Option<Self> {
            let before = tcgetattr(stdin()).ok()?;
            let mut kept = lock(&BEFORE);
            let mut changed = before.clone();
            changed.local_modes -= LocalModes::ICANON | LocalModes::ECHO;
            changed.special_codes[SpecialCodeIndex::VSUSP] = DISABLED;
            *kept = Some(before);
            tcsetattr(stdin(), OptionalActions::Now, &changed).ok()?;
            Some(Self)
        }
    }

    impl Drop for Changed {
        fn drop(&mut self) {
            as_before(|| {});
        }
    }

    /// Makes the terminal as it was before, and calls this before anybody can change it again.
    pub(crate) fn as_before(then: impl FnOnce()) {
        let mut kept = lock(&BEFORE);
        if let Some(before) = kept.take() {
            // A terminal that is gone needs nothing.
            let _ = tcsetattr(stdin(), OptionalActions::Now, &before);
        }
        then();
    }

    /// Makes the terminal as it was, for good: for a command that ends at once.
    pub fn restore() {
        as_before(|| {});
        // The lock is kept, so that no other thread can change the terminal again.
        std::mem::forget(lock(&BEFORE));
    }
}

#[cfg(not(unix))]
mod terminal {
    use super::{Duration, Pressed};
    use std::thread::sleep;

    /// No keys on this system.
    pub fn are_there() -> bool {
        false
    }

    /// Waits for this time.
    pub fn wait(time: Duration) -> Pressed {
        sleep(time);
        Pressed::Nothing
    }

    /// Nothing was changed.
    pub fn restore() {}
}

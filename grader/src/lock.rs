//! A folder for one command at a time: what is read there, changed and written again is not changed by another in between.

use raybook::store::StoreError;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How long a command waits for another one, which needs milliseconds.
const PATIENCE: Duration = Duration::from_secs(20);

/// A folder that is locked until this is dropped, or the command ends in whatever way.
#[must_use]
#[derive(Debug)]
pub struct Lock {
    _held: Option<File>,
}

impl Lock {
    /// Waits until no other command has locked the folder, which is made if need be.
    ///
    /// # Errors
    /// If it cannot be made or opened, or another command keeps it for 20 seconds.
    pub fn on(folder: &Path) -> Result<Self, StoreError> {
        take(folder).map_err(StoreError::of(folder, "lock this folder"))
    }
}

fn take(folder: &Path) -> io::Result<Lock> {
    fs::create_dir_all(folder)?;
    let deadline = Instant::now() + PATIENCE;
    loop {
        if let Some(lock) = try_to_take(folder)? {
            return Ok(lock);
        }
        if Instant::now() > deadline {
            let text =
                "another raybook command has kept it for 20 seconds; end that one, and try again";
            return Err(io::Error::new(ErrorKind::TimedOut, text));
        }
        sleep(Duration::from_millis(5));
    }
}

/// The lock; nothing if another command has it.
#[cfg(unix)]
fn try_to_take(folder: &Path) -> io::Result<Option<Lock>> {
    use rustix::fs::{FlockOperation, flock};
    use rustix::io::Errno;

    let file = File::open(folder)?;
    match flock(&file, FlockOperation::NonBlockingLockExclusive) {
        Ok(()) => Ok(Some(Lock { _held: Some(file) })),
        Err(Errno::WOULDBLOCK | Errno::INTR) => Ok(None),
        // Some network disks have no locks: a student there checks with one command at a time.
        Err(Errno::NOLCK | Errno::NOSYS | Errno::OPNOTSUPP) => Ok(Some(Lock { _held: None })),
        Err(error) => Err(error.into()),
    }
}

/// The lock; nothing if another command has it. A folder cannot be locked on Windows, but a file that is opened by one only can.
#[cfg(windows)]
fn try_to_take(folder: &Path) -> io::Result<Option<Lock>> {
    use std::os::windows::fs::OpenOptionsExt;

    /// `ERROR_SHARING_VIOLATION`.
    const SHARED: i32 = 32;
    let mut options = File::options();
    options
        .write(true)
        .create(true)
        .truncate(false)
        .share_mode(0);
    match options.open(folder.join("lock")) {
        Ok(file) => Ok(Some(Lock { _held: Some(file) })),
        Err(error) if error.raw_os_error() == Some(SHARED) => Ok(None),
        Err(error) => Err(error),
    }
}

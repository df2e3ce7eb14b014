//! Attacks on the sandbox, by programs that try what a hand-in might: what each reached, and what stopped it.

use super::Sandbox;
use crate::contain;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::thread;
use std::time::{Duration, Instant};

/// What became of an attack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It came to nothing.
    Stopped,
    /// It succeeded.
    Reached,
    /// It could not be tried here.
    NotTried,
}

/// An attack.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attack {
    /// What was tried.
    pub name: String,
    /// What became of it.
    pub fate: Fate,
    /// What stopped it, or why it could not be tried.
    pub how: String,
}

/// The attacks of many kinds that one program tries one after another.
const PROBES: [(&str, &str, &str); 2] = [
    ("python3", "probes.py", include_str!("probes/probes.py")),
    ("sh", "probes.sh", include_str!("probes/probes.sh")),
];

/// Attacks that end a program that has no limits: what is tried, and a program of Python that tells when it is beyond.
const BOMBS: [(&str, &str); 4] = [
    ("compute for ever", "while True: pass"),
    (
        "take all memory",
        "kept = []
while len(kept) < 64: kept.append(b'x' * (1 << 25))
print('beyond')",
    ),
    (
        "start threads without end",
        "import threading, time
threading.stack_size(1 << 15)
for i in range(5000): threading.Thread(target=time.sleep, args=(9,), daemon=True).start()
print('beyond')
__import__('os')._exit(0)",
    ),
    (
        "open files without end",
        "kept = []
while len(kept) < 2000: kept.append(open('/dev/null'))
print('beyond')",
    ),
];

/// What a bomb may use: little, so that it ends soon.
const LITTLE: super::Allowance = super::Allowance {
    processor_time: Duration::from_secs(1),
    memory: 1 << 28,
    threads: 64,
    files: 64,
};

/// Attacks end by themselves long before.
const LIMIT: Duration = Duration::from_secs(20);

/// A secret that nobody else has written down.
const SECRET: &str = "raybook-doctor-secret";

/// Tries all the attacks in the sandbox; without one, those that are harmless if they succeed.
///
/// # Errors
/// If the folder for them cannot be made, or a program cannot be started.
pub fn attacks(sandbox: Option<&Sandbox>) -> io::Result<Vec<Attack>> {
    let outside = Folder::new()?;
    let here = outside.0.join("hand-in");
    fs::create_dir(&here)?;
    let secret = outside.0.join("key");
    fs::write(&secret, SECRET)?;
    for decoy in [
        outside.0.join("decoy"),
        outside.0.join("removed"),
        here.join("decoy"),
    ] {
        fs::write(decoy, "a file of the grader's")?;
    }
    #[cfg(unix)]
    std::os::unix::fs::symlink(&secret, here.join("link"))?;
    let grader = std::env::current_exe()?;
    let mut attacks = Vec::new();
    for (interpreter, name, text) in PROBES {
        let file = here.join(name);
        fs::write(&file, text)?;
        let mut command = Command::new("/usr/bin/env");
        command.arg(interpreter);
        if interpreter == "python3" {
            command.args(["-I", "-S"]);
        }
        command
            .arg(&file)
            .args([&grader, &secret, &outside.0, &here]);
        let said = run(command, &here, sandbox)?;
        let found: Vec<_> = said.lines().filter_map(Attack::read).collect();
        if found.is_empty() {
            attacks.push(Attack {
                name: format!("the attacks of {name}"),
                fate: Fate::NotTried,
                how: format!("`{interpreter}` does not run here"),
            });
        }
        for attack in found {
            // Of several lines for one attack the last counts.
            attacks.retain(|other| other.name != attack.name);
            attacks.push(attack);
        }
    }
    if let Some(sandbox) = sandbox {
        attacks.extend(bombs(sandbox, &here)?);
    }
    Ok(attacks)
}

/// What the sandbox adds to the time of a start, on average.
///
/// # Errors
/// If `true` cannot be started.
pub fn cost_of_a_start(sandbox: &Sandbox) -> io::Result<Duration> {
    const STARTS: u32 = 20;
    let timed = |sandbox: Option<&Sandbox>| {
        let start = Instant::now();
        for _ in 0..STARTS {
            let mut command = Command::new("/bin/true");
            if let Some(sandbox) = sandbox {
                sandbox.enclose(&mut command)?;
            }
            contain::start(&mut command, sandbox)?.end(true, LIMIT);
        }
        Ok::<_, io::Error>(start.elapsed() / STARTS)
    };
    Ok(timed(Some(sandbox))?.saturating_sub(timed(None)?))
}

/// Tries what ends a program that has no limits.
fn bombs(sandbox: &Sandbox, here: &Path) -> io::Result<Vec<Attack>> {
    let mut sandbox = sandbox.clone();
    sandbox.allowance = LITTLE;
    let mut attacks = Vec::new();
    for (name, text) in BOMBS {
        let file = here.join("bomb.py");
        fs::write(&file, format!("print('starts', flush=True)\n{text}\n"))?;
        let mut command = Command::new("/usr/bin/env");
        command.args(["python3", "-I", "-S"]).arg(&file);
        let said = run(command, here, Some(&sandbox))?;
        let (fate, how) = if !said.starts_with("starts") {
            (Fate::NotTried, "`python3` does not run here".to_owned())
        } else if said.contains("beyond") {
            (Fate::Reached, String::new())
        } else {
            let last = said.lines().last().unwrap_or_default();
            (Fate::Stopped, last.to_owned())
        };
        attacks.push(Attack {
            name: name.to_owned(),
            fate,
            how,
        });
    }
    Ok(attacks)
}

/// Runs a command in a folder, in the sandbox if there is one: what it printed, errors too, and the signal that ended it.
fn run(mut command: Command, folder: &Path, sandbox: Option<&Sandbox>) -> io::Result<String> {
    let (mut output, input) = io::pipe()?;
    command
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(input.try_clone()?)
        .stderr(input);
    if let Some(sandbox) = sandbox {
        sandbox.enclose(&mut command)?;
    }
    let held = contain::start(&mut command, sandbox)?;
    drop(command); // it holds the pipe's other end
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let mut said = Vec::new();
        // What was read before an error is what there is.
        let _ = output.read_to_end(&mut said);
        sender.send(String::from_utf8_lossy(&said).into_owned())
    });
    let status = held.end(true, LIMIT);
    let said = receiver.recv_timeout(LIMIT).unwrap_or_default();
    // A program that a signal ended has no last words.
    let signal = status.filter(|status| status.code().is_none());
    Ok(said + &signal.map_or_else(String::new, contain::signal_name))
}

impl Attack {
    /// From a line of a program's: name, fate and reason between tabs.
    fn read(line: &str) -> Option<Self> {
        let mut parts = line.split('\t');
        let (name, fate) = (parts.next()?, parts.next()?);
        Some(Self {
            name: name.to_owned(),
            fate: match fate {
                "stopped" => Fate::Stopped,
                "reached" => Fate::Reached,
                "not tried" => Fate::NotTried,
                _ => return None,
            },
            how: parts.next().unwrap_or_default().to_owned(),
        })
    }
}

/// A folder of its own, for as long as the attacks go on.
struct Folder(PathBuf);

impl Folder {
    fn new() -> io::Result<Self> {
        let folder = std::env::temp_dir().join(format!("raybook-doctor-{}", std::process::id()));
        fs::create_dir(&folder)?;
        Ok(Self(folder.canonicalize()?))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // What cannot be removed is a folder of decoys.
        let _ = fs::remove_dir_all(&self.0);
    }
}

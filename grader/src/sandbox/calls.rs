//! The system calls of a stranger's program, as filters for seccomp.

use super::call_lists::{FCNTL, IOCTL, LISTED, OLD, PRCTL, PRETENDED, REFUSED, REFUSED_RUNNING};
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter,
    SeccompRule, TargetArch,
};
use std::collections::BTreeMap;

/// Filters for one program, in the order in which they are installed: of two that refuse a call, the later one's reason is told.
#[derive(Clone)]
pub struct Filters {
    /// What is not on the list does not exist.
    pub listed: BpfProgram,
    /// What is refused by name.
    pub refused: BpfProgram,
    /// What succeeds without being done, where a compiler is to run.
    pub pretended: Option<BpfProgram>,
}

impl std::fmt::Debug for Filters {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Filters")
    }
}

/// Stands for the program's own process number, which is known only when it runs. No call has an argument of this value.
pub const ITSELF: u32 = 0x7a5b_91c3;

/// Landlock does not know of files cut to length before this version.
const TRUNCATE_KNOWN: i32 = 3;

/// Nor of signals before this one.
const SIGNALS_KNOWN: i32 = 6;

/// Which signal tells of a file, and to whom, as Linux numbers it.
const F_SETSIG: i32 = 10;
const F_SETOWN_EX: i32 = 15;

/// Its flags are in memory, where no filter sees them.
const NO_FLAGS: &[i64] = &[libc::SYS_clone3];

type Rules = BTreeMap<i64, Vec<SeccompRule>>;

/// What a process is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Compile: it starts other processes, and writes.
    Build,
    /// Answer.
    Run,
}

/// The filters for a phase, on a kernel with this version of landlock.
///
/// # Errors
/// If this kind of processor has no filters.
pub fn filters(phase: Phase, landlock: i32) -> Result<Filters, seccompiler::Error> {
    const UNKNOWN: SeccompAction = SeccompAction::Errno(libc::ENOSYS as u32);
    const REFUSED: SeccompAction = SeccompAction::Errno(libc::EPERM as u32);
    let arch = TargetArch::try_from(std::env::consts::ARCH)?;
    let compile = |rules, matched, others| -> Result<BpfProgram, seccompiler::Error> {
        Ok(SeccompFilter::new(rules, others, matched, arch)?.try_into()?)
    };
    Ok(Filters {
        listed: match phase {
            Phase::Build => compile(all(&[NO_FLAGS]), UNKNOWN, SeccompAction::Allow)?,
            Phase::Run => compile(all(&[LISTED, OLD]), SeccompAction::Allow, UNKNOWN)?,
        },
        refused: compile(refusals(phase, landlock)?, REFUSED, SeccompAction::Allow)?,
        pretended: match phase {
            Phase::Build => Some(compile(
                all(&[PRETENDED]),
                SeccompAction::Errno(0),
                SeccompAction::Allow,
            )?),
            Phase::Run => None,
        },
    })
}

/// Calls, whatever their arguments.
fn all(lists: &[&[i64]]) -> Rules {
    lists
        .iter()
        .copied()
        .flatten()
        .map(|&call| (call, Vec::new()))
        .collect()
}

/// Writes the process's own number where it is compared with. Allocates nothing.
pub fn name_itself(filter: &mut BpfProgram, itself: u32) {
    for instruction in filter.iter_mut() {
        if instruction.k == ITSELF {
            instruction.k = itself;
        }
    }
}

/// What is refused by name, and on which conditions.
fn refusals(phase: Phase, landlock: i32) -> Result<Rules, seccompiler::Error> {
    let mut rules = match phase {
        Phase::Build => all(&[REFUSED]),
        Phase::Run => all(&[REFUSED, REFUSED_RUNNING]),
    };
    let mut refuse = |call, conditions: &[&[SeccompCondition]]| {
        let any = conditions.iter().map(|all| SeccompRule::new(all.to_vec()));
        let any: Result<Vec<_>, _> = any.collect();
        any.map(|any| drop(rules.insert(call, any)))
    };
    for (call, argument, allowed) in [
        (libc::SYS_ioctl, 1, IOCTL),
        (libc::SYS_prctl, 0, PRCTL),
        (libc::SYS_personality, 0, &[u32::MAX]),
    ] {
        refuse(call, &[&others(argument, allowed)?])?;
    }
    let cut = |argument| with(argument, libc::O_TRUNC as u32);
    match phase {
        Phase::Build => {
            if landlock < SIGNALS_KNOWN {
                refuse(libc::SYS_kill, &[])?;
            }
            // Rust's compiler hears from its processes through pairs of sockets. One for datagrams can write to others too.
            let kind = |kind: i32| {
                let bits = SeccompCmpOp::MaskedEq(0xf);
                condition(1, bits, kind as u32)
            };
            refuse(
                libc::SYS_socketpair,
                &[
                    &others(0, &[libc::AF_UNIX as u32])?,
                    &[kind(libc::SOCK_DGRAM)?],
                    &[kind(libc::SOCK_RAW)?],
                ],
            )?;
            let space = with(0, libc::CLONE_NEWUSER as u32)?;
            refuse(libc::SYS_clone, &[&[space]])?;
            let owners = [libc::F_SETOWN, F_SETSIG, F_SETOWN_EX];
            let owners: Result<Vec<_>, _> = owners
                .iter()
                .map(|&owner| condition(1, SeccompCmpOp::Eq, owner as u32))
                .collect();
            let owners = owners?;
            refuse(
                libc::SYS_fcntl,
                &owners.iter().map(std::slice::from_ref).collect::<Vec<_>>(),
            )?;
        }
        Phase::Run => {
            // Signals only to itself, and limits only its own.
            refuse(libc::SYS_kill, &[&others(0, &[ITSELF])?])?;
            refuse(libc::SYS_tgkill, &[&others(0, &[ITSELF])?])?;
            refuse(libc::SYS_prlimit64, &[&others(0, &[0, ITSELF])?])?;
            refuse(libc::SYS_sched_setaffinity, &[&others(0, &[0, ITSELF])?])?;
            refuse(
                libc::SYS_clone,
                &[&[without(0, libc::CLONE_THREAD as u32)?]],
            )?;
            // Memory that is shared and nobody's counts to no limit of a process.
            let shared = with(3, (libc::MAP_SHARED | libc::MAP_ANONYMOUS) as u32)?;
            refuse(libc::SYS_mmap, &[&[shared]])?;
            refuse(libc::SYS_fcntl, &[&others(1, FCNTL)?])?;
            if landlock < TRUNCATE_KNOWN {
                refuse(libc::SYS_openat, &[&[cut(2)?]])?;
                #[cfg(target_arch = "x86_64")]
                refuse(libc::SYS_open, &[&[cut(1)?]])?;
            }
        }
    }
    Ok(rules)
}

/// The argument is none of these.
fn others(argument: u8, values: &[u32]) -> Result<Vec<SeccompCondition>, seccompiler::Error> {
    let other = |&value| condition(argument, SeccompCmpOp::Ne, value);
    values.iter().map(other).collect()
}

/// All of these bits are set.
fn with(argument: u8, bits: u32) -> Result<SeccompCondition, seccompiler::Error> {
    condition(argument, SeccompCmpOp::MaskedEq(u64::from(bits)), bits)
}

/// None of these bits is set.
fn without(argument: u8, bits: u32) -> Result<SeccompCondition, seccompiler::Error> {
    condition(argument, SeccompCmpOp::MaskedEq(u64::from(bits)), 0)
}

fn condition(
    argument: u8,
    operator: SeccompCmpOp,
    value: u32,
) -> Result<SeccompCondition, seccompiler::Error> {
    let word = SeccompCmpArgLen::Dword; // the kernel reads no more of these arguments
    Ok(SeccompCondition::new(
        argument,
        word,
        operator,
        u64::from(value),
    )?)
}

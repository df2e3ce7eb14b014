//! The system calls of a stranger's program, as filters for seccomp.

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

/// What may be asked of an open file: neither who gets its signals nor its locks.
const FCNTL: &[u32] = &[
    libc::F_DUPFD as u32,
    libc::F_DUPFD_CLOEXEC as u32,
    libc::F_GETFD as u32,
    libc::F_SETFD as u32,
    libc::F_GETFL as u32,
    libc::F_SETFL as u32,
    libc::F_GETPIPE_SZ as u32,
];

/// What may be asked of a device: whether it is a terminal, how wide, and how much waits.
const IOCTL: &[u32] = &[
    libc::TCGETS as u32,
    libc::TIOCGWINSZ as u32,
    libc::FIONREAD as u32,
    libc::FIONBIO as u32,
    libc::FIOCLEX as u32,
    libc::FIONCLEX as u32,
    0x802c_542a, // TCGETS2, which newer C libraries ask
];

/// What a process may change of itself: names.
const PRCTL: &[u32] = &[
    libc::PR_SET_NAME as u32,
    libc::PR_GET_NAME as u32,
    libc::PR_SET_VMA as u32,
    libc::PR_GET_DUMPABLE as u32,
    libc::PR_CAPBSET_READ as u32,
    libc::PR_GET_NO_NEW_PRIVS as u32,
    libc::PR_GET_SECCOMP as u32,
];

/// What the runtimes of Rust, C, C++, Python, shells, Java, JavaScript and Go call.
const LISTED: &[i64] = &[
    // Files that are open.
    libc::SYS_read,
    libc::SYS_readv,
    libc::SYS_pread64,
    libc::SYS_preadv,
    libc::SYS_preadv2,
    libc::SYS_write,
    libc::SYS_writev,
    libc::SYS_pwrite64,
    libc::SYS_pwritev,
    libc::SYS_pwritev2,
    libc::SYS_lseek,
    libc::SYS_fstat,
    libc::SYS_fstatfs,
    libc::SYS_fcntl,
    libc::SYS_ioctl,
    libc::SYS_dup,
    libc::SYS_dup3,
    libc::SYS_close,
    libc::SYS_close_range,
    libc::SYS_getdents64,
    libc::SYS_fadvise64,
    libc::SYS_readahead,
    libc::SYS_sendfile,
    libc::SYS_splice,
    libc::SYS_copy_file_range,
    libc::SYS_fsync,
    libc::SYS_fdatasync,
    // Files by name.
    libc::SYS_openat,
    libc::SYS_newfstatat,
    libc::SYS_statx,
    libc::SYS_statfs,
    libc::SYS_faccessat,
    libc::SYS_faccessat2,
    libc::SYS_readlinkat,
    libc::SYS_getcwd,
    libc::SYS_chdir,
    libc::SYS_fchdir,
    libc::SYS_umask,
    // Waiting.
    libc::SYS_pipe2,
    libc::SYS_eventfd2,
    libc::SYS_epoll_create1,
    libc::SYS_epoll_ctl,
    libc::SYS_epoll_pwait,
    libc::SYS_epoll_pwait2,
    libc::SYS_ppoll,
    libc::SYS_pselect6,
    libc::SYS_signalfd4,
    libc::SYS_timerfd_create,
    libc::SYS_timerfd_settime,
    libc::SYS_timerfd_gettime,
    libc::SYS_timer_create,
    libc::SYS_timer_settime,
    libc::SYS_timer_gettime,
    libc::SYS_timer_getoverrun,
    libc::SYS_timer_delete,
    libc::SYS_setitimer,
    libc::SYS_getitimer,
    libc::SYS_nanosleep,
    libc::SYS_clock_nanosleep,
    libc::SYS_wait4,
    libc::SYS_waitid,
    libc::SYS_restart_syscall,
    // Memory.
    libc::SYS_mmap,
    libc::SYS_munmap,
    libc::SYS_mremap,
    libc::SYS_mprotect,
    libc::SYS_madvise,
    libc::SYS_mincore,
    libc::SYS_msync,
    libc::SYS_brk,
    libc::SYS_membarrier,
    libc::SYS_get_mempolicy,
    libc::SYS_pkey_alloc,
    libc::SYS_pkey_free,
    libc::SYS_pkey_mprotect,
    // Threads.
    libc::SYS_clone,
    libc::SYS_futex,
    libc::SYS_futex_waitv,
    libc::SYS_set_robust_list,
    libc::SYS_get_robust_list,
    libc::SYS_set_tid_address,
    libc::SYS_rseq,
    libc::SYS_gettid,
    libc::SYS_sched_yield,
    libc::SYS_sched_getaffinity,
    libc::SYS_sched_setaffinity,
    libc::SYS_sched_getparam,
    libc::SYS_sched_getscheduler,
    libc::SYS_sched_get_priority_max,
    libc::SYS_sched_get_priority_min,
    libc::SYS_getpriority,
    libc::SYS_getcpu,
    // Signals, to itself.
    libc::SYS_rt_sigaction,
    libc::SYS_rt_sigprocmask,
    libc::SYS_rt_sigreturn,
    libc::SYS_rt_sigpending,
    libc::SYS_rt_sigsuspend,
    libc::SYS_rt_sigtimedwait,
    libc::SYS_sigaltstack,
    libc::SYS_kill,
    libc::SYS_tgkill,
    // The second filter, which refuses this too, comes after the first.
    libc::SYS_seccomp,
    // What it is, and where.
    libc::SYS_execve,
    libc::SYS_exit,
    libc::SYS_exit_group,
    libc::SYS_prctl,
    libc::SYS_personality,
    libc::SYS_capget,
    libc::SYS_getpid,
    libc::SYS_getppid,
    libc::SYS_getpgid,
    libc::SYS_getsid,
    libc::SYS_getuid,
    libc::SYS_geteuid,
    libc::SYS_getgid,
    libc::SYS_getegid,
    libc::SYS_getresuid,
    libc::SYS_getresgid,
    libc::SYS_getgroups,
    libc::SYS_prlimit64,
    libc::SYS_getrusage,
    libc::SYS_times,
    libc::SYS_sysinfo,
    libc::SYS_uname,
    libc::SYS_getrandom,
    libc::SYS_gettimeofday,
    libc::SYS_clock_gettime,
    libc::SYS_clock_getres,
];

/// The same under the names that only older processors have.
#[cfg(target_arch = "x86_64")]
const OLD: &[i64] = &[
    libc::SYS_open,
    libc::SYS_stat,
    libc::SYS_lstat,
    libc::SYS_access,
    libc::SYS_readlink,
    libc::SYS_getdents,
    libc::SYS_dup2,
    libc::SYS_pipe,
    libc::SYS_poll,
    libc::SYS_select,
    libc::SYS_epoll_create,
    libc::SYS_epoll_wait,
    libc::SYS_eventfd,
    libc::SYS_signalfd,
    libc::SYS_pause,
    libc::SYS_alarm,
    libc::SYS_time,
    libc::SYS_getpgrp,
    libc::SYS_getrlimit,
    libc::SYS_setrlimit,
    libc::SYS_arch_prctl,
];
#[cfg(not(target_arch = "x86_64"))]
const OLD: &[i64] = &[];

/// What is refused by name, whatever its arguments: nothing here is needed by an honest program, and "operation not permitted"
/// tells its author more than "function not implemented". (`clone3` and `openat2` are on neither list: they must not exist.)
const REFUSED: &[i64] = &[
    // Other processes.
    libc::SYS_tkill,
    libc::SYS_rt_sigqueueinfo,
    libc::SYS_rt_tgsigqueueinfo,
    libc::SYS_pidfd_open,
    libc::SYS_pidfd_getfd,
    libc::SYS_pidfd_send_signal,
    libc::SYS_ptrace,
    libc::SYS_process_vm_readv,
    libc::SYS_process_vm_writev,
    libc::SYS_process_madvise,
    libc::SYS_process_mrelease,
    libc::SYS_kcmp,
    libc::SYS_setsid,
    libc::SYS_setpgid,
    libc::SYS_ioprio_set,
    libc::SYS_sched_setscheduler,
    libc::SYS_sched_setparam,
    libc::SYS_sched_setattr,
    libc::SYS_migrate_pages,
    libc::SYS_move_pages,
    // Sockets.
    libc::SYS_socket,
    libc::SYS_connect,
    libc::SYS_bind,
    libc::SYS_listen,
    libc::SYS_accept,
    libc::SYS_accept4,
    libc::SYS_sendmmsg,
    libc::SYS_recvmmsg,
    // Changes to files, which landlock does not all know of.
    libc::SYS_fchown,
    libc::SYS_fchownat,
    libc::SYS_setxattr,
    libc::SYS_lsetxattr,
    libc::SYS_fsetxattr,
    libc::SYS_removexattr,
    libc::SYS_lremovexattr,
    libc::SYS_fremovexattr,
    libc::SYS_mknodat,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_chown,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_lchown,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_mknod,
    libc::SYS_fanotify_init,
    // Files without a name, and by handle.
    libc::SYS_memfd_secret,
    libc::SYS_name_to_handle_at,
    libc::SYS_open_by_handle_at,
    // Memory and messages that outlive a process.
    libc::SYS_shmget,
    libc::SYS_shmat,
    libc::SYS_shmctl,
    libc::SYS_semget,
    libc::SYS_semop,
    libc::SYS_semctl,
    libc::SYS_msgget,
    libc::SYS_msgsnd,
    libc::SYS_msgrcv,
    libc::SYS_msgctl,
    libc::SYS_mq_open,
    libc::SYS_mq_unlink,
    libc::SYS_add_key,
    libc::SYS_request_key,
    libc::SYS_keyctl,
    // Doors into the kernel.
    libc::SYS_io_uring_setup,
    libc::SYS_io_uring_enter,
    libc::SYS_io_uring_register,
    libc::SYS_io_setup,
    libc::SYS_bpf,
    libc::SYS_perf_event_open,
    libc::SYS_userfaultfd,
    libc::SYS_seccomp,
    libc::SYS_mlock,
    libc::SYS_mlock2,
    libc::SYS_mlockall,
    // The system as a whole.
    libc::SYS_unshare,
    libc::SYS_setns,
    libc::SYS_chroot,
    libc::SYS_pivot_root,
    libc::SYS_mount,
    libc::SYS_umount2,
    libc::SYS_mount_setattr,
    libc::SYS_open_tree,
    libc::SYS_move_mount,
    libc::SYS_fsopen,
    libc::SYS_fsmount,
    libc::SYS_fspick,
    libc::SYS_fsconfig,
    libc::SYS_setuid,
    libc::SYS_setgid,
    libc::SYS_setreuid,
    libc::SYS_setregid,
    libc::SYS_setgroups,
    libc::SYS_setfsuid,
    libc::SYS_setfsgid,
    libc::SYS_capset,
    libc::SYS_reboot,
    libc::SYS_swapon,
    libc::SYS_swapoff,
    libc::SYS_sethostname,
    libc::SYS_setdomainname,
    libc::SYS_settimeofday,
    libc::SYS_clock_settime,
    libc::SYS_clock_adjtime,
    libc::SYS_adjtimex,
    libc::SYS_init_module,
    libc::SYS_finit_module,
    libc::SYS_delete_module,
    libc::SYS_kexec_load,
    libc::SYS_acct,
    libc::SYS_quotactl,
    libc::SYS_syslog,
    libc::SYS_vhangup,
];

/// `make` sets its own user and group once more before it starts a compiler, and starts none if it cannot.
const PRETENDED: &[i64] = &[libc::SYS_setresuid, libc::SYS_setresgid];

/// What is refused to a program that runs, and what compilers need.
const REFUSED_RUNNING: &[i64] = &[
    libc::SYS_setresuid,
    libc::SYS_setresgid,
    libc::SYS_socketpair,
    libc::SYS_sendto,
    libc::SYS_sendmsg,
    libc::SYS_recvfrom,
    libc::SYS_recvmsg,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_fork,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_vfork,
    libc::SYS_execveat,
    libc::SYS_setpriority,
    libc::SYS_truncate,
    libc::SYS_ftruncate,
    libc::SYS_fallocate,
    libc::SYS_fchmod,
    libc::SYS_fchmodat,
    libc::SYS_utimensat,
    libc::SYS_flock,
    libc::SYS_mkdirat,
    libc::SYS_unlinkat,
    libc::SYS_symlinkat,
    libc::SYS_linkat,
    libc::SYS_renameat2,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_chmod,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_utime,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_utimes,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_futimesat,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_creat,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_mkdir,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_rmdir,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_unlink,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_symlink,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_link,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_rename,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_renameat,
    libc::SYS_inotify_init1,
    libc::SYS_memfd_create,
    libc::SYS_sync,
    libc::SYS_syncfs,
];

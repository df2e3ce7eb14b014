# The attacks that a shell can try without another program, each harmless if it succeeds; their lines are those of `probes.py`.
# Arguments: the grader's program, a secret file, a folder that the grader's user can write.
secret=$2 outside=$3
tell() { printf '%s, by a shell\t%s\t\n' "$1" "$2"; }
tried() { if [ "$2" = 0 ]; then tell "$1" reached; else tell "$1" stopped; fi; }
command : 2> /dev/null < "$secret"
tried "read a secret file" $?
command : 2> /dev/null < "/proc/$PPID/cmdline"
tried "read the grader's command line" $?
command : 2> /dev/null > "$outside/made"
tried "make a file" $?
command : 2> /dev/null > /tmp/raybook-probe-by-a-shell
tried "make a file in /tmp" $?
kill -CONT "$PPID" 2> /dev/null
tried "signal the grader" $?
# A shell that cannot start a process may end: then the first of these lines stands.
tell "start a process" stopped
(tell "start a process" reached; rm -f /tmp/raybook-probe-by-a-shell)

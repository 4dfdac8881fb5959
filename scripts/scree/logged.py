"""Runs a command and keeps what it says: python3 -m scree.logged OUT_DIR COMMAND ...

Standard output and standard error go on to where ours go, and both to a file in OUT_DIR, see KeptLog. On a terminal
the command has a terminal too, so that the program shows its progress in one line; of such a line the log keeps the
last state. SIGUSR1, SIGTERM and SIGINT go on to the command; its exit code is ours."""
import os
import pty
import signal
import subprocess
import sys
import threading
import tty

from scree.program import KeptLog


def pipe_like(stream):
    """Reading and writing end of a terminal if the stream is one, else of a pipe."""
    if not stream.isatty():
        return os.pipe()
    reader, writer = pty.openpty()
    tty.setraw(writer)  # line ends stay as they are: the outer terminal turns them
    return reader, writer


def read(descriptor):
    """What there is to read; empty at the end, which a terminal tells by an error."""
    try:
        return os.read(descriptor, 65536)
    except OSError:
        return b""


def copy(descriptor, target, log, lock):
    """Passes on what comes; whole lines go to the log."""
    open_line = b""
    while data := read(descriptor):
        target.buffer.write(data)
        target.buffer.flush()
        *lines, open_line = (open_line + data).split(b"\n")
        with lock:
            for line in lines:
                log.write(settled(line) + b"\n")
            log.flush()
    if open_line:
        with lock:
            log.write(settled(open_line) + b"\n")


def settled(line):
    """What stays of a line that was written over, without the codes of the terminal."""
    return line.rstrip(b"\r").split(b"\r")[-1].replace(b"\033[K", b"")


class Signals:
    """Passes signals on to a process, also those that come before it is there."""

    def __init__(self):
        self.process, self.waiting = None, []
        for number in (signal.SIGUSR1, signal.SIGTERM, signal.SIGINT):
            signal.signal(number, self.receive)

    def receive(self, number, _):
        if self.process:
            self.process.send_signal(number)
        else:
            self.waiting.append(number)

    def go_to(self, process):
        self.process = process
        for number in self.waiting:
            process.send_signal(number)


def run(log_file, command):
    """Runs the command to its end; its exit code, 128 + the signal that ended it."""
    lock, threads, writers, signals = threading.Lock(), [], [], Signals()
    with open(log_file, "ab") as log:
        for target in (sys.stdout, sys.stderr):
            reader, writer = pipe_like(target)
            writers.append(writer)
            threads.append(threading.Thread(target=copy, args=(reader, target, log, lock)))
        process = subprocess.Popen(command, stdout=writers[0], stderr=writers[1])
        signals.go_to(process)
        for writer in writers:
            os.close(writer)
        for thread in threads:
            thread.start()
        code = process.wait()
        for thread in threads:
            thread.join()
    return 128 - code if code < 0 else code


def main():
    directory, *command = sys.argv[1:]
    log = KeptLog(directory, "-restart" in command)
    code = run(log.part, command)
    log.settle()
    sys.exit(code)


if __name__ == "__main__":
    main()

"""A Slurm of two nodes on one machine: munged, slurmctld and two slurmd, all in one folder, ended with everything that they
have started when the test ends, however it does. Needs Debian's slurmctld, slurmd, slurm-client and munge, and root."""

import ctypes
import os
import pathlib
import secrets
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "munge", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol")
PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36
LIBC = ctypes.CDLL(None, use_errno=True)


def missing():
    """Why there can be no cluster here; empty if there can."""
    absent = [program for program in PROGRAMS if not shutil.which(program)]
    if absent:
        return f"{absent[0]} is not installed (scripts/setup slurm)"
    return "" if os.geteuid() == 0 else "slurmd wants root"


def free_ports(count):
    """So that two of these tests, and a Slurm of the machine's own, do not meet."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def processes():
    """Of each process its parent and its environment."""
    table = {}
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            table[int(entry.name)] = (parent, (entry / "environ").read_bytes().split(b"\0"))
        except (OSError, IndexError):  # it has ended
            pass
    return table


def descendants(table, of):
    found, last = {of}, None
    while found != last:
        last = set(found)
        found |= {process for process, (parent, _) in table.items() if parent in found}
    return found - {of}


class Cluster:
    """Use it with `with`. Every daemon is a child of this process, which also becomes the parent of whatever they leave
    behind: what is ended is what was started here."""

    def __init__(self, folder):
        self.folder = folder
        self.config = folder / "slurm.conf"
        self.environment = {**os.environ, "SLURM_CONF": str(self.config)}
        self.daemons = {}

    def __enter__(self):
        LIBC.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        signal.signal(signal.SIGTERM, lambda *_: exit(143))  # then __exit__ is called
        try:
            self.start()
        except BaseException:
            self.end()
            raise
        return self

    def __exit__(self, *_):
        self.end()

    def start(self):
        host, folder = socket.gethostname().split(".")[0], self.folder
        controller, first, second = free_ports(3)
        key = folder / "munge.key"
        key.write_bytes(secrets.token_bytes(1024))
        key.chmod(0o400)
        for name in ("state", "spool-n1", "spool-n2"):
            (folder / name).mkdir()
        # cred_expire: a task is started again when no message of its first start can be under way any more.
        self.config.write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=10
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SchedulerParameters=sched_interval=1,batch_sched_delay=0
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
SlurmdTimeout=10
MpiDefault=none
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={first} CPUs=1
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={second} CPUs=1
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
""")
        self.daemon("munged", "munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
                    f"--pid-file={folder}/munged.pid", f"--seed-file={folder}/munged.seed", f"--log-file={folder}/munged.log")
        self.wait_for(lambda: (folder / "munge.socket").exists(), "munged")
        self.daemon("slurmctld", "slurmctld", "-D", "-f", self.config)
        for node in ("n1", "n2"):
            self.daemon(node, "slurmd", "-D", "-f", self.config, "-N", node)
        self.wait_for(lambda: self.ask("sinfo", "-h", "-N", "-o", "%N %t").split() == ["n1", "idle", "n2", "idle"], "two idle nodes")

    def daemon(self, name, *words):
        with open(self.folder / f"{name}.out", "wb") as output:
            self.daemons[name] = subprocess.Popen([*map(str, words)], env=self.environment, stdin=subprocess.DEVNULL,
                                                  stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                                                  # Whatever ends this process, SIGKILL too, ends its daemons.
                                                  preexec_fn=lambda: LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0))

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout

    def wait_for(self, condition, what):
        """There is no limit of time here: whoever runs the test has one. A daemon that has ended is an end."""
        while not condition():
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    raise RuntimeError(f"{name} has ended, waiting for {what}:\n" + (self.folder / f"{name}.out").read_text())
            time.sleep(0.2)

    def lose(self, node):
        """The node as if its power was cut: its slurmd, and all that its tasks run, by SIGKILL."""
        daemon = self.daemons.pop(node)
        table = processes()
        ours = descendants(table, os.getpid())
        here = {process for process in ours if f"SLURMD_NODENAME={node}".encode() in table[process][1]}
        steps = {table[process][0] for process in here} & ours - here  # slurmstepd, which has no such variable
        for process in [daemon.pid, *steps, *here]:
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        daemon.wait()
        return len(here)

    def end(self):
        for name in ("n1", "n2", "slurmctld", "munged"):  # first whoever starts something
            daemon = self.daemons.pop(name, None)
            if daemon:
                daemon.terminate()
                try:
                    daemon.wait(10)
                except subprocess.TimeoutExpired:
                    daemon.kill()
                    daemon.wait()
        while True:  # children of the daemons are ours now
            left = descendants(processes(), os.getpid())
            for process in left:
                try:
                    os.kill(process, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            try:
                while os.waitpid(-1, os.WNOHANG)[0]:
                    pass
            except ChildProcessError:
                return
            time.sleep(0.05)

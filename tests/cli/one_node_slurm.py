"""A Slurm of one node: munged, slurmctld and slurmd of this machine, in a folder and with ports of their own.

Any user can start it. It reads nothing from /etc/slurm, and an installed Slurm does not notice it.
"""

import contextlib
import os
import pathlib
import pwd
import secrets
import shutil
import signal
import socket
import subprocess

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol")
PATH = f"{os.environ['PATH']}:/usr/sbin:/sbin"

CONFIGURATION = """ClusterName=one
SlurmctldHost={name}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
MailProg=/bin/true
ProctrackType=proctrack/linuxproc
TaskPlugin=task/affinity
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SlurmdParameters=config_overrides
DependencyParameters=kill_invalid_depend
MinJobAge=3600
NodeName={name} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
"""


def version():
    done = subprocess.run([shutil.which("slurmctld", path=PATH), "-V"], capture_output=True, text=True, check=True)
    return done.stdout.split()[1]


def unfit():
    """Returns why this machine cannot start the cluster; empty if it can."""
    absent = [program for program in PROGRAMS if not shutil.which(program, path=PATH)]
    if absent:
        return f"{', '.join(absent)} not found: cmake/setup.sh cluster installs Slurm"
    if version().startswith("23.11."):
        return f"Slurm {version()} starts no job without an accounting database: 'has invalid account'"
    return ""


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


class OneNodeSlurm:
    """The running cluster; `processors` may exceed the machine's, so that small machines run the same jobs."""

    def __init__(self, folder, processors):
        self.folder, self.processors = pathlib.Path(folder), processors
        self.configuration = self.folder / "slurm.conf"
        self.started = contextlib.ExitStack()

    def __enter__(self):
        self.folder.chmod(0o755)  # munged insists that every user can reach its socket
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        controller_port, node_port = free_ports(2)
        self.configuration.write_text(CONFIGURATION.format(
            name=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.getuid()).pw_name, folder=self.folder,
            controller_port=controller_port, node_port=node_port, processors=self.processors))
        # Slurm loads a plugin for control groups even if no job uses them. Only from 24 on it knows "disabled"; "v1" loads
        # without a hierarchy.
        plugin = "disabled" if int(version().split(".")[0]) >= 24 else "cgroup/v1"
        (self.folder / "cgroup.conf").write_text(f"CgroupPlugin={plugin}\n")
        with self.started:
            self._start_munged()
            self._start("slurmctld")
            self._start("slurmd")
            self._run_a_job()
            self.started = self.started.pop_all()
        return self

    def __exit__(self, *_):
        self.started.close()

    def environment(self):
        """Returns the environment in which Slurm's commands find this cluster."""
        return dict(os.environ, SLURM_CONF=str(self.configuration))

    def logs(self):
        """Returns what the daemons have written last, for a failed test."""
        def end(path):
            return "".join(path.read_text(errors="replace").splitlines(keepends=True)[-20:])
        return "\n".join(f"{path.name}:\n{end(path)}" for path in sorted(self.folder.glob("*.log")))

    def _run_a_job(self):
        """Waits until the cluster has run a job."""
        try:
            subprocess.run(["sbatch", "--wait", "--output", "/dev/null", "--wrap", "true"], check=True, timeout=120,
                           capture_output=True, text=True, cwd=self.folder, env=self.environment())
        except subprocess.SubprocessError as error:
            raise RuntimeError(f"Slurm runs no job: {error}\n{getattr(error, 'stderr', '')}\n{self.logs()}") from error

    def _start_munged(self):
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        files = [f"--socket={self.folder}/munge.socket", f"--key-file={key}", f"--seed-file={self.folder}/munge.seed",
                 f"--pid-file={self.folder}/munge.pid", f"--log-file={self.folder}/munge.log"]
        munged = shutil.which("munged", path=PATH)
        # Returns when the socket is ready. Slurm wants at least ten threads.
        subprocess.run([munged, "--num-threads=10", *files], check=True, capture_output=True, text=True, timeout=60)
        pid = int((self.folder / "munge.pid").read_text())
        self.started.callback(os.kill, pid, signal.SIGTERM)

    def _start(self, daemon):
        log = self.started.enter_context((self.folder / f"{daemon}.log").open("w"))
        process = subprocess.Popen([shutil.which(daemon, path=PATH), "-D", "-f", self.configuration], stdout=log,
                                   stderr=subprocess.STDOUT, cwd=self.folder)

        def end():
            process.terminate()
            process.wait(timeout=60)
        self.started.callback(end)

"""Good runs in bad surroundings: links, pipes, full disks, folders without permission, two writers at once."""
import os
import resource
import signal
import subprocess
import threading

import judge

MAZE = "maze_25x25.txt"


def run(taut, words, folder, **more):
    more.setdefault("timeout", 120)
    return subprocess.run([taut, *words], cwd=folder, capture_output=True, check=False, **more)


def expect(holds, words):
    return [] if holds else [words]


def link_is_followed(taut, folder):
    """A link to a file stays a link, and the file it names is written."""
    (folder / "real.svg").write_bytes(judge.OLD)
    os.symlink("real.svg", folder / "link.svg")
    done = run(taut, ["solve", MAZE, "--svg", "link.svg"], folder)
    return expect(done.returncode == 0 and (folder / "link.svg").is_symlink() and (folder / "real.svg").read_bytes().startswith(b"<"),
                  "a link to a file is replaced or not followed")


def dangling_link(taut, folder):
    os.symlink("nowhere/file.svg", folder / "dangling.svg")
    done = run(taut, ["solve", MAZE, "--svg", "dangling.svg"], folder)
    return expect(done.returncode == 3 and (folder / "dangling.svg").is_symlink(), f"a dangling link: exit {done.returncode}")


def link_to_itself(taut, folder):
    os.symlink("loop", folder / "loop")
    done = run(taut, ["solve", "loop"], folder)
    written = run(taut, ["solve", MAZE, "--json", "loop"], folder)
    return expect(done.returncode == 3 and written.returncode == 3, f"a link to itself: exit {done.returncode}, {written.returncode}")


def fifo_is_read(taut, folder):
    os.mkfifo(folder / "in")
    text = (folder / MAZE).read_bytes()
    threading.Thread(target=lambda: (folder / "in").write_bytes(text), daemon=True).start()
    done = run(taut, ["solve", "in"], folder)
    return expect(done.returncode == 0, f"a FIFO as world: exit {done.returncode}")


def fifo_is_written(taut, folder):
    os.mkfifo(folder / "out")
    got = []
    reader = threading.Thread(target=lambda: got.append((folder / "out").read_bytes()), daemon=True)
    reader.start()
    done = run(taut, ["solve", MAZE, "--svg", "out"], folder)
    reader.join(10)
    return expect(done.returncode == 0 and got and judge.is_whole(got[0]), f"a FIFO as picture: exit {done.returncode}")


def full_disk(taut, folder):
    """A file system without room, as a limit on the size of files shows it."""
    (folder / "full.svg").write_bytes(judge.OLD)

    def small():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
    done = run(taut, ["solve", MAZE, "--svg", "full.svg"], folder, preexec_fn=small)
    left = [path.name for path in folder.iterdir() if path.name.startswith(("full.svg.", ".full"))]
    return expect(done.returncode == 4 and (folder / "full.svg").read_bytes() == judge.OLD and not left,
                  f"a full disk: exit {done.returncode}, left {left}")


def full_device(taut, folder):
    with open("/dev/full", "wb") as device:
        done = subprocess.run([taut, "solve", MAZE, "--path"], cwd=folder, stdout=device, stderr=subprocess.PIPE, timeout=60)
    return expect(done.returncode == 4 and done.stderr.startswith(b"taut: "), f"/dev/full as output: exit {done.returncode}")


def closed_pipe(taut, folder):
    """Whoever reads has gone: the program ends as others in a pipe do, without a word."""
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([taut, "generate", "--size", "300"], cwd=folder, stdout=write, stderr=subprocess.PIPE, timeout=60)
    os.close(write)
    return expect(done.returncode in (0, 4, -signal.SIGPIPE) and not done.stderr, f"a closed pipe: exit {done.returncode}")


def closed_streams(taut, folder):
    """No standard streams at all: files that are opened must not be taken for them."""
    done = subprocess.run(["sh", "-c", f'"{taut}" solve {MAZE} --svg closed.svg <&- >&- 2>&-'], cwd=folder, timeout=60, check=False)
    path = folder / "closed.svg"
    return expect(done.returncode in (0, 3, 4) and (not path.exists() or judge.is_whole(path.read_bytes())),
                  f"closed streams: exit {done.returncode}, or the picture has other text in it")


def folder_without_permission(taut, folder):
    """As another user where this is run by root: root may write everywhere."""
    closed = folder / "closed"
    closed.mkdir(mode=0o777)
    (closed / "old.svg").write_bytes(judge.OLD)
    os.chmod(closed, 0o555)
    os.chmod(folder, 0o755)
    as_other = {"user": 65534, "group": 65534} if os.getuid() == 0 else {}
    try:
        done = run(taut, ["solve", str(folder / MAZE), "--svg", "closed/new.svg"], folder, **as_other)
    except PermissionError:
        return []  # the program itself is out of the other user's reach
    os.chmod(closed, 0o755)
    return expect(done.returncode == 3 and sorted(os.listdir(closed)) == ["old.svg"], f"a folder without permission: exit {done.returncode}")


def folder_for_a_file(taut, folder):
    (folder / "folder").mkdir()
    read = run(taut, ["solve", "folder"], folder)
    written = run(taut, ["solve", MAZE, "--json", "folder"], folder)
    return expect(read.returncode == 3 and written.returncode == 3 and not os.listdir(folder / "folder"),
                  f"a folder in place of a file: exit {read.returncode}, {written.returncode}")


def two_writers(taut, folder):
    """Two at once write one file: it is one of theirs in whole."""
    for _ in range(20):
        pair = [subprocess.Popen([taut, "solve", MAZE, "--roadmap", name, "--svg", "both.svg", "-q"], cwd=folder)
                for name in ("polyanya", "voronoi")]
        codes = [process.wait(60) for process in pair]
        left = [path.name for path in folder.iterdir() if path.name.startswith((".both", "both.svg."))]
        if codes != [0, 0] or not judge.is_whole((folder / "both.svg").read_bytes()) or left:
            return [f"two writers: exit {codes}, left {left}"]
    return []


def killed_while_writing(taut, folder):
    """Killed at any moment: the file is whole or as it was."""
    for delay in range(1, 40):
        (folder / "killed.svg").write_bytes(judge.OLD)
        process = subprocess.Popen([taut, "solve", MAZE, "--svg", "killed.svg", "-q"], cwd=folder)
        try:
            process.wait(delay / 2000)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        text = (folder / "killed.svg").read_bytes()
        if text != judge.OLD and not judge.is_whole(text):
            return [f"killed after {delay / 2} ms: half a file"]
    return []


def same_file_in_and_out(taut, folder):
    (folder / "self.txt").write_bytes((folder / MAZE).read_bytes())
    done = run(taut, ["convert", "self.txt", "self.txt"], folder)
    again = run(taut, ["solve", "self.txt"], folder)
    return expect(done.returncode in (0, 2, 3) and again.returncode == 0, f"a file over itself: exit {done.returncode}, {again.returncode}")


def two_outputs_of_one_name(taut, folder):
    done = run(taut, ["solve", MAZE, "--svg", "one", "--json", "one"], folder)
    path = folder / "one"
    return expect(done.returncode in (2, 3) and not path.exists() or path.exists() and judge.is_whole(path.read_bytes()),
                  f"two outputs of one name: exit {done.returncode}")


ALL = [link_is_followed, dangling_link, link_to_itself, fifo_is_read, fifo_is_written, full_disk, full_device, closed_pipe, closed_streams,
       folder_without_permission, folder_for_a_file, two_writers, killed_while_writing, same_file_in_and_out, two_outputs_of_one_name]
COUNT = len(ALL)


def findings(taut, good, place):
    """All of them, each in a folder of its own that holds the maze."""
    found = []
    for surrounding in ALL:
        folder = place / surrounding.__name__
        folder.mkdir()
        (folder / MAZE).write_bytes(good[MAZE])
        try:
            found += surrounding(taut, folder)
        except subprocess.TimeoutExpired:
            found.append(f"{surrounding.__name__}: hangs")
    return found

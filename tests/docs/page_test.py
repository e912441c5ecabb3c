#!/usr/bin/env python3
"""Does what README.md and the pages in docs/ say still hold? Runs the commands of a page, in order, in a folder of its own.

usage: page_test.py TAUT ROOT PAGE
       page_test.py --cpp COMPILER ROOT      compiles the blocks of C++ of all pages, as one program

What runs:
  ```sh       each command; exit 0, unless a comment behind it says `# exit 1`
  ```console  each line after `$ `; what it prints is what stands below, `...` being anything
  ```text F   is written as the file F first; ```text alone is to be read, not run
  ```python   by tests/python/docs_test.py
  `taut ...`  in prose and tables: run if it names a file of data/, else its options have to exist; after such a command
              in the same row, `--option` alone takes the place of its last option
  links       lead somewhere
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from blocks import Page, commands, dialogue
from scratch import furnish, left_out

OTHERS_OPTIONS = {"--gtest_filter", "--no-build-isolation", "--no-deps", "--install", "--preset"}
# Written in prose with a slot for what the reader has: options are looked up, nothing is run.
SLOT = re.compile(r"\b[A-Z]{2,}\b|\.\.\.|…")


class Check:
    def __init__(self, taut, root, page):
        self.taut, self.root, self.page = taut, root, page
        self.folder = None
        self.faults = list(page.complaints)
        self.ran, self.left = 0, []
        self.helps = {}

    def fault(self, line, text):
        self.faults.append(f"{line}: {text}")

    # ---- commands --------------------------------------------------------------------------------------------------
    def shell(self, command):
        environment = dict(os.environ, PATH=f"{self.folder / 'bin'}:{os.environ['PATH']}", NO_COLOR="1",
                           TAUT_PROGRESS="0")
        return subprocess.run(["bash", "-c", command], cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)

    def run(self, line, command, exits=(0,), printed=None):
        reason = left_out(command)
        if reason:
            self.left.append(f"{line}: {command.splitlines()[0]}: {reason}")
            return
        done = self.shell(command)
        self.ran += 1
        if done.returncode not in exits:
            self.fault(line, f"{command}\n  ends with {done.returncode}: {done.stdout.strip()[-800:]}")
        elif printed is not None and not is_like(done.stdout.strip(), printed):
            self.fault(line, f"{command}\n  prints {done.stdout.strip()}\n  not    {printed}")
        for name in re.findall(r"(?<![\w/.])[\w]+\.(?:svg|json|html|png|geojson)\b", command):
            if done.returncode in exits and not (self.folder / name).is_file():
                self.fault(line, f"{command}\n  writes no {name}")

    def run_block(self, block):
        if block.name:
            (self.folder / block.name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / block.name).write_text(block.text)
        elif block.language == "sh":
            for command in commands(block.text):
                exit_note = re.search(r"#.*\bexit (\d+)", command)
                self.run(block.line, command, (int(exit_note[1]),) if exit_note else self.exits(command))
        elif block.language == "console":
            for command, printed in dialogue(block.text):
                self.run(block.line, command, range(256), printed)

    # ---- inline code -----------------------------------------------------------------------------------------------
    def help_of(self, words):
        """The help of the subcommand that these words name."""
        names = []
        for word in words[:2]:
            if not re.fullmatch(r"[a-z]+", word) or not self.helped(names + [word]):
                break
            names.append(word)
        return names, self.helped(names)

    def helped(self, names):
        key = " ".join(names)
        if key not in self.helps:
            done = subprocess.run([self.taut, "help", *names], capture_output=True, text=True)
            self.helps[key] = done.stdout if done.returncode == 0 else ""
        return self.helps[key]

    def mention(self, line, code, before):
        if code.startswith("taut "):
            if ("data/" in code or "taut generate" in code) and not SLOT.search(code):
                self.run(line, code, self.exits(code))
            else:
                self.options_exist(line, code)
        elif code.startswith("--"):
            command = next((b for b in reversed(before) if b.startswith("taut ") and "data/" in b), None)
            if command and not SLOT.search(code) and self.is_row(line):
                self.run(line, f"{without_last_option(command)} {code}", self.exits(command))
            elif code.split()[0].rstrip("=,") not in OTHERS_OPTIONS:
                self.option_exists(line, code)

    @staticmethod
    def exits(code):
        return (0, 1) if "--all" in code else (0,)  # some samples have no way, which is an answer

    def is_row(self, line):
        return next(text for number, text in self.page.prose if number == line).lstrip().startswith("|")

    def options_exist(self, line, code):
        try:
            words = shlex.split(code)[1:]
        except ValueError:
            words = code.split()[1:]
        names, text = self.help_of(words)
        if words and not names and re.fullmatch(r"[a-z]+", words[0]) and words[0] not in ("help", "certificate", "integers"):
            self.fault(line, f"`{code}`: there is no such subcommand")
        known = text if names else self.all_help()
        for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", code):
            if option not in OTHERS_OPTIONS and not re.search(rf"{option}(?![\w-])", known + self.group_help(names)):
                self.fault(line, f"`{code}`: there is no {option}")

    def group_help(self, names):
        """A group as `taut bug FILE` is a command, and so is what stands below it."""
        text = self.helped(names[:1]) + "--version --help"
        return text + "".join(self.helped([*names, below]) for below in re.findall(r"^  ([a-z]+)  ", text, re.M)) if names else text

    def option_exists(self, line, code):
        for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", code):
            if option not in OTHERS_OPTIONS and not re.search(rf"{option}(?![\w-])", self.all_help()):
                self.fault(line, f"`{code}`: no subcommand has {option}")

    def all_help(self):
        if "all" not in self.helps:
            done = subprocess.run([self.taut, "help", "--as", "bash"], capture_output=True, text=True, check=True)
            self.helps["all"] = done.stdout + "--version --help --mpi --as"
        return self.helps["all"]

    # ---- links -----------------------------------------------------------------------------------------------------
    def link(self, line, file, anchor):
        target = (self.page.path.parent / file) if file else self.page.path
        if not target.exists():
            self.fault(line, f"links to {file}, which is not there")
        elif anchor and target.suffix == ".md" and anchor not in Page(target).anchors():
            self.fault(line, f"links to {file}#{anchor}: no such heading")

    def all(self):
        with tempfile.TemporaryDirectory() as folder:
            self.folder = Path(folder)
            furnish(self.folder, self.root, self.taut)
            for block in self.page.blocks:
                self.run_block(block)
            for line, code, before in self.page.code():
                self.mention(line, code, before)
        for line, file, anchor in self.page.links():
            self.link(line, file, anchor)


def is_like(text, pattern):
    """Is it the pattern, `...` being anything and white space being one blank?"""
    parts = [re.escape(" ".join(part.split())) for part in pattern.split("...")]
    return re.fullmatch(r"\s*.*\s*".join(parts), " ".join(text.split())) is not None


def without_last_option(command):
    """The command without the last option and its value: another value, or another option, takes its place."""
    words = shlex.split(command)
    options = [i for i, word in enumerate(words) if word.startswith("--")]
    return shlex.join(words[: options[-1]]) if options else command


def compile_all(compiler, root):
    """All blocks of C++, each in a namespace of its own. README's is built and run, too, by tests/shape."""
    includes, bodies = [], []
    for path in [root / "README.md", *sorted((root / "docs").glob("**/*.md"))]:
        for block in Page(path).blocks:
            if block.language != "cpp":
                continue
            lines = block.text.splitlines()
            includes += [line for line in lines if line.startswith("#include")]
            body = "\n".join("" if line.startswith("#include") else line for line in lines)
            bodies.append(f'namespace block_{len(bodies)} {{\n#line {block.line} "{path.name}"\n{body}\n}}')
    program = "\n".join(sorted(set(includes))) + "\n" + "\n".join(bodies) + "\nint main() {}\n"
    done = subprocess.run([compiler, "@compile_flags.txt", "-x", "c++", "-fsyntax-only", "-"], cwd=root, input=program, text=True,
                          capture_output=True)
    print(f"{len(bodies)} blocks of C++")
    if done.returncode or not bodies:
        sys.exit(done.stderr or "no block of C++")


def main():
    if sys.argv[1] == "--cpp":
        return compile_all(sys.argv[2], Path(sys.argv[3]).resolve())
    taut, root = os.path.abspath(sys.argv[1]), Path(sys.argv[2]).resolve()
    check = Check(taut, root, Page(root / sys.argv[3]))
    check.all()
    print(f"{sys.argv[3]}: {check.ran} commands")
    for line in check.left:
        print(f"  left out {line}")
    for fault in check.faults:
        print(f"{sys.argv[3]}:{fault}", file=sys.stderr)
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main())

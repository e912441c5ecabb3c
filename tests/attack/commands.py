"""Random command lines, made from what the program's own help says: subcommands, options, and names that it lists."""
import re
import subprocess

VALUES = ["0", "1", "-1", "0.1", "0.25", "3", "nan", "inf", "-inf", "1e308", "1e-320", "1e999", "", " ", "x", "1,1", "3.5,2.5", "1,", ",", "1,2,3",
          "nan,nan", "1e308,1e308", "auto", "disc:0.1", "disc:0", "disc:-1", "disc:nan", "disc:1e300", "disc:", "square:0.1", "square:1e-300",
          "rectangle:0.4x0.2", "5", "5x5", "0x0", "-1x5", "99999999999999999999", "1/2", "0/0", "é", "--", "-", "'", "a" * 5000, "%s%n", "../x"]
SMALL = {"--samples": ["0", "1", "50", "-1", "x"], "--size": ["1", "2", "7x5", "0", "-3", "x"], "--runs": ["1", "2", "0", "-1"],
         "--seeds": ["1", "2", "0", "-1"], "--jobs": ["1", "2", "0", "-1", "x"]}
# What follows the world, by subcommand.
SECOND = {"batch": ["queries"], "matrix": ["points"], "verify": ["proof"], "audit": ["path.csv", "path.json", "path.geojson"],
          "scen": ["random_64x64.scen", "rooms_64x48.scen", "corridors_41x31.scen"]}
ARE_READ = {"--load", "--certificate", "--path", "--from-file", "--index"}


class Subcommand:
    """What the help of one subcommand tells of its options."""

    def __init__(self, taut, words):
        self.words = words
        text = subprocess.run([taut, *words, "--help"], capture_output=True, text=True).stdout
        self.positionals = re.findall(r"^  ([A-Z]+)(?: REQUIRED| \.\.\.| )", text.split("Options:")[0], re.MULTILINE)
        # Of an option its name, and what its value is called: nothing for a flag.
        self.options = [(name, value) for name, value in re.findall(r"^  (?:-\w,)?(--[\w-]+)(?: ([A-Z][\w|,:]*|0))?(?: |$)", text, re.MULTILINE)
                        if name not in ("--help", "--max-seconds", "--max-memory")]
        self.names = sorted(set(re.findall(r"^  ([a-z][\w:-]+)  ", text, re.MULTILINE)))
        self.reads = []

    def learn(self, taut, names, folder):
        """Which of the good files it takes: those are damaged for it most of the time."""
        for name in names if self.positionals else []:
            words = [taut, *self.words, name, *SECOND.get(self.words[-1], [name] * (len(self.positionals) - 1))[:1], "--max-seconds", "1", "-q"]
            if subprocess.run(words, cwd=folder, capture_output=True, stdin=subprocess.DEVNULL).returncode in (0, 1, 4):
                self.reads.append(name)

    def value(self, option, value, random, inputs, outputs):
        if value == "FILE":
            return random.choice(inputs if option in ARE_READ and random.random() < 0.7 else outputs)
        if option in SMALL:
            return random.choice(SMALL[option])
        if self.names and random.random() < 0.4:
            return random.choice(self.names)
        return random.choice(VALUES)

    def line(self, random, inputs, outputs):
        """Words of a command line: the world first, other files after it, then up to five options."""
        words = list(self.words)
        for i, name in enumerate(self.positionals):
            words.append(random.choice(outputs) if name == "OUT" else inputs[i] if i < 2 and random.random() < 0.95 else random.choice(inputs))
        for _ in range(random.choice([0, 0, 0, 1, 1, 2, 4])):
            if self.options:
                option, value = random.choice(self.options)
                words += [option, self.value(option, value, random, inputs, outputs)] if value else [option]
        if random.random() < 0.03:
            del words[random.randrange(len(words))]
        return words


def subcommands(taut):
    """All of them, and those below them."""
    text = subprocess.run([taut, "--help"], capture_output=True, text=True).stdout
    found = []
    for name in re.findall(r"^  ([a-z]+)  ", text.split("Subcommands:")[1], re.MULTILINE):
        if name == "help":
            continue
        below = subprocess.run([taut, name, "--help"], capture_output=True, text=True).stdout
        if "SUBCOMMAND" in below.splitlines()[1] and "[SUBCOMMAND]" not in below.splitlines()[1]:
            pass
        else:
            found.append(Subcommand(taut, [name]))
        if "Subcommands:" in below:
            found += [Subcommand(taut, [name, inner])
                      for inner in re.findall(r"^  ([a-z]+)  ", below.split("Subcommands:")[1].split("\n\n")[0], re.MULTILINE)]
    return found

"""What a page of Markdown holds: fenced blocks, inline code, links."""
import re
from dataclasses import dataclass

LANGUAGES = ("sh", "console", "python", "cpp", "text")


@dataclass
class Block:
    language: str
    name: str  # of the file that it is, `maze.txt` of ```text maze.txt
    line: int  # of its first line
    text: str


class Page:
    """Blocks and prose of a page; `prose` is [(line number, line)]."""

    def __init__(self, path):
        self.path = path
        self.blocks = []
        self.prose = []
        self.complaints = []
        fence = None
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if line.lstrip().startswith("```"):
                fence = self._open(line.strip()[3:], number) if fence is None else None
            elif fence is not None:
                fence.text += line + "\n"
            else:
                self.prose.append((number, line))

    def _open(self, words, number):
        language, _, name = words.partition(" ")
        if language not in LANGUAGES:
            self.complaints.append(f"{number}: a block of {language or 'no language'}; there are {', '.join(LANGUAGES)}")
        block = Block(language, name.strip(), number + 1, "")
        self.blocks.append(block)
        return block

    def code(self):
        """Each piece of inline code with its line's number, and the pieces before it in the same paragraph or row."""
        for number, text in self._paragraphs():
            before = []
            for piece in re.findall(r"(?<!`)`([^`]+)`(?!`)", text):
                yield number, " ".join(piece.split()), before
                before.append(" ".join(piece.split()))

    def _paragraphs(self):
        """Lines that belong together: code may be broken over two; a row of a table stands alone."""
        begin, held = 0, []
        for number, line in self.prose:
            if held and (not line.strip() or line.lstrip().startswith(("|", "- ", "#"))):
                yield begin, "\n".join(held)
                held = []
            if not held:
                begin = number
            if line.strip():
                held.append(line.replace("\\|", "|"))
        if held:
            yield begin, "\n".join(held)

    def links(self):
        """Each link to a place in this repository: (line, file, anchor)."""
        for number, line in self.prose:
            line = re.sub(r"`[^`]*`", "", line)
            for target in re.findall(r"\]\(([^)\s]+)\)", line) + re.findall(r'(?:src|href)="([^"]+)"', line):
                if not re.match(r"[a-z]+:", target):
                    file, _, anchor = target.partition("#")
                    yield number, file, anchor

    def anchors(self):
        for _, line in self.prose:
            if line.startswith("#"):
                title = re.sub(r"\]\([^)]*\)", "", line.lstrip("#").strip().lower())
                yield re.sub(r"[^\w\- ]", "", title).replace(" ", "-")


def commands(text):
    """The commands of a block for a shell: lines that end in a backslash and here-documents go on, comments are left out."""
    whole, until = "", None
    for line in text.splitlines():
        if not whole and (not line.strip() or line.lstrip().startswith("#")):
            continue
        whole += line + "\n"
        if until is None and (here := re.search(r"<<-?\s*'?(\w+)'?", line)):
            until = here[1]
        elif until is not None and line.strip() == until:
            until = None
        if until is None and not line.endswith("\\"):
            yield whole.rstrip("\n")
            whole = ""


def dialogue(text):
    """[(command, what is printed)] of a block that shows a terminal: commands begin with `$ `."""
    turns = []
    for line in text.splitlines():
        if line.startswith("$ "):
            turns.append((line[2:], []))
        elif turns:
            turns[-1][1].append(line)
    return [(command, "\n".join(printed).strip()) for command, printed in turns]

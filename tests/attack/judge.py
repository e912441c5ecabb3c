"""What is promised of every run, however bad its input: a run that breaks it is a finding."""
import json
import xml.etree.ElementTree

PROMISED = {0, 1, 2, 3, 4}
OLD = b"kept as it was\n"


def broken_promises(done, words, seconds, limit, outputs, before, folder):
    """The findings of one run of `words`. `outputs` are the names that it might write, `before` the folder's names before."""
    findings = []
    code = done.returncode
    if code not in PROMISED:
        findings.append(f"exit {code}")
    if seconds > limit:
        findings.append(f"{seconds:.1f} s where {limit} s are the limit")
    findings += of_errors(code, done.stderr)
    for name in outputs:
        findings += of_output(folder / name, code)
    left = {path.name for path in folder.iterdir()} - before - set(outputs) - set(words)
    if left:
        findings.append(f"leaves {sorted(left)}")
    return findings


def of_errors(code, errors):
    """Bad input and bad usage are said in one line that names the program; the line can be read on a terminal."""
    lines = errors.decode("utf-8", "replace").splitlines()
    if code not in (2, 3):
        return []
    refusals = [line for line in lines if line.startswith("taut: ")]
    findings = []
    if not refusals:
        findings.append(f"exit {code} without a line `taut: ...`")
    if any(len(line) > 600 for line in lines):
        findings.append(f"a line of {max(map(len, lines))} characters")
    if any(ord(letter) < 32 for line in lines for letter in line):
        findings.append("control characters in what is said")
    return findings


def of_output(path, code):
    """A file is there in whole, or as it was before."""
    if path.is_symlink() or not path.exists() or path.is_fifo() or path.is_dir():
        return []
    text = path.read_bytes()
    if text == OLD:
        return []
    if code == 2 or (code == 3 and not is_refusal(text)):
        return [f"exit {code}, and {path.name} is changed"]
    return [] if is_whole(text) else [f"{path.name} is not whole"]


def is_refusal(text):
    """What `--json` gets of bad input: an envelope that says so."""
    try:
        return json.loads(text)["status"] not in ("found", "none")
    except (ValueError, KeyError, TypeError):
        return False


def is_whole(text):
    """Can be read to its end, by what it begins with; text of other kinds ends with its line."""
    start = text.lstrip()[:1]
    try:
        if start in (b"{", b"["):
            json.loads(text)
        elif start == b"<":
            xml.etree.ElementTree.fromstring(text)
        elif text.startswith(b"\x89PNG"):
            return text.endswith(b"IEND\xaeB`\x82")
        return start in (b"{", b"[", b"<") or text.endswith(b"\n") or text.startswith(b"taut")
    except (ValueError, xml.etree.ElementTree.ParseError):
        return False

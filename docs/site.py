#!/usr/bin/env python3
"""The pages of this project as a site: site.py ROOT OUT. Markdown by cmark-gfm; links among pages follow."""
import html
import re
import shutil
import subprocess
import sys
from pathlib import Path

STYLE = """
:root { color-scheme: light dark; --ink: #1f2430; --paper: #fff; --line: #d5d9e2; --link: #1a56b0; --code: #f3f4f7; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7ee; --paper: #171a21; --line: #3a404d; --link: #8ab4f8; --code: #232833; }
  img { background: #f7f6f2; }
}
body { margin: 0; color: var(--ink); background: var(--paper); font: 16px/1.55 system-ui, sans-serif; }
body { display: flex; flex-wrap: wrap; }
nav { flex: 0 0 13rem; padding: 1.5rem; border-right: 1px solid var(--line); font-size: .9rem; }
nav a { display: block; padding: .1rem 0; }
main { flex: 1 1 20rem; min-width: 0; max-width: 52rem; padding: 1.5rem; overflow-wrap: break-word; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
pre { background: var(--code); padding: .8rem; overflow-x: auto; } code { background: var(--code); font-size: .9em; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
th, td { border: 1px solid var(--line); padding: .3rem .6rem; vertical-align: top; text-align: left; }
img { max-width: 100%; }
"""
ABOVE = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "bench/README.md",
         "data/README.md"]

linked_files = set()  # that are no pages: they are copied


def anchor(title):
    text = html.unescape(re.sub(r"<[^>]*>", "", title)).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def page_of(file):
    """Where a page of Markdown goes in the site: README.md is its index."""
    return Path("index.html") if str(file) == "README.md" else file.with_suffix(".html")


def linked(match, file, root, pages):
    before, target = match[1], match[2]
    path, _, part = target.partition("#")
    if re.match(r"[a-z]+:", target) or not path:
        return match[0]
    place = Path(*_normal((file.parent / path).parts))
    up = "../" * len(page_of(file).parent.parts)
    if place in pages:
        return f'{before}{up}{page_of(place)}{"#" + part if part else ""}"'
    if not (root / place).is_file():
        sys.exit(f"{file}: links to {target}, which is not there")
    linked_files.add(place)
    return f'{before}{up}{place}"'


def _normal(parts):
    out = []
    for part in parts:
        if part == "..":
            out.pop()
        else:
            out.append(part)
    return out


def rendered(file, root, pages, titles):
    text = subprocess.run(["cmark-gfm", "--unsafe", "-e", "table", root / file], capture_output=True, text=True,
                          check=True).stdout
    text = re.sub(r"<(h[1-6])>(.*?)</\1>", lambda m: f'<{m[1]} id="{anchor(m[2])}">{m[2]}</{m[1]}>', text)
    text = re.sub(r'((?:href|src)=")([^"]+)"', lambda m: linked(m, file, root, pages), text)
    up = "../" * len(page_of(file).parent.parts)
    links = "".join(f'<a href="{up}{page_of(p)}">{html.escape(titles[p])}</a>' for p in pages)
    return (f'<!DOCTYPE html>\n<html lang="en"><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width">'
            f"<title>{html.escape(titles[file])}</title><style>{STYLE}</style>\n"
            f'<nav aria-label="Pages"><a href="{up}api/index.html"><b>Reference of the library</b></a>{links}</nav>\n'
            f"<main>\n{text}</main></html>\n")


def main():
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    pages = [Path(p) for p in ABOVE] + sorted(p.relative_to(root) for p in (root / "docs").glob("**/*.md"))
    titles = {p: re.search(r"^# (.*)$", (root / p).read_text("utf-8"), re.M)[1] for p in pages}
    for page in pages:
        target = out / page_of(page)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(rendered(page, root, pages, titles), encoding="utf-8")
    for file in linked_files:
        (out / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(root / file, out / file)
    print(f"{len(pages)} pages in {out}")


if __name__ == "__main__":
    main()

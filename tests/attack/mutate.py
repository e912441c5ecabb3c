"""Damaged files: bytes of a good one, changed as disks, editors and enemies change them."""

NUMBERS = [b"nan", b"-nan", b"inf", b"-1e308", b"1e999", b"1e-320", b"-0", b"1e300", b"9007199254740993", b"2147483648",
           b"-2147483649", b"18446744073709551616", b"0.1", b"0.30000000000000004", b"1e-75", b"0x10", b"1,5", b"1e", b"+", b".",
           b"1" * 400, b"0." + b"3" * 400, b""]
PIECES = [b"\0", b"\xff\xfe", b"\xef\xbb\xbf", b"\r\n", b"\r", b"\n\n", b"\t", b" " * 1000, b"[" * 2000, b"{", b"}", b"]", b"(", b")", b"\"",
          b"#", b"start ", b"goal ", b"boundary ", b"POLYGON EMPTY", b"null", b"<svg>", b"P5\n9 9\n255\n", b"o---o\n", b"-" * 5000]
WORDS = b" \t\n\r,;:()[]{}\"'"


def numbers_in(text):
    """The places of what looks like a number, as (begin, end)."""
    places, begin = [], None
    for i, byte in enumerate(text + b" "):
        inside = chr(byte) in "0123456789+-.eE"
        if inside and begin is None:
            begin = i
        elif not inside and begin is not None:
            places.append((begin, i))
            begin = None
    return places


def other_number(text, random):
    places = numbers_in(text)
    if not places:
        return text
    begin, end = random.choice(places)
    return text[:begin] + random.choice(NUMBERS) + text[end:]


def number_of_elsewhere(text, random):
    places = numbers_in(text)
    if not places:
        return text
    (begin, end), (other, other_end) = random.choice(places), random.choice(places)
    return text[:begin] + text[other:other_end] + text[end:]


def other_bit(text, random):
    place = random.randrange(len(text))
    return text[:place] + bytes([text[place] ^ (1 << random.randrange(8))]) + text[place + 1:]


def inserted(text, random):
    place = random.randrange(len(text) + 1)
    return text[:place] + random.choice(PIECES) + text[place:]


def cut(text, random):
    return text[:random.randrange(len(text))]


def left_out(text, random):
    begin = random.randrange(len(text))
    return text[:begin] + text[begin + random.randrange(1, 200):]


def doubled(text, random):
    begin = random.randrange(len(text))
    end = begin + random.randrange(1, 200)
    return text[:end] + text[begin:]


def other_order(text, random):
    lines = text.splitlines(keepends=True)
    random.shuffle(lines)
    return b"".join(lines)


def line_left_out(text, random):
    lines = text.splitlines(keepends=True)
    del lines[random.randrange(len(lines))]
    return b"".join(lines)


def line_doubled(text, random):
    lines = text.splitlines(keepends=True)
    lines.insert(random.randrange(len(lines)), random.choice(lines))
    return b"".join(lines)


MUTATIONS = [other_number, other_number, number_of_elsewhere, other_bit, inserted, cut, left_out, doubled, other_order, line_left_out,
             line_doubled]


def damaged(text, random):
    """One to four changes in a row; one file in twenty is left as it is, one in fifty is empty."""
    if random.random() < 0.02:
        return b""
    if random.random() < 0.05:
        return text
    for _ in range(random.choice([1, 1, 1, 2, 4])):
        if text:
            text = random.choice(MUTATIONS)(text, random)
    return text

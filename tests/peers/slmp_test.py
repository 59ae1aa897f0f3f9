#!/usr/bin/env python3
"""npm's mcprotocol and `symplant doctor` read the memory of one SLMP server, whose contents are known, alike.

usage: slmp_test.py SYMPLANT SLMP_KNOWN_PLC PACKAGES

PACKAGES is the folder of mcprotocol, existing or new. Exit code: 0 passed, 1 a check failed, 77 mcprotocol is not available:
the doctor was tried and passed.

What mcprotocol 0.1.2 cannot do is left to the doctor: B and W (it has no such devices, and no hexadecimal numbers), 3E in
ASCII (it sends no device code), more than 160 bits or 64 words in an item. X and Y are octal or decimal for it.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
DEVICES = ["X", "Y", "M", "B", "D", "W"]
WORDS = ("D", "W")
HEXADECIMAL = ("B", "W")
COUNT = 128  # of symbols in a group
NUMBERS = 32
# Where the symbols of a group lie: in the list at X or Y from the first number on, in the PLC at a device from a number on.
GROUPS = [("X", 0, "X", 0), ("X", 128, "M", 7552), ("X", 256, "B", 128), ("X", 384, "D", 100),
          ("Y", 0, "Y", 0), ("Y", 128, "M", 0), ("Y", 256, "B", 0), ("Y", 384, "W", 16)]
NUMBER_GROUPS = [("I", "D", 200), ("Q", "D", 7968), ("I", "W", 64), ("Q", "W", 480)]


def fail(what):
    print("FAILED:", what)
    sys.exit(1)


def known_word(device, number):
    return ((number + 1) * 40503 + DEVICES.index(device) * 9973) % 65536


def known_bit(device, number):
    return known_word(device, number // 16) >> number % 16 & 1


def text_of(device, number, family):
    if device in ("X", "Y"):
        return f"{device}{number:o}" if family == "fx5" else f"{device}{number:X}"
    return f"{device}{number:X}" if device in HEXADECIMAL else f"{device}{number}"


def plant_and_link(family):
    """The symbol list, the moves of the link, and the known value of each symbol."""
    rows, moves, known = ["Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial"], [], {}
    for area, first, device, number in GROUPS:
        for i in range(COUNT):
            name = f"L_P_{area}{first + i}_{'I' if area == 'X' else 'O'}_A"
            rows.append(f"VAR_GLOBAL,{name},{text_of(area, first + i, family)},,BOOL,FALSE")
            known[name] = known_bit(device, 16 * number + i if device in WORDS else number + i)
        if device != area:
            moves.append(f"{text_of(area, first, family)}-{text_of(area, first + COUNT - 1, family)}:{text_of(device, number, family)}")
    for area, device, number in NUMBER_GROUPS:
        for i in range(NUMBERS):
            name = f"L_P_{device}{number + i}_{'I' if area == 'I' else 'O'}_N"
            rows.append(f"VAR_GLOBAL,{name},,%{area}W{number + i},WORD,0")
            known[name] = known_word(device, number + i)
            moves.append(f"{name}:{text_of(device, number + i, family)}")
    return "\n".join(rows) + "\n", "".join(f"&map={move}" for move in moves), known


def doctor(symplant, port, family):
    """Compares what the doctor reads with the known values; returns how many."""
    text, moves, known = plant_and_link(family)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "symbols.csv"
        path.write_text(text, encoding="utf-8")
        done = subprocess.run([symplant, "doctor", str(path), "--xy", "octal" if family == "fx5" else "hex", "--for", "1ms",
                               "--all", "--format", "json", "--link",
                               f"slmp://127.0.0.1:{port}?family={family}&events=direct{moves}"], capture_output=True, check=False)
    if done.returncode not in (0, 1):
        fail(f"doctor, {family}: exit code {done.returncode}: {done.stderr.decode(errors='replace')[:1000]}")
    values = {point["symbol"]: point["value"] for point in json.loads(done.stdout)["points"]}
    wrong = [(name, value, values.get(name)) for name, value in known.items() if values.get(name) != value]
    if wrong:
        fail(f"doctor, {family}: {len(wrong)} wrong values (symbol, known, read): {wrong[:10]}")
    return len(known)


def mcprotocol(packages, port, family):
    """Compares what mcprotocol reads of the same devices, and more, with the known values; returns how many."""
    octal = family == "fx5"
    ranges = [(device, first, 160) for device in ("X", "Y", "M") for first in (0, 160, 320)] + [("M", 7520, 160)]
    ranges += [("D", first, 64) for first in (64, 128, 192, 7936)]
    items = {f"{device}{first:o},{count}" if octal and device in ("X", "Y") else f"{device}{first},{count}": (device, first, count)
             for device, first, count in ranges}
    done = subprocess.run(["node", str(HERE / "slmp" / "mcprotocol.js"), packages, str(port), json.dumps(octal), *items],
                          capture_output=True, check=False, timeout=60)
    if done.returncode != 0:
        fail(f"mcprotocol, {family}: exit code {done.returncode}: {done.stderr.decode(errors='replace')[-1000:]}")
    read = json.loads(done.stdout)
    for item, (device, first, count) in items.items():
        known = [known_word(device, first + i) if device in WORDS else bool(known_bit(device, first + i)) for i in range(count)]
        values = [value % 65536 if device in WORDS else value for value in read[item]]  # it takes words as signed
        if values != known:
            fail(f"mcprotocol, {family}: {item}: known {known[:20]}, read {values[:20]}")
    return sum(count for _, _, count in ranges)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    symplant, plc, packages = (os.path.abspath(argument) for argument in sys.argv[1:])
    fetched = subprocess.run([str(HERE / "npm_package.sh"), packages, "mcprotocol@0.1.2"], check=False)  # 0.6 MB
    foreign = fetched.returncode == 0 and shutil.which("node") is not None
    for family in ("iqr", "fx5"):
        with subprocess.Popen([plc, family], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as server:
            port = int(server.stdout.readline())
            ours = doctor(symplant, port, family)
            theirs = mcprotocol(packages, port, family) if foreign else 0
            said, _ = server.communicate()
        if server.returncode != 0:
            fail(f"{family}: the clients broke rules of the protocol: {said[:1000]}")
        print(f"{family}: the doctor read {ours} symbols, mcprotocol {theirs} devices, no wrong value")
    if not foreign:
        print("mcprotocol or node is not available: counts as skipped")
        sys.exit(77)


main()

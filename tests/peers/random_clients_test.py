#!/usr/bin/env python3
"""Random third-party Modbus clients: pymodbus, npm's modbus-serial and mbpoll take turns on one plant.

usage: random_clients_test.py SYMPLANT PACKAGES OPERATIONS [SEED]

Every answer is compared with a model of the four tables: no bit may be wrong. PACKAGES is the folder of modbus-serial,
existing or new. Exit code: 0 passed, 1 a check failed, 77 a client is not available: the others were tried and passed.
"""
import collections
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

from running_plant import RunningPlant

HERE = pathlib.Path(__file__).resolve().parent / "random_clients"
PATIENCE = 20  # seconds in which inputs must follow, on a machine of any speed
ILLEGAL_ADDRESS, ILLEGAL_VALUE = 2, 3
READS = {"read_coils": 2000, "read_discrete_inputs": 2000, "read_holding_registers": 125, "read_input_registers": 125}
WRITES = {"write_coils": 1968, "write_registers": 123}
ROUND = 25  # operations between two barriers, on average


class Wrong(Exception):
    pass


class Play:
    """The operations, drawn one by one; `clients` has the weight of each client."""

    def __init__(self, known, layout, clients, refusal, dice, operations):
        self.known, self.layout, self.dice, self.operations = known, layout, dice, operations
        self.clients, self.turns = list(clients), list(clients.values())
        self.refusal, self.client, self.done, self.waited = refusal, None, 0, 0
        self.counts, self.calls = collections.Counter(), collections.Counter()
        self.size = {"read_coils": layout.COILS, "read_discrete_inputs": layout.INPUTS,
                     "read_holding_registers": layout.HOLDING, "read_input_registers": layout.INPUT_REGISTERS,
                     "write_coils": layout.COILS, "write_registers": layout.HOLDING}

    def all(self):
        kinds = {self.read: 50, self.write_one: 12, self.write_many: 18, self.mask: 4, self.write_and_read: 4, self.refused: 6,
                 self.barrier: 100 / ROUND, self.trigger: 100 * self.layout.TRIGGERS / 2 / self.operations}
        while self.done < self.operations:
            (self.client,) = self.dice.choices(self.clients, self.turns)
            self.dice.choices(list(kinds), list(kinds.values()))[0]()
        self.whole_tables()

    def do(self, call, *args):
        self.done += 1
        self.counts[self.client.name] += 1
        self.calls[call] += 1
        try:
            return self.client.do(call, *args)
        except RuntimeError as error:
            raise Wrong(f"{call}{args}: {error}") from error

    def must(self, wanted, call, *args):
        seen = self.do(call, *args)
        if seen != wanted:
            raise Wrong(f"{call}{args}: expected {wanted}, seen {seen}")

    def may(self, call):
        """mbpoll supports neither calls that read and write nor long ranges: another client then takes its turn."""
        if self.client.name == "mbpoll" and call in ("mask_write_register", "readwrite_registers"):
            self.client = self.clients[0]

    def quantity(self, most):
        most = min(most, getattr(self.client, "MOST", most))
        boundaries = [count for count in (1, 2, 7, 8, 9, 16, 17, most - 1, most) if 1 <= count <= most]
        return self.dice.choice([*boundaries, self.dice.randint(1, most), self.dice.randint(1, most)])

    def place(self, first, size, count):
        last = first + size - count
        return self.dice.choice([first, last, self.dice.randint(first, last), self.dice.randint(first, last)])

    def read(self):
        call = self.dice.choice(list(READS))
        count = self.quantity(READS[call])
        self.compare(call, self.place(0, self.size[call], count), count)

    def compare(self, call, first, count):
        """Reads, and repeats as long as only inputs that may still change differ."""
        table = {"read_coils": self.known.coils, "read_discrete_inputs": self.known.inputs,
                 "read_holding_registers": self.known.holding, "read_input_registers": self.known.input_registers}[call]
        end = time.monotonic() + PATIENCE
        while True:
            seen, wanted = self.do(call, first, count), table[first:first + count]
            if seen == wanted:
                return
            if not isinstance(seen, list) or len(seen) != count:
                raise Wrong(f"{call}({first}, {count}): seen {seen}")
            wrong = [first + i for i in range(count) if seen[i] != wanted[i]]
            late = call == "read_discrete_inputs" and self.known.unsettled.issuperset(wrong)
            if not late or time.monotonic() > end:
                raise Wrong(f"{call}({first}, {count}): wrong at {wrong[:10]}: seen {[seen[i - first] for i in wrong[:10]]}")
            self.look_again(call)

    def look_again(self, call):
        """Repeating the same request does not count as an operation."""
        self.done -= 1
        self.counts[self.client.name] -= 1
        self.calls[call] -= 1
        self.waited += 1
        time.sleep(0.001)

    def coils_window(self, most):
        kept = self.layout.KEPT
        first, size = self.dice.choice([(0, kept.start), (kept.stop, self.layout.COILS - kept.stop)])
        count = self.quantity(min(most, size))
        return self.place(first, size, count), count

    def write_one(self):
        if self.dice.randrange(2):
            place, _ = self.coils_window(1)
            bit = self.dice.randrange(2)
            self.must([place, bit], "write_coil", place, bool(bit))
            self.known.write_coils(place, [bit])
        else:
            place, word = self.place(0, self.layout.HOLDING, 1), self.dice.randrange(65536)
            self.must([place, word], "write_register", place, word)
            self.known.write_holding(place, [word])

    def write_many(self):
        if self.dice.randrange(2):
            first, count = self.coils_window(WRITES["write_coils"])
            bits = [self.dice.randrange(2) for _ in range(count)]
            self.must([first, count], "write_coils", first, [bool(bit) for bit in bits])
            self.known.write_coils(first, bits)
        else:
            count = self.quantity(WRITES["write_registers"])
            first, words = self.place(0, self.layout.HOLDING, count), [self.dice.randrange(65536) for _ in range(count)]
            self.must([first, count], "write_registers", first, words)
            self.known.write_holding(first, words)

    def mask(self):
        self.may("mask_write_register")
        place, and_mask, or_mask = self.place(0, self.layout.HOLDING, 1), self.dice.randrange(65536), self.dice.randrange(65536)
        self.must([place, and_mask, or_mask], "mask_write_register", place, and_mask, or_mask)
        word = (self.known.holding[place] & and_mask) | (or_mask & ~and_mask & 0xFFFF)
        self.known.write_holding(place, [word])

    def write_and_read(self):
        self.may("readwrite_registers")
        count, size = self.quantity(121), self.quantity(125)
        first, words = self.place(0, self.layout.HOLDING, count), [self.dice.randrange(65536) for _ in range(count)]
        read_first = self.place(0, self.layout.HOLDING, size)
        self.known.write_holding(first, words)  # the write comes first
        self.must(self.known.holding[read_first:read_first + size], "readwrite_registers", read_first, size, first, words)

    def refused(self):
        """Requests with one fault each. mbpoll itself rejects invalid quantities; 124 registers do not fit a legal frame."""
        call = self.dice.choice([*READS, *WRITES])
        most = READS.get(call) or WRITES[call]
        faults = ["beyond", "across"] if call != "read_input_registers" else ["beyond"]
        fault = self.dice.choice(faults if self.client.name == "mbpoll" or call == "write_registers" else [*faults, "too many"])
        count = most + 1 if fault == "too many" else self.quantity(most)
        first = {"too many": 0, "beyond": self.dice.randint(60000, 65535 - count),
                 "across": self.size[call] - self.dice.randint(0, count - 1)}[fault]
        values = count if call in READS else [True if call == "write_coils" else 1] * count
        self.must(self.refusal(ILLEGAL_VALUE if fault == "too many" else ILLEGAL_ADDRESS), call, first, values)

    def barrier(self):
        """One more write, and a wait until its device has followed: then all earlier ones have."""
        coil, (on, _) = self.layout.BARRIER, self.known.followers[self.layout.BARRIER]
        bit = 1 - self.known.coils[coil]
        self.must([coil, bit], "write_coil", coil, bool(bit))
        self.known.write_coils(coil, [bit])
        self.compare("read_discrete_inputs", on, 1)
        self.known.unsettled.clear()

    def trigger(self):
        coil = self.known.next_trigger()
        if coil is None:
            return
        self.must([coil, 1], "write_coil", coil, True)
        self.known.write_coils(coil, [1])
        end = time.monotonic() + PATIENCE
        while self.do("read_input_registers", self.layout.STAMP, 1) != [self.known.triggered]:
            if time.monotonic() > end:
                raise Wrong(f"trigger {self.known.triggered} is not followed")
            self.look_again("read_input_registers")

    def whole_tables(self):
        self.client = self.clients[0]
        while self.known.triggered < self.layout.TRIGGERS:
            self.trigger()
        self.barrier()
        for self.client in self.clients:
            for call, most in READS.items():
                size, most = self.size[call], min(most, getattr(self.client, "MOST", most))
                for first in range(0, size, most):
                    self.compare(call, first, min(most, size - first))


def clients_on(port, packages, clients):
    """The available clients, with the weight of each."""
    found = {clients.Pymodbus(port): 55}
    fetch = [str(HERE.parent / "npm_package.sh"), packages, "modbus-serial@8.0.25"]  # 0.5 MB with its dependencies
    if subprocess.run(fetch, check=False).returncode == 0 and shutil.which("node"):
        found[clients.ModbusSerial(str(HERE / "modbus_serial.js"), packages, port)] = 44
    if shutil.which("mbpoll"):
        found[clients.Mbpoll(port)] = 1
    return found


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    symplant, packages, operations = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), int(sys.argv[3])
    seed = int(sys.argv[4]) if len(sys.argv) == 5 else 12
    sys.path.insert(0, str(HERE))
    try:
        import clients
    except ImportError:
        print("python3-pymodbus is not installed: skipped")
        sys.exit(77)
    import plant as layout

    dice = random.Random(seed)
    known = layout.KnownPlant(dice)
    with tempfile.TemporaryDirectory() as folder:
        running = RunningPlant([symplant, "run", *known.write_files(pathlib.Path(folder)), "--cycle", "2ms"], folder)
        found = clients_on(running.port, packages, clients)
        play = Play(known, layout, found, clients.Refused, dice, operations)
        began = time.monotonic()
        try:
            play.all()
            next(iter(found)).do("write_coil", layout.END, True)
            code = running.ended()
        except Wrong as error:
            running.give_up(f"seed {seed}, operation {play.done}, {play.client.name}: {error}")
        finally:
            running.stop()
            for client in found:
                client.close()
    print(f"seed {seed}: {play.done} operations in {time.monotonic() - began:.1f} s, no wrong bit: {dict(play.counts)}")
    print(", ".join(f"{call} {count}" for call, count in play.calls.items()))
    print(f"{known.triggered} sets of inputs by the scenario; inputs looked at again: {play.waited} times; exit code {code}")
    if code != 0:
        sys.exit(1)
    if len(found) < 3:
        print(f"of pymodbus, modbus-serial and mbpoll only {', '.join(client.name for client in found)}: counts as skipped")
        sys.exit(77)


main()

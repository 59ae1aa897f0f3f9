"""A plant with known answers: its files, and a model of its four tables that follows every write.

Devices of two events each follow their operation at once; the other inputs change when the scenario sets them, one
set of values per trigger. All other coils and holding registers read back as written, symbol or gap.
"""
import json
import struct

COILS = INPUTS = 4096
HOLDING = 512
INPUT_REGISTERS = 500  # in the map; registers of the link may follow
KEPT = range(2000, 2128)  # the coils that only trigger, barrier and end write
BARRIER, END, FIRST_TRIGGER = 2000, 2001, 2008
STAMP = 499  # the input register that counts the triggers
TRIGGERS = KEPT.stop - FIRST_TRIGGER
FOLLOWERS, FREE_INPUTS, NUMBERS = 400, 200, 150
LINK_ORDER = "low-first"
WIDE_FROM = 300  # from this register on numbers of 32 and 64 bits
WIDE = {"D": {"DINT": "i", "UDINT": "I", "DWORD": "I", "REAL": "f"}, "L": {"LINT": "q", "ULINT": "Q", "LREAL": "d"}}


def registers_of(value, layout, order):
    """The words of a number of 32 or 64 bits."""
    data = struct.pack(">" + layout, value)
    words = list(struct.unpack(f">{len(data) // 2}H", data))
    return words if order == "high-first" else words[::-1]


class KnownPlant:
    """The plant of a seed, with the current expected tables."""

    def __init__(self, dice):
        self.coils, self.inputs = [0] * COILS, [0] * INPUTS
        self.holding, self.input_registers = [0] * HOLDING, [0] * INPUT_REGISTERS
        self.unsettled = set()  # inputs that may still have their old values
        self.triggered = 0
        self.rows = []
        places = dice.sample([place for place in range(INPUTS - 1)], 2 * FOLLOWERS + 2 + FREE_INPUTS)
        coils = [BARRIER, COILS - 1] + dice.sample([c for c in range(COILS - 1) if c not in KEPT], FOLLOWERS - 1)
        self.followers = {}
        for coil in coils:
            self.followers[coil] = (places.pop(), places.pop())
            self._device(coil, *self.followers[coil])
        self.free = {place: f"FREE_{place}" for place in [INPUTS - 1, *places]}
        for place, name in self.free.items():
            self._row(name, f"%IX{place}", "BOOL", "FALSE")
        for coil in [END, *range(FIRST_TRIGGER, KEPT.stop)]:
            self._row(f"KEPT_{coil}", f"%QX{coil}", "BOOL", "FALSE")
        self._numbers(dice)
        self.sets = [self._set(dice, number) for number in range(1, TRIGGERS + 1)]

    def _row(self, name, address, type_name, initial):
        self.rows.append(f"VAR_GLOBAL,{name},,{address},{type_name},{initial}")

    def _device(self, coil, on, off):
        self._row(f"F_S_D{coil}_O_ON", f"%QX{coil}", "BOOL", "FALSE")
        self._row(f"F_S_D{coil}_I_ON", f"%IX{on}", "BOOL", "FALSE")
        self._row(f"F_S_D{coil}_I_OFF", f"%IX{off}", "BOOL", "FALSE")
        self.inputs[off] = 1

    def _numbers(self, dice):
        for place in [HOLDING - 1, *dice.sample(range(WIDE_FROM), NUMBERS)]:
            self.holding[place] = self._number(dice, f"NUMBER_O_{place}", f"%QW{place}")
        self.moving = {}
        for place in [STAMP, *dice.sample(range(WIDE_FROM), NUMBERS)]:
            name = f"NUMBER_I_{place}"
            self.input_registers[place] = self._number(dice, name, f"%IW{place}", "WORD", 0 if place == STAMP else None)
            self.moving[place] = name
        self.wide, self.orders = [], []
        for size, numbers in (("D", range(WIDE_FROM // 2, 190)), ("L", range(96, 120))):
            for number in numbers:
                self._wide(dice, size, number, "Q", self.holding)
                self.wide.append(self._wide(dice, size, number, "I", self.input_registers))

    def _wide(self, dice, size, number, area, table):
        """A number of 32 (`D`) or 64 (`L`) bits; its name, layout, first register and word order."""
        type_name = dice.choice(list(WIDE[size]))
        layout, first = WIDE[size][type_name], number * (2 if size == "D" else 4)
        name = f"WIDE_{area}_{first}"
        value = self._value(dice, layout)
        self._row(name, f"%{area}{size}{number}", type_name, repr(value))
        order = dice.choice([LINK_ORDER, "high-first"])
        if order != LINK_ORDER:
            self.orders.append({"symbol": name, "word-order": order})
        words = registers_of(value, layout, order)
        table[first:first + len(words)] = words
        return name, layout, first, order

    @staticmethod
    def _value(dice, layout):
        if layout in "fd":
            return struct.unpack("<f", struct.pack("<f", dice.uniform(-1e6, 1e6)))[0]
        bits = 8 * struct.calcsize("<" + layout)
        return dice.randrange(-(1 << (bits - 1)), 1 << (bits - 1)) if layout.islower() else dice.randrange(1 << bits)

    def _number(self, dice, name, address, type_name=None, value=None):
        type_name = type_name or dice.choice(["WORD", "INT"])
        value = dice.randrange(65536) if value is None else value
        self._row(name, address, type_name, value - 65536 if type_name == "INT" and value > 32767 else value)
        return value

    def _set(self, dice, number):
        bits = {place: dice.randrange(2) for place in dice.sample(sorted(self.free), 20)}
        words = {place: dice.randrange(32768) for place in dice.sample(sorted(set(self.moving) - {STAMP}), 20)}
        wide = {which: self._value(dice, which[1]) for which in dice.sample(sorted(self.wide), 10)}
        return bits, {**words, STAMP: number}, wide

    def write_files(self, folder):
        """list.csv, plant.json and scenario.json; the arguments of `symplant run`."""
        header = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial"
        (folder / "list.csv").write_text("\n".join([header, *self.rows, ""]), encoding="utf-8")
        link = {"url": "modbus-tcp-server://127.0.0.1:0", "word-order": LINK_ORDER, "map": self.orders}
        plant = {"symplant": 1, "name": "known", "symbols": ["list.csv"], "defaults": {"travel": "0s", "dwell": "0s"},
                 "links": [link]}
        (folder / "plant.json").write_text(json.dumps(plant), encoding="utf-8")
        steps = []
        for number, (bits, words, wide) in enumerate(self.sets):
            values = {self.free[place]: bool(bit) for place, bit in bits.items()}
            values.update({self.moving[place]: word for place, word in words.items()})
            values.update({name: value if abs(value) < 1 << 53 else str(value) for (name, *_), value in wide.items()})
            steps += [{"wait": f"KEPT_{FIRST_TRIGGER + number}", "within": "10h"}, {"plus": "0s", "set": values}]
        steps.append({"wait": f"KEPT_{END}", "within": "10h"})
        (folder / "scenario.json").write_text(json.dumps({"symplant-scenario": 1, "steps": steps}), encoding="utf-8")
        return [str(folder / "plant.json"), "--scenario", str(folder / "scenario.json")]

    def write_coils(self, first, bits):
        for coil, bit in enumerate(bits, first):
            if coil in self.followers and self.coils[coil] != bit:
                on, off = self.followers[coil]
                self.inputs[on], self.inputs[off] = bit, 1 - bit
                self.unsettled.update((on, off))
            self.coils[coil] = bit

    def write_holding(self, first, words):
        self.holding[first:first + len(words)] = words

    def next_trigger(self):
        """The coil of the next trigger, which sets the inputs to these values; None if all are used."""
        if self.triggered == TRIGGERS:
            return None
        coil = FIRST_TRIGGER + self.triggered
        bits, words, wide = self.sets[self.triggered]
        self.triggered += 1
        for place, bit in bits.items():
            self.inputs[place] = bit
        for place, word in words.items():
            self.input_registers[place] = word
        for (_, layout, first, order), value in wide.items():
            words_of_it = registers_of(value, layout, order)
            self.input_registers[first:first + len(words_of_it)] = words_of_it
        return coil

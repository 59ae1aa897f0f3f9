#!/usr/bin/env python3
"""Independent check: pymodbus, a third-party Modbus client, on a plant with bits and numbers in all four tables.

usage: pymodbus_test.py SYMPLANT

Runs `symplant run` on a separate list in real time, on a free port of this machine. Exit code: 0 passed, 1 a check
failed, 77 pymodbus is not installed (skipped by ctest).
"""
import os
import pathlib
import random
import sys
import tempfile
import threading
import time

from running_plant import RunningPlant

LIST = """Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial
VAR_GLOBAL,L_P_CYL_O_ADV,Y0001,%QX1,BOOL,FALSE
VAR_GLOBAL,L_P_CYL_O_RET,Y0002,%QX2,BOOL,FALSE
VAR_GLOBAL,L_P_CYL_I_ADV,X0001,%IX1,BOOL,FALSE
VAR_GLOBAL,L_P_CYL_I_RET,X0002,%IX2,BOOL,TRUE
VAR_GLOBAL,L_P_SCALE_O_TARGET,,%QW4,WORD,0
VAR_GLOBAL,L_P_SCALE_O_OFFSET,,%QW5,INT,0
VAR_GLOBAL,L_P_SCALE_I_WEIGHT,,%IW4,INT,-5
VAR_GLOBAL,L_P_SCALE_I_STATUS,,%IW9,WORD,65534
VAR_GLOBAL,L_P_SCALE_I_TOTAL,,%ID6,DINT,70000
"""
ILLEGAL_FUNCTION, ILLEGAL_ADDRESS, ILLEGAL_VALUE = 1, 2, 3
SIZE = 16  # of each table: the highest number + 1, rounded up
STATUS = 100  # the input registers of the status block: the first multiple of 100 above the map
STATUS_SIZE = 12
HEARTBEAT, STATE, RUNNING = 1, 2, 1
failures = 0


def check(what, expected, seen):
    global failures
    if expected == seen:
        print("ok:", what)
    else:
        print(f"FAILED: {what}: expected {expected}, seen {seen}")
        failures += 1


def until(read, wanted):
    """Reads until the values are as wanted or 30 s are over: the speed of the machine is unknown."""
    end = time.monotonic() + 30
    seen = read()
    while seen != wanted and time.monotonic() < end:
        time.sleep(0.05)
        seen = read()
    return seen


def bits(answer, count):
    return "exception" if answer.isError() else [int(bit) for bit in answer.bits[:count]]


def registers(answer):
    return "exception" if answer.isError() else answer.registers


def exception(answer):
    return getattr(answer, "exception_code", None)


def check_tables(client):
    check("discrete inputs at the start: RET is on", [0, 0, 1, 0], bits(client.read_discrete_inputs(0, 4), 4))
    check("coils at the start are off", [0, 0, 0], bits(client.read_coils(0, 3), 3))
    check("input registers: INT as two's complement, WORD whole, DINT on two, in a list with MELSEC addresses the low word first, gaps 0",
          [0, 0, 0, 0, 0xFFFB, 0, 0, 0, 0, 65534, 0, 0, 70000 & 0xFFFF, 70000 >> 16, 0, 0],
          registers(client.read_input_registers(0, SIZE)))
    check("holding registers at the start", [0, 0], registers(client.read_holding_registers(4, 2)))


def check_writes(client):
    check("writing one coil is answered", False, client.write_coil(1, True).isError())
    check("it reads back", [0, 1, 0], bits(client.read_coils(0, 3), 3))
    check("the cylinder comes to ADV", [1, 0], until(lambda: bits(client.read_discrete_inputs(1, 2), 2), [1, 0]))
    check("writing coils is answered", False, client.write_coils(1, [False, True]).isError())
    check("the cylinder goes back", [0, 1], until(lambda: bits(client.read_discrete_inputs(1, 2), 2), [0, 1]))
    check("writing one register is answered", False, client.write_register(4, 0xABCD).isError())
    check("it reads back", [0xABCD, 0], registers(client.read_holding_registers(4, 2)))
    check("writing registers is answered", False, client.write_registers(4, [1, 0x8000]).isError())
    check("they read back", [1, 0x8000], registers(client.read_holding_registers(4, 2)))
    check("a gap keeps what is written to it", False, client.write_register(15, 7).isError())
    check("and reads it back", [7], registers(client.read_holding_registers(15, 1)))


def check_status(client):
    def status(word):
        return registers(client.read_input_registers(STATUS, STATUS_SIZE))[word]

    check("the status block begins with its version", 1, status(0))
    check("it says that the link is used and the plant runs", RUNNING, until(lambda: status(STATE), RUNNING))
    first = status(HEARTBEAT)
    check("its heartbeat goes on", True, until(lambda: status(HEARTBEAT) != first, True))


def check_exceptions(client):
    from pymodbus.other_message import ReportSlaveIdRequest
    for what, read, size in (("coils", client.read_coils, SIZE), ("discrete inputs", client.read_discrete_inputs, SIZE),
                             ("holding registers", client.read_holding_registers, SIZE),
                             ("input registers", client.read_input_registers, STATUS + STATUS_SIZE)):
        check(f"{what}: the last place is there", False, read(size - 1, 1).isError())
        check(f"{what}: beyond it is an illegal address", ILLEGAL_ADDRESS, exception(read(size, 1)))
        check(f"{what}: across the end likewise", ILLEGAL_ADDRESS, exception(read(size - 1, 2)))
        check(f"{what}: nor at the end of all numbers", ILLEGAL_ADDRESS, exception(read(65535, 1)))
    before = registers(client.read_holding_registers(0, SIZE))
    for what, answer in (("a coil", client.write_coil(SIZE, True)), ("coils", client.write_coils(SIZE - 1, [True, True])),
                         ("a register", client.write_register(SIZE, 9)),
                         ("registers", client.write_registers(SIZE - 2, [9, 9, 9]))):
        check(f"writing {what} beyond the end is an illegal address", ILLEGAL_ADDRESS, exception(answer))
    check("and nothing of it is written", before, registers(client.read_holding_registers(0, SIZE)))
    answer = client.readwrite_registers(read_address=0, read_count=1, write_address=SIZE, write_registers=[1])
    check("reading and writing with an illegal address", ILLEGAL_ADDRESS, exception(answer))
    answer = client.execute(ReportSlaveIdRequest(unit=1))
    check("a function that is not served is an illegal function", ILLEGAL_FUNCTION, exception(answer))
    check("too many registers are an illegal value", ILLEGAL_VALUE, exception(client.read_holding_registers(0, 126)))


def check_many(port, client_of):
    """Several clients at once: each reads back what it wrote to its own addresses, in whole words."""
    wrong = []

    def work(place, seed):
        dice = random.Random(seed)
        with client_of(port) as client:
            for _ in range(200):
                value = dice.randrange(65536)
                client.write_register(place, value)
                seen = registers(client.read_holding_registers(place, 1))
                if seen != [value]:
                    wrong.append((place, value, seen))

    threads = [threading.Thread(target=work, args=(6 + i, i)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    check("eight clients at once each read what they wrote", [], wrong[:3])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        from pymodbus.client import ModbusTcpClient
    except ImportError:
        print("python3-pymodbus is not installed: skipped")
        sys.exit(77)

    def client_of(port):
        return ModbusTcpClient("127.0.0.1", port=port, timeout=10)

    with tempfile.TemporaryDirectory() as folder:
        numbers = pathlib.Path(folder) / "numbers.csv"
        numbers.write_text(LIST, encoding="utf-8")
        plant = RunningPlant([os.path.abspath(sys.argv[1]), "run", str(numbers)], folder)
        try:
            with client_of(plant.port) as client:
                check_tables(client)
                check_writes(client)
                check_status(client)
                check_exceptions(client)
            check_many(plant.port, client_of)
        finally:
            code = plant.stop()
        check("the plant ends well on SIGTERM", 0, code)
    sys.exit(1 if failures else 0)


main()

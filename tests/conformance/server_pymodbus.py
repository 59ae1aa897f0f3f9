#!/usr/bin/env python3
"""A simple server made with pymodbus, for comparison. Exit code 77: pymodbus is not installed."""
import logging
import socket
import sys
import threading
import time

try:
    import pymodbus
    from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
    from pymodbus.device import ModbusDeviceIdentification
    from pymodbus.server import StartTcpServer
except ImportError:
    sys.exit(77)

BITS, REGISTERS = 2016, 160


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def main():
    logging.disable(logging.CRITICAL)
    slave = ModbusSlaveContext(
        co=ModbusSequentialDataBlock(0, [False] * BITS),
        di=ModbusSequentialDataBlock(0, [i % 5 < 2 for i in range(BITS)]),
        hr=ModbusSequentialDataBlock(0, [0] * REGISTERS),
        ir=ModbusSequentialDataBlock(0, [0xF000 + i for i in range(REGISTERS)]),
        zero_mode=True)
    identity = ModbusDeviceIdentification(
        info_name={"VendorName": "pymodbus", "ProductCode": "plain", "MajorMinorRevision": "1.0"})
    port = free_port()
    arguments = {"context": ModbusServerContext(slaves=slave, single=True), "identity": identity,
                 "address": ("127.0.0.1", port)}
    server = threading.Thread(target=StartTcpServer, kwargs=arguments, daemon=True)
    server.start()
    while server.is_alive():
        with socket.socket() as client:
            if client.connect_ex(("127.0.0.1", port)) == 0:
                break
        time.sleep(0.05)
    print(port, BITS, BITS, REGISTERS, REGISTERS, "pymodbus", pymodbus.__version__, flush=True)
    server.join()


main()

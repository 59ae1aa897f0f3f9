"""Three third-party Modbus clients with one interface: do(call, argument...) returns values, the echo, or Refused."""
import json
import re
import subprocess

from pymodbus.client import ModbusTcpClient


class Refused:
    """An exception of the protocol, by its code."""

    def __init__(self, code):
        self.code = code

    def __eq__(self, other):
        return isinstance(other, Refused) and other.code == self.code

    def __repr__(self):
        return f"exception {self.code}"


class Pymodbus:
    name = "pymodbus"

    def __init__(self, port):
        self.client = ModbusTcpClient("127.0.0.1", port=port, timeout=20)
        self.client.connect()

    def do(self, call, *args):
        if call == "readwrite_registers":
            read_first, count, write_first, words = args
            answer = self.client.readwrite_registers(read_address=read_first, read_count=count, write_address=write_first,
                                                     write_registers=words)
        elif call == "mask_write_register":
            answer = self.client.mask_write_register(address=args[0], and_mask=args[1], or_mask=args[2])
        else:
            answer = getattr(self.client, call)(*args)
        if answer.isError():
            if hasattr(answer, "exception_code"):
                return Refused(answer.exception_code)
            raise RuntimeError(f"pymodbus: {answer}")
        if call in ("read_coils", "read_discrete_inputs"):
            return [int(bit) for bit in answer.bits[:args[1]]]
        if call in ("read_holding_registers", "read_input_registers", "readwrite_registers"):
            return answer.registers
        if call == "mask_write_register":
            return [answer.address, answer.and_mask, answer.or_mask]
        return [answer.address, int(answer.value if call in ("write_coil", "write_register") else answer.count)]

    def close(self):
        self.client.close()


class ModbusSerial:
    """npm's modbus-serial, in a separate process that serves calls."""

    name = "modbus-serial"
    METHODS = {"read_coils": "readCoils", "read_discrete_inputs": "readDiscreteInputs",
               "read_holding_registers": "readHoldingRegisters", "read_input_registers": "readInputRegisters",
               "write_coil": "writeCoil", "write_coils": "writeCoils", "write_register": "writeRegister",
               "write_registers": "writeRegisters", "mask_write_register": "maskWriteRegister",
               "readwrite_registers": "readWriteRegisters"}
    ECHOES = {"write_coil": ("address", "state"), "write_coils": ("address", "length"), "write_register": ("address", "value"),
              "write_registers": ("address", "length"), "mask_write_register": ("address", "andMask", "orMask")}

    def __init__(self, script, packages, port):
        self.process = subprocess.Popen(["node", script, packages, str(port)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)

    def do(self, call, *args):
        if call == "readwrite_registers":
            args = [args[0], args[1], args[2], len(args[3]), args[3]]
        self.process.stdin.write(json.dumps([self.METHODS[call], *args]) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        answer = json.loads(line) if line else {"error": f"ended with exit code {self.process.wait(timeout=20)}"}
        if "exception" in answer:
            return Refused(answer["exception"])
        if "error" in answer:
            raise RuntimeError(f"modbus-serial: {answer['error']}")
        if call in self.ECHOES:
            return [int(answer["value"][key]) for key in self.ECHOES[call]]
        return [int(value) for value in answer["value"]["data"][:args[1]]]

    def close(self):
        self.process.kill()
        self.process.communicate()


class Mbpoll:
    """mbpoll, with libmodbus: one process per call, at most 125 addresses."""

    name = "mbpoll"
    TABLES = {"read_coils": "0", "write_coil": "0", "write_coils": "0", "read_discrete_inputs": "1",
              "read_input_registers": "3", "read_holding_registers": "4", "write_register": "4", "write_registers": "4"}
    MOST = 125

    def __init__(self, port):
        self.command = ["mbpoll", "-m", "tcp", "-p", str(port), "-0", "-1", "-o", "10"]

    def do(self, call, *args):
        table, values = ["-t", self.TABLES[call], "-r", str(args[0])], []
        if call.startswith("read_"):
            table += ["-c", str(args[1])]
        else:
            values = ["--", *map(str, map(int, args[1] if isinstance(args[1], list) else [args[1]]))]
        done = subprocess.run([*self.command, *table, "127.0.0.1", *values], capture_output=True, text=True, timeout=60,
                              check=False)
        if "Illegal data address" in done.stdout + done.stderr:
            return Refused(2)
        if done.returncode != 0:
            raise RuntimeError(f"mbpoll: {done.stdout}{done.stderr}")
        if values:
            written = int(re.search(r"Written (\d+) references", done.stdout).group(1))
            return [args[0], written] if isinstance(args[1], list) else [args[0], int(args[1])]
        seen = re.findall(r"^\[(\d+)\]:\s+(-?\d+)", done.stdout, re.MULTILINE)
        if [int(place) for place, _ in seen] != list(range(args[0], args[0] + args[1])):
            raise RuntimeError(f"mbpoll shows other places than were asked for: {done.stdout}")
        return [int(value) % 65536 for _, value in seen]

    def close(self):
        pass

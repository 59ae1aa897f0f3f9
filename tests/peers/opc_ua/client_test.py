#!/usr/bin/env python3
"""The link `opc-ua` with a PLC that is made of npm's node-opcua: the cell runs, the PLC is killed and comes back; all data
types, limits of the server, wrong nodes; certificates, users and what the link says if the server refuses them.

usage: client_test.py SYMPLANT SOURCE PACKAGES

SOURCE is the project's folder, PACKAGES that of node-opcua, existing or new. Exit code: 0 passed, 1 a check failed, 77 node or
node-opcua is not available.
"""
import csv
import json
import pathlib
import queue
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = "node-opcua@2.186.4"
# By type of a symbol: that of its node, a value of an operation as JavaScript writes it, and as the doctor reports it.
TYPES = {"BOOL": ("Boolean", True, 1), "SINT": ("SByte", -5, -5), "USINT": ("Byte", 200, 200), "BYTE": ("Byte", 129, 129),
         "INT": ("Int16", -300, -300), "UINT": ("UInt16", 60000, 60000), "WORD": ("UInt16", 43981, 43981),
         "DINT": ("Int32", -70000, -70000), "UDINT": ("UInt32", 4000000000, 4000000000),
         "DWORD": ("UInt32", 3735928559, 3735928559), "LINT": ("Int64", [0xFFFFFFFF, 0xFFFFFFFE], -2),
         "ULINT": ("UInt64", [1, 5], 4294967301), "LWORD": ("UInt64", [0, 7], 7), "REAL": ("Float", 1.5, 1.5),
         "LREAL": ("Double", -0.1, -0.1)}


class Failed(Exception):
    """A check failed."""


def check(is_true, what):
    if not is_true:
        raise Failed(what)


class Plc:
    """plc.js with these settings; port 0 is any free one."""

    def __init__(self, packages, folder, **settings):
        settings = {"port": 0, "folder": str(folder), **settings}
        # The port of a PLC that is killed must be free for the next one, so node-opcua does not choose it.
        if settings["port"] == 0:
            settings["port"] = free_port()
        with open(folder / "plc.log", "a", encoding="utf-8") as log:
            self.process = subprocess.Popen(["node", str(HERE / "plc.js"), str(packages), json.dumps(settings)], text=True,
                                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log)
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()
        try:
            self.port = self.wait("port")
        except Failed as failed:
            self.kill()
            raise Failed(f"{failed}: {(folder / 'plc.log').read_text(encoding='utf-8')[:2000]}") from None

    def read(self):
        for line in self.process.stdout:
            if line.startswith("{"):
                self.lines.put(json.loads(line))
        self.lines.put(None)

    def wait(self, key, seconds=60):
        """The next value that the PLC reports under this key."""
        end = time.monotonic() + seconds
        while True:
            try:
                line = self.lines.get(timeout=max(end - time.monotonic(), 0.01))
            except queue.Empty:
                raise Failed(f"the PLC reports no {key} within {seconds} s") from None
            if line is None:
                raise Failed(f"the PLC has ended before it reported {key}")
            if key in line:
                return line[key]

    def kill(self):
        self.process.kill()
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()


def free_port():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


class Run:
    """`symplant run` in the background."""

    def __init__(self, arguments, folder):
        self.path = folder / "run.log"
        with open(self.path, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(arguments, stdout=log, stderr=subprocess.STDOUT)

    def says(self):
        return self.path.read_text(encoding="utf-8")

    def wait_for(self, pattern, seconds=30):
        end = time.monotonic() + seconds
        while time.monotonic() < end and self.process.poll() is None:
            if re.search(pattern, self.says()):
                return
            time.sleep(0.1)
        raise Failed(f"the run does not say {pattern!r}, but:\n{self.says()}")

    def end(self):
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(timeout=30)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()


class Test:
    def __init__(self, symplant, source, packages):
        self.symplant = symplant
        self.cell = pathlib.Path(source) / "examples" / "cell"
        self.packages = packages

    def cell_variables(self):
        with open(self.cell / "symbols.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        return [{"name": row["Identifier"], "type": "Boolean", "writes": row["IEC-Addr."].startswith("%I")} for row in rows]

    def doctor(self, plant, link, *more):
        """The steps of the report by name, the points by symbol, and the exit code."""
        done = subprocess.run([self.symplant, "doctor", str(plant), "--for", "200ms", "--all", "--format", "json", *more,
                               "--link", link], capture_output=True, text=True, check=False, timeout=120)
        if done.returncode == 2:
            return {"usage": done.stderr}, {}
        check(done.returncode in (0, 1, 3), f"doctor ends with {done.returncode}: {done.stderr}")
        report = json.loads(done.stdout)
        return ({step["step"]: step for step in report["steps"]}, {point["symbol"]: point for point in report["points"]})

    def the_cell_runs(self, folder):
        """A round; the PLC is killed in the next one and comes back; another round."""
        plant = str(self.cell / "plant.json")
        plc = Plc(self.packages, folder, variables=self.cell_variables(), cell=True)
        link = f"opc-ua://127.0.0.1:{plc.port}?nodes=s7"
        with Run([self.symplant, "run", plant, "--arm", "--trace", str(folder / "run.jsonl"), "--link", link], folder) as run:
            with plc:
                record = subprocess.Popen([self.symplant, "record", plant, "-o", str(folder / "plant.jsonl"), "--until", "4s",
                                           "--link", link])
                watch = subprocess.run([self.symplant, "watch", plant, "--until", "3s", "--link", link], capture_output=True,
                                       text=True, check=False, timeout=60)
                check(watch.returncode in (0, 1), f"watch ends with {watch.returncode}: {watch.stdout}{watch.stderr}")
                check(record.wait(timeout=60) == 0, "record fails")
                check(plc.wait("round") == 1, "the first round")
                check(plc.wait("state") == "toMachine", "the second round begins")
            run.wait_for("connection lost|does not answer any more")
            with Plc(self.packages, folder, variables=self.cell_variables(), cell=True, port=plc.port) as again:
                check(again.wait("round") == 1, "a round after the restart")
            code = run.end()
            said = run.says()
        check(code == 0, f"the run ends with {code}:\n{said}")
        for words in (r"connected, armed: the server is `small PLC, tests, cell controller, 1\.2`; it has the nodes of 7 of 7 "
                      r"operations and 11 of 11 events", r"lost [1-9]\d* time", r"requirements: 2 held, 0 violated"):
            check(re.search(words, said), f"the run does not say {words!r}, but:\n{said}")
        recorded = (folder / "plant.jsonl").read_text(encoding="utf-8")
        check("EXLINE_MB_AGV_O_P2" in recorded and "EXLINE_MB_AGV_I_P1" in recorded, "the recording lacks symbols")

    def all_types(self, folder):
        """Every type is read and written, three nodes in a request at most."""
        rows = ["Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial"]
        variables, known = [], {}
        for number, (name, (node, value, shown)) in enumerate(TYPES.items()):
            size = {"BOOL": "X", "SINT": "B", "USINT": "B", "BYTE": "B"}.get(name, "W")
            rows += [f"VAR_GLOBAL,L_P_{name}_O_A,,%Q{size}{4 * number},{name},0",
                     f"VAR_GLOBAL,L_P_{name}_I_A,,%I{size}{4 * number},{name},0"]
            variables += [{"name": f"L_P_{name}_O_A", "type": node, "initial": value},
                          {"name": f"L_P_{name}_I_A", "type": node, "writes": True}]
            known[f"L_P_{name}_O_A"] = shown
        plant = folder / "types.csv"
        plant.write_text("\n".join(rows) + "\n", encoding="utf-8")
        with Plc(self.packages, folder, variables=variables, limit=3) as plc:
            steps, points = self.doctor(plant, f"opc-ua://127.0.0.1:{plc.port}?nodes=s7", "--write-test")
        count = len(TYPES)
        for step, words in (("reading", f"{2 * count} points"), ("write test", f"{count} events of {count} written"),
                            ("functions", "reads 3 nodes in a request, and writes 3")):
            check(words in steps[step]["text"], f"{step}: {steps[step]}")
        for name, value in known.items():
            check(points[name]["value"] == value, f"{name} is {points[name]}, not {value}")

    def wrong_nodes(self, folder):
        """A missing node, a wrong type, an event that cannot be written; the rest is exchanged."""
        variables = self.cell_variables()
        variables = [v for v in variables if v["name"] != "EXLINE_MB_AGV_O_PUSH"]
        for variable in variables:
            if variable["name"] == "EXLINE_MB_AGV_O_CHARGE":
                variable["type"] = "Int16"
            if variable["name"] == "EXLINE_MB_AGV_I_P2":
                variable["writes"] = False
        with Plc(self.packages, folder, variables=variables) as plc:
            steps, points = self.doctor(self.cell / "plant.json",
                                        f"opc-ua://127.0.0.1:{plc.port}?nodes=ns=3;s=\"{{symbol}}\"")
            words = steps["reading"]["text"]
            check("5 of 7 operations and 10 of 11 events" in steps["identity"]["text"], steps["identity"])
            for part in ('1 operation is not read: `EXLINE_MB_AGV_O_PUSH` (ns=3;s="EXLINE_MB_AGV_O_PUSH"): BadNodeIdUnknown',
                         "the symbol is BOOL, which is Boolean, the node is Int16): BadTypeMismatch",
                         '1 event is not written: `EXLINE_MB_AGV_I_P2` (ns=3;s="EXLINE_MB_AGV_I_P2"): BadNotWritable'):
                check(part in words, f"{part!r} is not in {words!r}")
            check(points["EXLINE_MB_AGV_O_P1"]["value"] == 0, points["EXLINE_MB_AGV_O_P1"])

    def security(self, folder):
        """Encryption with a user, and each way in which it fails."""
        (folder / "password").write_text("secret\n", encoding="utf-8")
        (folder / "wrong").write_text("guess\n", encoding="utf-8")
        trust = folder / "trust"
        trust.mkdir()
        plant = self.cell / "plant.json"
        with Plc(self.packages, folder, variables=self.cell_variables(), security=True) as plc:
            base = f"opc-ua://127.0.0.1:{plc.port}?nodes=s7"

            def connection(more, step="connection"):
                steps, _ = self.doctor(plant, base + more)
                return steps[step]["text"] if step in steps else str(steps)

            user = f"&user=plant&password-file={folder}/"
            text = connection("&security=encrypt" + user + "password", "identity")
            check("was accepted without a check" in text and "SHA-1 " in text, text)
            text = connection("")
            check("does not offer `security=none`; it offers: encrypt with Basic256Sha256" in text, text)
            text = connection("&security=encrypt")
            check("does not take a client without a user" in text, text)
            text = connection("&security=encrypt" + user + "wrong")
            check("password" in text and ("BadUserAccessDenied" in text or "BadIdentityTokenRejected" in text), text)
            check("variable" not in text, text)
            own = next((folder / "pki" / "own" / "certs").iterdir())
            steps, _ = self.doctor(plant, base + "&security=encrypt" + user + f"password&trust={trust}")
            check("no file" in steps.get("usage", ""), steps)
            shutil.copy(own, trust / "plc.pem")
            text = connection("&security=encrypt" + user + f"password&trust={trust}", "identity")
            check("is trusted" in text, text)
        with Plc(self.packages, folder / "strict", variables=[], security=True, strict=True) as plc:
            steps, _ = self.doctor(plant, f"opc-ua://127.0.0.1:{plc.port}?nodes=s7&security=encrypt{user}password")
            text = steps["connection"]["text"]
            check("trust the certificate of this link in the server" in text and "SHA-1 " in text, text)
            steps, _ = self.doctor(plant, f"opc-ua://127.0.0.1:{plc.port}?nodes=s7&security=encrypt{user}password&trust={trust}")
            check("is not in the folder" in steps["connection"]["text"], steps["connection"])


def main():
    if len(sys.argv) != 4:
        print(__doc__)
        return 2
    symplant, source, packages = sys.argv[1:]
    if shutil.which("node") is None:
        print("node is not installed")
        return 77
    fetched = subprocess.run(["bash", str(HERE.parent / "npm_package.sh"), packages, PACKAGE], check=False).returncode
    if fetched != 0:
        return fetched
    test = Test(symplant, source, packages)
    for part in (test.security, test.all_types, test.wrong_nodes, test.the_cell_runs):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "strict").mkdir()
            try:
                part(pathlib.Path(folder))
            except Failed as failed:
                print(f"FAILED: {part.__name__}: {failed}")
                return 1
        print("good:", part.__doc__)
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""A plant that runs during a test: started as a Modbus TCP server on a free port, ended at the end of the test."""
import pathlib
import re
import signal
import subprocess
import sys
import time


class RunningPlant:
    """`command` with a link on 127.0.0.1; its output goes to `log` in `folder`. `port` is its port."""

    def __init__(self, command, folder):
        self.path = pathlib.Path(folder) / "log"
        with open(self.path, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen([*command, "--link", "modbus-tcp-server://127.0.0.1:0"], stdout=log,
                                            stderr=subprocess.STDOUT)
        end = time.monotonic() + 60
        while time.monotonic() < end and self.process.poll() is None:
            said = re.search(r"^link modbus-tcp-server://127\.0\.0\.1:(\d+)(;.*)?$", self.says(), re.MULTILINE)
            if said:
                self.port = int(said.group(1))
                return
            time.sleep(0.05)
        self.give_up("the plant does not say where it listens")

    def says(self):
        return self.path.read_text(encoding="utf-8")

    def give_up(self, what):
        self.stop()
        said = self.says()
        print(f"FAILED: {what}; the plant said:\n{said[max(0, said.find('plant ')):][:1500]}")
        sys.exit(1)

    def stop(self):
        """Ends it by SIGTERM if it still runs; returns the exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        return self.ended()

    def ended(self):
        """Waits for its end, half a minute at most; returns the exit code."""
        try:
            return self.process.wait(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()

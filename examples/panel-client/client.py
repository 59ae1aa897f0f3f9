#!/usr/bin/env python3
"""Drives the cell through the panel's interface: the vehicle goes to P2, the machine runs, a sensor fails, and all is undone.

Usage: client.py LINK        the link that `symplant run examples/excell/excell.csv --panel` prints
"""
import json
import sys
import urllib.request


class Panel:
    def __init__(self, link):
        self.address, token = link.split("/#token=")
        self.headers = {"Authorization": "Bearer " + token, "Content-Type": "application/json"}
        self.plant = self.get("plant")
        self.headers["X-Symplant-Run"] = self.plant["run"]
        self.symbol = {symbol["name"]: i for i, symbol in enumerate(self.plant["symbols"])}

    def request(self, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        return urllib.request.urlopen(urllib.request.Request(self.address + "/api/v1/" + path, data, self.headers))

    def get(self, path):
        return json.load(self.request(path))

    def act(self, *acts):
        """Does acts in one instant; its plant time in ns."""
        return json.load(self.request("acts", {"acts": list(acts)}))["t"]

    def wait_for(self, symbol, value):
        """Follows the stream until a symbol has a value; the plant time in ns at which it got it."""
        index = self.symbol[symbol]
        for line in self.request("stream"):
            if not line.startswith(b"data: "):
                continue
            event = json.loads(line[6:])
            entries = event.get("symbols", [])
            if entries and len(entries[0]) == 3:  # a picture has all symbols, in order
                entries = [[i] + entry for i, entry in enumerate(entries)]
            for at, now, _, since in entries:
                if at == index and now == value:
                    return since


def main():
    panel = Panel(sys.argv[1])
    begun = panel.act({"set": {"EXLINE_MB_AGV_O_P2": True}})
    arrived = panel.wait_for("EXLINE_MB_AGV_I_P2", True)
    print(f"the vehicle is in P2 after {(arrived - begun) / 1e9:.1f} s")
    panel.act({"freeze": True}, {"snapshot": "before the fault"})
    panel.act({"force": {"EXLINE_MB_AGV_I_P2": False}})
    print(panel.get("why?name=EXLINE_MB_AGV_I_P2")["text"].splitlines()[0])
    panel.act({"restore": "before the fault"}, {"run": True})
    print("restored:", panel.get("picture")["symbols"][panel.symbol["EXLINE_MB_AGV_I_P2"]][0])


if __name__ == "__main__":
    main()

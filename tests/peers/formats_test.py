#!/usr/bin/env python3
"""Independent check of `symplant check --format sarif|junit`: the schema of SARIF 2.1.0, and Python's own XML reader.

usage: formats_test.py SYMPLANT SOURCE_DIR SCHEMA

SCHEMA is the path of the schema, or the target of sarif_schema.sh. Checks all goldens of `check`, one by one and all in
one run, the examples, and a list and a folder of hostile names. Exit code: 0 passed, 1 a check failed, 77 the schema is not
available, or jsonschema is not installed (skipped by ctest).
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

HOSTILE_NAMES = ["</testcase>", "]]>", "]](1)", "[x](http://y)", "{0}", "{{0}}", "%n%s", "a\\", "`", "'\"", "*/", "{{x}}",
                 "&amp;", "\u202eABC", "\u200b", "\u2028", "\ufffe", "\x01", "클램프_전진", "😀", "x" * 20000, "NULL", "-->"]


def fail(what):
    print("FAILED:", what)
    sys.exit(1)


def run(symplant, arguments, folder=None):
    done = subprocess.run([symplant, "check", *arguments], cwd=folder, capture_output=True, check=False)
    if done.returncode not in (0, 1, 2):
        fail(f"{arguments}: exit code {done.returncode}, {done.stderr.decode(errors='replace')}")
    return done.returncode, done.stdout


def check_sarif(validator, symplant, plants, folder=None):
    code, text = run(symplant, ["--format", "sarif", *plants], folder)
    log = json.loads(text.decode("utf-8"))
    errors = [f"{list(error.absolute_path)}: {error.message[:200]}" for error in validator.iter_errors(log)]
    if errors:
        fail(f"{plants}: not SARIF 2.1.0: {errors[:5]}")
    (only,) = log["runs"]
    rules = only["tool"]["driver"]["rules"]
    if only["invocations"][0]["exitCode"] != code:
        fail(f"{plants}: the log says another exit code than {code}")
    seen = set()
    for result in only["results"]:
        if rules[result["ruleIndex"]]["id"] != result["ruleId"]:
            fail(f"{plants}: a rule's place is wrong: {result}")
        (location,) = result["locations"]
        uri = location["physicalLocation"]["artifactLocation"]["uri"]
        if not re.fullmatch(r"(file:///)?([A-Za-z0-9._~/-]|%[0-9A-F]{2})+", uri):
            fail(f"{plants}: no URI: {uri}")
        fingerprint = result["partialFingerprints"]["primaryLocationLineHash"]
        if fingerprint in seen:
            fail(f"{plants}: two results of one fingerprint: {result}")
        seen.add(fingerprint)
    return len(only["results"])


def check_junit(symplant, plants, folder=None):
    for fail_on in ("error", "note"):
        code, text = run(symplant, ["--format", "junit", "--fail-on", fail_on, *plants], folder)
        suites = ElementTree.fromstring(text)
        if [suite.get("name") for suite in suites] != plants and folder is None:
            fail(f"{plants}: the suites are {[suite.get('name') for suite in suites]}")
        for element in [suites, *suites]:
            cases = list(element.iter("testcase"))
            counts = {"tests": len(cases)}
            for kind, tag in (("failures", "failure"), ("errors", "error"), ("skipped", "skipped")):
                counts[kind] = sum(1 for case in cases if case.find(tag) is not None)
            if any(int(element.get(kind)) != count for kind, count in counts.items()):
                fail(f"{plants}: counts {element.attrib} are not {counts}")
            names = [(case.get("classname"), case.get("name")) for case in cases]
            if len(set(names)) != len(names):
                fail(f"{plants}: two tests of one name")
        failed = int(suites.get("failures")) + int(suites.get("errors"))
        if (failed != 0) != (code != 0):
            fail(f"{plants}: {failed} tests fail, and the exit code is {code}")


def hostile_folder(folder):
    rows = ["Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial"]
    for number, name in enumerate(HOSTILE_NAMES):
        for text in (name, f"L_P_D_I_{name}", f"L_P_{name}_O_A"):
            cell = '"' + text.replace('"', '""') + '"'
            rows.append(f"VAR_GLOBAL,{cell},X{number:X},,BOOL,")
    name = "a b%20#?]](1){0}&<'\".csv"
    (folder / name).write_text("\n".join(rows) + "\n", encoding="utf-8")
    description = {"symplant": 1, "name": "</testsuite>]](1)", "symbols": [name],
                   "check": {"ignore": [{"rule": "illegal-character", "why": "]]> </skipped> [x](1) {0} \u202e"}]}}
    (folder / "hostile.json").write_text(json.dumps(description), encoding="utf-8")
    (folder / "no list.csv").write_bytes(b"\xff\xfe\x00")
    return [name, "hostile.json", "no list.csv", "missing\n.csv", "</a>.csv"]


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    symplant, source, schema = (os.path.abspath(argument) for argument in sys.argv[1:])
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed: skipped")
        sys.exit(77)
    fetched = subprocess.run([pathlib.Path(__file__).parent / "sarif_schema.sh", schema], check=False)
    if fetched.returncode != 0:
        sys.exit(fetched.returncode)
    schema = json.loads(pathlib.Path(schema).read_text(encoding="utf-8-sig"))
    validator = jsonschema.validators.validator_for(schema)(schema)
    if validator.is_valid({"version": "2.1.0", "runs": [{"results": "none"}]}):
        fail("the schema takes what is no SARIF")

    goldens = pathlib.Path(source) / "tests/golden/check"
    plants = [str(golden / ("plant.json" if (golden / "plant.json").exists() else "symbols.csv"))
              for golden in sorted(goldens.iterdir()) if golden.is_dir()]
    plants += [str(path) for path in sorted((pathlib.Path(source) / "examples").glob("**/plant.json"))]
    plants.append(str(pathlib.Path(source) / "examples/excell/excell.csv"))
    results = 0
    for chosen in [[plant] for plant in plants] + [plants]:
        results += check_sarif(validator, symplant, chosen)
        check_junit(symplant, chosen)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        hostile = hostile_folder(folder)
        for chosen in [[plant] for plant in hostile] + [hostile]:
            results += check_sarif(validator, symplant, chosen, folder)
            check_junit(symplant, chosen, folder)
    print(f"ok: {len(plants)} plants and {len(hostile)} hostile ones, {results} results")


main()

"""Random documents get the same verdict from symplant's validator and from python3-jsonschema.

usage: schema_test.py SCHEMA_VERDICTS COUNT SCHEMA...    COUNT: documents for each schema
"""
import json
import random
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: skipped")
    sys.exit(77)

OTHERS = [None, True, False, 0, 1, -1, 7, 0.5, 0.25, "", "A", "ä", "500ms", "LONG" * 9, [], {}, ["A"], {"a": 1}]


class Maker:
    """Makes documents that a schema accepts, or nearly."""

    def __init__(self, root, dice):
        self.root = root
        self.dice = dice
        self.wrong = 0.0

    def resolved(self, schema):
        while isinstance(schema, dict) and "$ref" in schema:
            target = self.root
            for part in schema["$ref"].lstrip("#/").split("/"):
                target = target[part] if part else target
            schema = target
        return schema

    def value(self, schema, depth=0):
        dice = self.dice
        schema = self.resolved(schema)
        if not isinstance(schema, dict) or dice.random() < self.wrong or depth > 12:
            return dice.choice(OTHERS)
        if "anyOf" in schema:
            return self.value(dice.choice(schema["anyOf"]), depth)
        if "const" in schema:
            return schema["const"]
        if "enum" in schema:
            return dice.choice(schema["enum"])
        kind = schema.get("type", "object" if "properties" in schema else None)
        kind = dice.choice(kind) if isinstance(kind, list) else kind
        if kind == "object":
            return self.members(schema, depth)
        if kind == "array":
            count = dice.randint(schema.get("minItems", 0), min(schema.get("maxItems", 3), 3))
            more = dice.random() < 5 * self.wrong
            return [self.value(schema.get("items", True), depth + 1) for _ in range(count + more)]
        if kind == "string":
            return "ABCDEFGHIJKLMNOPQRST"[: max(schema.get("minLength", 0), dice.randint(0, schema.get("maxLength", 5)))]
        if kind in ("integer", "number"):
            low, high = schema.get("minimum", -5), schema.get("maximum", 100)
            outside = [low - 1, high + 1] if dice.random() < self.wrong else []
            return dice.choice([low, high, dice.randint(int(low), int(high))] + outside)
        return {"boolean": dice.random() < 0.5, "null": None}.get(kind, dice.choice(OTHERS))

    def members(self, schema, depth):
        dice = self.dice
        known = schema.get("properties", {})
        result = {}
        for key, member in known.items():
            if member is False and dice.random() >= self.wrong:
                continue
            needed = key in schema.get("required", [])
            if (needed and dice.random() >= self.wrong) or (not needed and dice.random() < (0.5 if depth < 2 else 0.2)):
                result[key] = self.value(member, depth + 1)
        others = schema.get("additionalProperties", True)
        if others is not False or dice.random() < self.wrong:
            for _ in range(dice.randint(0, 2)):
                result["K" + str(dice.randint(0, 99))] = self.value(others, depth + 1)
        return result


def main():
    tool, count, schemas = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    differences = 0
    for path in schemas:
        with open(path, encoding="utf-8") as file:
            schema = json.load(file)
        judge = jsonschema.Draft7Validator(schema)
        maker = Maker(schema, random.Random(1))
        documents = []
        for _ in range(count):
            maker.wrong = maker.dice.choice([0.0, 0.0, 0.02, 0.05, 0.3])
            documents.append(maker.value(schema))
        lines = "".join(json.dumps(document) + "\n" for document in documents)
        answer = subprocess.run([tool, path], input=lines, capture_output=True, text=True, check=True).stdout.split()
        assert len(answer) == count, path
        valid = 0
        for document, faults in zip(documents, answer):
            expected = judge.is_valid(document)
            valid += expected
            if expected != (faults == "0"):
                differences += 1
                print(f"{path}: {'valid' if expected else 'invalid'}, but {faults} faults: {json.dumps(document)[:300]}")
        print(f"{path}: {count} documents, {valid} of them valid")
        if not count // 20 <= valid <= count - count // 20:
            print(f"{path}: too few documents of one kind")
            differences += 1
    return 1 if differences else 0


sys.exit(main())

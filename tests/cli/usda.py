# SPDX-License-Identifier: Apache-2.0
"""A strict reader of the part of .usda that murk writes: what it does not know is an error."""
import re

TOKEN = re.compile(r'\s*(?:(@@@.*?@@@|@[^@]*@)|("(?:[^"\\\n]|\\.)*")|(<[^>]*>)|'
                   r'([A-Za-z_][\w:.]*(?:\[\])?)|(-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|([][(){}=,:]))')
TYPES = {"asset": str, "bool": int, "color3f": (float,) * 3, "double": float, "double3": (float,) * 3,
         "float": float, "float2": (float,) * 2, "float3[]": [(float,) * 3], "int": int,
         "matrix4d": ((float,) * 4,) * 4, "rel": str, "string": str, "token": str, "token[]": [str]}
PRIMS = ("Xform", "Volume", "OpenVDBAsset", "Camera", "DistantLight", "DomeLight")


class Prim:
    def __init__(self, kind, name):
        self.kind, self.name, self.metadata = kind, name, {}
        self.properties, self.children = {}, {}


class Reader:
    def __init__(self, text):
        assert text.startswith("#usda 1.0\n"), "no #usda 1.0"
        self.tokens, at, text = [], 0, text[len("#usda 1.0\n"):].rstrip()
        while at < len(text):
            match = TOKEN.match(text, at)
            assert match, "not understood: " + text[at:at + 40]
            self.tokens.append(match.group().strip())
            at = match.end()

    def next(self, wanted=None):
        token = self.tokens.pop(0)
        assert wanted is None or token == wanted, f"{token} where {wanted} should be"
        return token

    def peek(self):
        return self.tokens[0] if self.tokens else None

    def value(self, shape):
        if isinstance(shape, tuple):
            self.next("(")
            values = []
            for n, part in enumerate(shape):
                if n:
                    self.next(",")
                values.append(self.value(part))
            self.next(")")
            return tuple(values)
        if isinstance(shape, list):
            self.next("[")
            values = []
            while self.peek() != "]":
                if values:
                    self.next(",")
                values.append(self.value(shape[0]))
            self.next("]")
            return values
        token = self.next()
        if shape is str:
            assert token[0] in '"@<', token + " is no text"
            return re.sub(r"\\(.)", r"\1", token.strip('"@<>'))
        return shape(token)

    def dictionary(self):
        self.next("{")
        entries = {}
        while self.peek() != "}":
            kind, name = self.next(), self.next()
            self.next("=")
            entries[name] = self.dictionary() if kind == "dictionary" else self.value(TYPES[kind])
        self.next("}")
        return entries

    def samples(self, shape):
        self.next("{")
        entries = {}
        while self.peek() != "}":
            time = float(self.next())
            self.next(":")
            entries[time] = self.value(shape)
            if self.peek() != "}":
                self.next(",")
        self.next("}")
        return entries

    def metadata(self):
        entries = {}
        if self.peek() != "(":
            return entries
        self.next("(")
        while self.peek() != ")":
            name = self.next()
            self.next("=")
            if self.peek() == "{":
                entries[name] = self.dictionary()
            else:
                token = self.next()
                entries[name] = token.strip('"') if token[0] == '"' else float(token)
        self.next(")")
        return entries

    def prim(self):
        self.next("def")
        kind = self.next()
        assert kind in PRIMS, "prim of type " + kind
        prim = Prim(kind, self.next().strip('"'))
        assert re.fullmatch(r"[A-Za-z_]\w*", prim.name), prim.name + " is no name of a prim"
        prim.metadata = self.metadata()
        self.next("{")
        while self.peek() != "}":
            if self.peek() == "def":
                child = self.prim()
                assert child.name not in prim.children, child.name + " is there twice"
                prim.children[child.name] = child
            else:
                self.property(prim)
        self.next("}")
        return prim

    def property(self, prim):
        if self.peek() == "uniform":
            self.next()
        shape, name = TYPES[self.next()], self.next()
        self.next("=")
        assert name not in prim.properties, name + " is there twice"
        sampled = name.endswith(".timeSamples")
        prim.properties[name] = self.samples(shape) if sampled else self.value(shape)
        self.metadata()


def read(path):
    """The metadata of the stage and its one root prim."""
    with open(path) as file:
        reader = Reader(file.read())
    metadata, root = reader.metadata(), reader.prim()
    assert reader.peek() is None, "more than one root prim"
    assert metadata["defaultPrim"] == root.name, "another default prim"
    return metadata, root

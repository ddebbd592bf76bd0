# Ishigami and Homma's function of three inputs: JSON on standard input, JSON on standard output.
import json
import math
import sys

x = json.load(sys.stdin)
f = math.sin(x["x1"]) + 7.0 * math.sin(x["x2"]) ** 2 + 0.1 * x["x3"] ** 4 * math.sin(x["x1"])
print(json.dumps({"f": f}))

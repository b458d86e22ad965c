# SPDX-License-Identifier: BSD-2-Clause
"""Started by trundle-host, to run controllers in this process. See trundle/host."""

import os
import sys

if sys.version_info < (3, 8):  # such a version cannot even read the package, so this is written in words that all versions know
    places = dict(part.split("=") for part in sys.argv[1].split(","))
    version = ".".join(map(str, sys.version_info[:3]))
    said = "Trundle needs Python 3.8 or newer, and the first python3 in PATH is %s: %s" % (version, sys.executable)
    os.pwrite(3, said.encode(), int(places["exception"]))
    os.pwrite(3, (1).to_bytes(4, sys.byteorder), int(places["phase"]))  # load
    sys.exit(1)

from trundle.host.main import main

main(sys.argv[1:])

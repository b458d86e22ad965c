# SPDX-License-Identifier: BSD-2-Clause
"""Started by trundle-host, to run controllers in this process. See trundle/host."""

import sys

from trundle.host.main import main

main(sys.argv[1:])

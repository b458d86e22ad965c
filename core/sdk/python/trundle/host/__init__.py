# SPDX-License-Identifier: BSD-2-Clause
"""The process in which controllers run: the other end of core/control/host, as app/host is for C++."""

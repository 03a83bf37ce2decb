"""Runs a command whose standard output is a pipe that nobody reads any more: unread.py COMMAND..."""

import os
import subprocess
import sys

read, write = os.pipe()
os.close(read)
sys.exit(subprocess.call(sys.argv[1:], stdout=write))

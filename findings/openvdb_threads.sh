#!/usr/bin/env bash
# OpenVDB 10.0.1 (Debian 12): a program that loads its library has four more threads, before it calls anything. They
# are the pool of log4cplus 2.0.8, by which OpenVDB logs, and which makes it as the library is loaded. So a program
# that is linked with OpenVDB is never alone in its process, which matters to those that fork: the child has its main
# thread only, and the thread sanitizer refuses to let it start others ("starting new threads after multi-threaded
# fork is not supported").
#
# Loads the library into Python and prints the number of threads before it, behind it, and in a forked child. Exit code
# 0: 1, 5 and 1; 1: other.
set -euo pipefail
openvdb=10.0.1-2 log4cplus=2.0.8-1
if [ "$(dpkg-query -W -f '${Version}' libopenvdb10.0 2>/dev/null)" != "$openvdb" ]; then
  apt-get install -q -y --no-install-recommends "libopenvdb10.0=$openvdb" "liblog4cplus-2.0.5=$log4cplus" python3 >/dev/null
fi
threads=$(/usr/bin/python3 - <<'PY'
import ctypes, os

def threads():
    return len(os.listdir("/proc/self/task"))

before = threads()
ctypes.CDLL("libopenvdb.so.10.0")
after = threads()
read, write = os.pipe()
child = os.fork()
if child == 0:
    os.write(write, str(threads()).encode())
    os._exit(0)
os.waitpid(child, 0)
print(before, after, os.read(read, 10).decode())
PY
)
echo "threads before, behind and in a child: $threads"
[ "$threads" = "1 5 1" ]

#!/usr/bin/env bash
# g++ 12.2 with libstdc++ 12.2 and glibc 2.36 (Debian 12): a module in C++ that calls std::to_string() once is never
# unloaded. dlclose() returns 0 and leaves it in memory for the life of the process, also where all of it is built with
# -fvisibility=hidden and loaded with RTLD_LOCAL: the table of digits of <charconv> is a static object of an inline
# function of namespace std, whose visibility is the default one, and g++ makes a unique symbol of it (STB_GNU_UNIQUE),
# which the loader never unloads. Whoever replaces the module at the same path gets the old code again. Built with
# -fno-gnu-unique, or by Clang 16, the module goes.
#
# Builds a module in the three ways, loads and closes each, and asks with RTLD_NOLOAD whether it is still there. Exit
# code 0: "stays", "gone" and "gone"; 1: other.
set -euo pipefail
gcc=12.2.0-14+deb12u1 clang=1:16.0.6-15~deb12u1
if [ "$(dpkg-query -W -f '${Version}' g++-12 2>/dev/null)" != "$gcc" ] ||
  [ "$(dpkg-query -W -f '${Version}' clang-16 2>/dev/null)" != "$clang" ]; then
  apt-get install -q -y --no-install-recommends "g++-12=$gcc" "clang-16=$clang" >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >module.cpp <<'CPP'
#include <string>
extern "C" __attribute__((visibility("default"))) int digits(int n) {
  return static_cast<int>(std::to_string(n).size());
}
CPP
cat >host.c <<'C'
#include <dlfcn.h>
#include <stdio.h>
int main(int count, char** modules) {
  for (int i = 1; i < count; ++i) {
    void* module = dlopen(modules[i], RTLD_NOW | RTLD_LOCAL);
    if (!module || dlclose(module) != 0) return 1;
    puts(dlopen(modules[i], RTLD_NOW | RTLD_NOLOAD) ? "stays" : "gone");
  }
  return 0;
}
C
g++-12 -O2 -fPIC -shared -fvisibility=hidden module.cpp -o plain.so
g++-12 -O2 -fPIC -shared -fvisibility=hidden -fno-gnu-unique module.cpp -o without.so
clang++-16 -O2 -fPIC -shared -fvisibility=hidden module.cpp -o clang.so
gcc-12 host.c -o host
found=$(./host ./plain.so ./without.so ./clang.so | tr '\n' ' ')
echo "by g++, without unique symbols, by Clang: $found"
[ "$found" = "stays gone gone " ]

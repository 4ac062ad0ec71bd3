// The program burin-brush-process, in which a host runs a brush (docs/isolation.md). Its argument is the
// version of the host; descriptors 3 to 6 are those of host/isolate/shared_memory.h.
#include <burin/host/isolate/channel.h>
#include <burin/level_set/solid_mesh.h>
#include <burin/services/stamp_services.h>
#include <burin/version.h>

#include <cstdio>
#include <string_view>

#include "server.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("burin-brush-process: applications of Burin start this program to run brushes in it\n",
               stderr);
    return 2;
  }
  if (argv[1] != std::string_view(BURIN_VERSION)) return burin::isolate::wrong_version;
  return burin::process::serve(burin::stamp_services(burin::read_vdb));
}

// The entry of libburin.so: libraries whose brushes have stamps and lettering.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/services/stamp_services.h>

burin_status burin_library_create(const burin_library_options* options, burin_library** library,
                                  burin_text* error) {
  return burin::plugin::guarded(error,
                                [&] { burin::c::create_library(options, burin::stamp_services(), library); });
}

// Checks burin_host and the tables of its services.
#include "check_host.h"

#include <burin/abi/ext/lettering.h>
#include <burin/abi/ext/log.h>
#include <burin/abi/ext/stamps.h>
#include <burin/abi/ext/vdb_stamps.h>

#include "../rules.h"
#include "check_values.h"

namespace burin_probe {
namespace {

bool is_filled(const char* text) { return text && *text && is_utf8(text); }

template <class Service>
const Service* service(const burin_host& host, const char* id) {
  return static_cast<const Service*>(host.get_extension(&host, id));
}

/// Whether a table of functions is as long as in version 1.0 and has no gap.
template <class Service, class Last, class... Functions>
bool is_whole(const Service& table, Last Service::*last, Functions Service::*... functions) {
  return table.struct_size >= sizeof(Service) && table.*last && ((table.*functions) && ... && true);
}

void check_services(const burin_host& host) {
  expect(Rule::host_unknown, !host.get_extension(&host, "org.burin.probe.nothing/1"),
         "org.burin.probe.nothing/1");
  if (const auto* log = service<burin_log>(host, BURIN_EXT_LOG))
    expect(Rule::host_services, is_whole(*log, &burin_log::write), BURIN_EXT_LOG);
  if (const auto* stamps = service<burin_stamps>(host, BURIN_EXT_STAMPS))
    expect(Rule::host_services,
           is_whole(*stamps, &burin_stamps::open, &burin_stamps::close, &burin_stamps::sample,
                    &burin_stamps::open_with, &burin_stamps::sample_area),
           BURIN_EXT_STAMPS);
  if (const auto* lettering = service<burin_lettering>(host, BURIN_EXT_LETTERING))
    expect(Rule::host_services, is_whole(*lettering, &burin_lettering::set), BURIN_EXT_LETTERING);
  if (const auto* stamps = service<burin_vdb_stamps>(host, BURIN_EXT_VDB_STAMPS))
    expect(Rule::host_services,
           is_whole(*stamps, &burin_vdb_stamps::open, &burin_vdb_stamps::close, &burin_vdb_stamps::sample),
           BURIN_EXT_VDB_STAMPS);
}

}  // namespace

void check_host(const burin_host* host) {
  const bool whole = host && BURIN_HAS(host, burin_host, get_extension) && host->get_extension &&
                     host->abi_major == BURIN_ABI_MAJOR && is_filled(host->name) && is_filled(host->version);
  if (expect(Rule::host_complete, whole, "struct_size", host ? host->struct_size : 0)) check_services(*host);
}

void check_host_lives(const burin_host* host, const burin_host& then) {
  expect(Rule::host_lives,
         host->struct_size == then.struct_size && host->get_extension == then.get_extension &&
             host->name == then.name,
         "struct_size", host->struct_size);
}

}  // namespace burin_probe

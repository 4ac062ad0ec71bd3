#include <burin/abi/ext/state.h>
#include <burin/deform/evaluate/error_text.h>
#include <burin/host/session/carry_state.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {
namespace {

const burin_state* state_of(const burin_brush& brush) {
  const auto* state = static_cast<const burin_state*>(brush.get_extension(&brush, BURIN_EXT_STATE));
  const bool whole = state && BURIN_HAS(state, burin_state, load) && state->save && state->load;
  return whole ? state : nullptr;
}

}  // namespace

std::string carry_state(const burin_brush& from, const burin_brush& to) {
  const burin_state *saving = state_of(from), *loading = state_of(to);
  if (!saving || !loading) return {};
  ErrorText error;
  std::uint64_t size = 0;
  saving->save(&from, nullptr, 0, &size, error.abi());
  std::vector<std::byte> bytes(size);
  burin_status status = saving->save(&from, bytes.data(), size, &size, error.abi());
  if (status != BURIN_OK) return "its state cannot be saved: " + error.line(status);
  status = loading->load(&to, saving->version, bytes.data(), size, error.abi());
  return status == BURIN_OK ? std::string() : "its state is lost: " + error.line(status);
}

}  // namespace burin

// Carries state over by the functions save and load of abi/ext/state.h.
#include <burin/deform/evaluate/error_text.h>
#include <burin/host/session/carry_state.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace burin {
const burin_state* state_of(const burin_brush& brush) {
  const auto* state = static_cast<const burin_state*>(brush.get_extension(&brush, BURIN_EXT_STATE));
  const bool whole = state && BURIN_HAS(state, burin_state, load) && state->save && state->load;
  return whole ? state : nullptr;
}

SavedState save_state(const burin_brush& brush, const burin_state& state) {
  ErrorText error;
  std::uint64_t size = 0;
  constexpr std::uint64_t most = std::uint64_t{1} << 30;
  state.save(&brush, nullptr, 0, &size, error.abi());
  if (size > most) return {BURIN_ERROR, "it has more than 1 GiB", {}};
  const std::uint64_t capacity = size;
  std::vector<std::byte> bytes(capacity + 1);  // never null, which would ask for the size alone
  const burin_status status = state.save(&brush, bytes.data(), capacity, &size, error.abi());
  if (status != BURIN_OK) return {status, error.line(status), {}};
  if (size > capacity) return {BURIN_ERROR, "it grew meanwhile", {}};
  bytes.resize(size);
  return {BURIN_OK, {}, std::move(bytes)};
}

std::string carry_state(const burin_brush& from, const burin_brush& to) {
  const burin_state *saving = state_of(from), *loading = state_of(to);
  if (!saving || !loading) return {};
  const SavedState saved = save_state(from, *saving);
  if (saved.status != BURIN_OK) return "its state cannot be saved: " + saved.problem;
  ErrorText error;
  const burin_status status =
      loading->load(&to, saving->version, saved.bytes.data(), saved.bytes.size(), error.abi());
  return status == BURIN_OK ? std::string() : "its state is lost: " + error.line(status);
}

}  // namespace burin

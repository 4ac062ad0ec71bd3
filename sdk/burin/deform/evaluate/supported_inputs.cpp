// Checks at compile time that the tables of inputs and outputs cover every bit and every member of the ABI's
// structs, and formats their names for messages.
#include <burin/deform/evaluate/supported_inputs.h>
#include <fmt/format.h>

#include <span>

namespace burin {
namespace {

constexpr bool bits_count_up(std::span<const Supported> all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].bit != UINT64_C(1) << i) return false;
  return true;
}

// No bit is missing, and no member of the ABI's structs.
static_assert(bits_count_up(all_inputs) && bits_count_up(all_outputs));
static_assert(offsetof(burin_batch, t) + sum(all_inputs).bytes == sizeof(burin_batch));
static_assert(offsetof(burin_outputs, along) + sum(all_outputs).bytes == sizeof(burin_outputs));

std::string names(std::uint64_t bits, std::span<const Supported> known) {
  std::string list;
  for (std::size_t bit = 0; bit < 64; ++bit) {
    if (!(bits >> bit & 1)) continue;
    if (!list.empty()) list += ", ";
    list += bit < known.size() ? std::string(known[bit].name) : fmt::format("number {}", bit);
  }
  return list;
}

}  // namespace

std::string input_names(std::uint64_t inputs) { return names(inputs, all_inputs); }

std::string output_names(std::uint64_t outputs) { return names(outputs, all_outputs); }

}  // namespace burin

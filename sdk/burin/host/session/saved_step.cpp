// Saved steps: a line that tells what they are, the numbers of elements, the two sums, the arrays one after
// the other, and the hash of all that. O(size of the step).
#include <burin/base/hash.h>
#include <burin/host/session.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace burin {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view first_line = "burin step 1   \n";

/// What stands before the arrays.
struct Header {
  std::array<char, first_line.size()> line;
  std::uint64_t vertices, painted, colours, masks;
  std::uint64_t from, to;
};

template <class Step, class Take>
void for_each_array(Step& step, const Take& take) {
  take(step.vertices);
  take(step.positions);
  take(step.painted_vertices);
  take(step.colours);
  take(step.masks);
}

template <class Value>
std::size_t bytes_of(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}

std::size_t bytes_of_arrays(const StrokeStep& step) {
  std::size_t bytes = 0;
  for_each_array(step, [&](const auto& values) { bytes += bytes_of(values); });
  return bytes;
}

[[noreturn]] void refuse(const char* what) { throw Error(std::string("a saved step ") + what); }

/// Reads the header of bytes whose hash is right.
Header read_header(std::span<const std::byte> bytes) {
  Header header{};
  std::memcpy(&header, bytes.data(), sizeof header);
  const auto none_or_all = [&](std::uint64_t count) { return count == 0 || count == header.painted; };
  const bool sound = header.vertices <= no_index && header.painted <= no_index &&
                     none_or_all(header.colours) && none_or_all(header.masks);
  if (!sound) refuse("has numbers of values that do not fit each other");
  return header;
}

StrokeStep sized_as(const Header& header) {
  StrokeStep step;
  step.vertices.resize(header.vertices);
  step.positions.resize(header.vertices);
  step.painted_vertices.resize(header.painted);
  step.colours.resize(header.colours);
  step.masks.resize(header.masks);
  step.from = header.from;
  step.to = header.to;
  return step;
}

/// The bytes that the arrays of such a step take.
std::uint64_t bytes_of_arrays(const Header& header) {
  return header.vertices * (sizeof(Index) + sizeof(Vec3f)) + header.painted * sizeof(Index) +
         header.colours * sizeof(Vec4f) + header.masks * sizeof(float);
}

}  // namespace

std::size_t StrokeStep::bytes() const { return sizeof *this + bytes_of_arrays(*this); }

std::size_t saved_bytes(const StrokeStep& step) {
  return sizeof(Header) + bytes_of_arrays(step) + sizeof(std::uint64_t);
}

std::vector<std::byte> saved_step(const StrokeStep& step) {
  Header header{{},
                step.vertices.size(),
                step.painted_vertices.size(),
                step.colours.size(),
                step.masks.size(),
                step.from,
                step.to};
  std::ranges::copy(first_line, header.line.begin());
  std::vector<std::byte> bytes(saved_bytes(step));
  std::byte* to = bytes.data();
  const auto append = [&](const void* data, std::size_t size) {
    if (size > 0) std::memcpy(to, data, size);
    to += size;
  };
  append(&header, sizeof header);
  for_each_array(step, [&](const auto& values) { append(values.data(), bytes_of(values)); });
  const std::uint64_t hash = hash_bytes(bytes.data(), bytes.size() - sizeof hash);
  append(&hash, sizeof hash);
  return bytes;
}

StrokeStep loaded_step(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0;
  if (bytes.size() < first_line.size() ||
      std::memcmp(bytes.data(), first_line.data(), first_line.size()) != 0)
    refuse("does not begin as one");
  if (bytes.size() < sizeof(Header) + sizeof hash) refuse("is cut off");
  const std::span<const std::byte> hashed = bytes.first(bytes.size() - sizeof hash);
  std::memcpy(&hash, hashed.data() + hashed.size(), sizeof hash);
  if (hash != hash_bytes(hashed.data(), hashed.size())) refuse("is damaged or cut off");
  const Header header = read_header(hashed);
  if (hashed.size() != sizeof header + bytes_of_arrays(header)) refuse("is damaged or cut off");
  StrokeStep step = sized_as(header);
  const std::byte* from = hashed.data() + sizeof header;
  for_each_array(step, [&](auto& values) {
    if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), from, bytes_of(values));
    from += bytes_of(values);
  });
  if (!std::ranges::all_of(step.positions, [](const Vec3f& p) { return p.allFinite(); }))
    refuse("has a position that is not finite");
  return step;
}

}  // namespace burin

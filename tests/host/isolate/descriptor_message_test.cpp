// Descriptors as messages, also damaged ones.
#include <burin/host/isolate/descriptor_message.h>
#include <burin/host/plugin/descriptor_check.h>

#include <random>

#include "host/sessions.h"

namespace burin::isolate {
namespace {

/// The message of all stock brushes.
Bytes message() {
  std::vector<const burin_brush_descriptor*> brushes;
  for (const BrushEntry& brush : test::brushes().brushes()) brushes.push_back(brush.descriptor);
  MessageWriter to;
  write_descriptors(to, brushes);
  return to.bytes();
}

/// How many descriptors come of it that are in order; -1 if it ends too early.
int received(std::span<const std::byte> bytes) {
  try {
    MessageReader from(bytes);
    const ReceivedDescriptors read(from);
    return static_cast<int>(std::ranges::count_if(
        read.brushes(), [](const auto* brush) { return descriptor_problem(*brush).empty(); }));
  } catch (const Error&) {
    return -1;
  }
}

TEST(DescriptorMessage, IsTheSameAfterItWasRead) {
  const Bytes once = message();
  MessageReader from(once);
  const ReceivedDescriptors read(from);
  EXPECT_EQ(from.left(), 0u);
  EXPECT_EQ(received(once), static_cast<int>(test::brushes().brushes().size()));
  MessageWriter again;
  write_descriptors(again, read.brushes());
  EXPECT_TRUE(again.bytes() == once);
}

TEST(DescriptorMessage, IsRefusedWhereverItIsCutOff) {
  const Bytes whole = message();
  for (std::size_t size = 0; size < whole.size(); size += size < 4000 ? 1 : 97)
    ASSERT_EQ(received(std::span(whole).first(size)), -1) << size;
}

TEST(DescriptorMessage, MayHaveAnyBytes) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  const Bytes whole = message();
  int refused = 0, fewer = 0;
  for (int i = 0; i < 300; ++i) {
    Bytes damaged = whole;
    for (int k = 0; k < 5; ++k) damaged[engine() % damaged.size()] = static_cast<std::byte>(engine());
    const int count = received(damaged);
    (count < 0 ? refused : fewer) += 1;
  }
  EXPECT_GT(refused, 5);
  EXPECT_GT(fewer, 5);
}

}  // namespace
}  // namespace burin::isolate

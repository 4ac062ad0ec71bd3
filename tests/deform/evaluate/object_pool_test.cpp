#include <burin/deform/evaluate/object_pool.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

struct Buffer {
  int value = 0;
};

// As when a thread starts a second call in the middle of the first.
TEST(ObjectPool, GivesEveryTakerAnObjectOfItsOwn) {
  ObjectPool<Buffer> pool;
  std::unique_ptr<Buffer> first = pool.take();
  first->value = 1;
  const std::unique_ptr<Buffer> second = pool.take();
  second->value = 2;
  EXPECT_EQ(first->value, 1);
}

TEST(ObjectPool, GivesOutAgainWhatItGetsBack) {
  ObjectPool<Buffer> pool;
  std::unique_ptr<Buffer> object = pool.take();
  const Buffer* const at = object.get();
  pool.give_back(std::move(object));
  EXPECT_EQ(pool.take().get(), at);
}

}  // namespace
}  // namespace burin

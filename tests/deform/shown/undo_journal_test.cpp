#include <burin/deform/shown/undo_journal.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(UndoJournal, GivesStepsBackNewestFirst) {
  UndoJournal journal;
  std::vector<Vec3f> positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(2, 0, 0)};
  journal.record(std::vector<Index>{0, 2}, positions);
  positions[2] = Vec3f(9, 9, 9);
  journal.record(std::vector<Index>{2}, positions);
  journal.record(std::vector<Index>{}, positions);

  EXPECT_TRUE(journal.take()->vertices.empty());
  const auto second = journal.take();
  EXPECT_EQ(second->vertices, (std::vector<Index>{2}));
  EXPECT_EQ(second->positions.at(0), Vec3f(9, 9, 9));
  const auto first = journal.take();
  EXPECT_EQ(first->vertices, (std::vector<Index>{0, 2}));
  EXPECT_EQ(first->positions.at(1), Vec3f(2, 0, 0));
  EXPECT_FALSE(journal.take());
}

}  // namespace
}  // namespace burin

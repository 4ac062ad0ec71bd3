#include <burin/deform/dirty_set.h>

#include <algorithm>
#include <bit>

namespace burin {

DirtySet::DirtySet(Index vertex_count)
    : bits_(vertex_count / 64 + 1), summary_(vertex_count / 4096 + 1), lowest_(summary_.size()) {}

void DirtySet::insert(Index vertex) {
  const std::size_t word = vertex / 64, group = vertex / 4096;
  bits_[word] |= std::uint64_t{1} << vertex % 64;
  summary_[group] |= std::uint64_t{1} << word % 64;
  lowest_ = std::min(lowest_, group);
  highest_ = std::max(highest_, group);
}

void DirtySet::drain(std::vector<Index>& vertices) {
  vertices.clear();
  for (std::size_t group = lowest_; group <= highest_ && group < summary_.size(); ++group) {
    for (std::uint64_t words = summary_[group]; words != 0; words &= words - 1)
      drain_word(group * 64 + static_cast<std::size_t>(std::countr_zero(words)), vertices);
    summary_[group] = 0;
  }
  lowest_ = summary_.size();
  highest_ = 0;
}

void DirtySet::drain_word(std::size_t word, std::vector<Index>& vertices) {
  for (std::uint64_t bits = bits_[word]; bits != 0; bits &= bits - 1)
    vertices.push_back(static_cast<Index>(word * 64) + static_cast<Index>(std::countr_zero(bits)));
  bits_[word] = 0;
}

}  // namespace burin

// Keeps a two-level bitmap. The upper level says which words of the lower level are not zero, so that
// draining skips 4096 indices per empty word of the upper level.
#include <burin/base/index_set.h>

#include <bit>

namespace burin {

IndexSet::IndexSet(Index count)
    : bits_(count / 64 + 1), summary_(count / 4096 + 1), lowest_(summary_.size()) {}

void IndexSet::drain(std::vector<Index>& indices) {
  indices.clear();
  for (std::size_t group = lowest_; group <= highest_ && group < summary_.size(); ++group) {
    for (std::uint64_t words = summary_[group]; words != 0; words &= words - 1)
      drain_word(group * 64 + static_cast<std::size_t>(std::countr_zero(words)), indices);
    summary_[group] = 0;
  }
  lowest_ = summary_.size();
  highest_ = 0;
}

void IndexSet::drain_word(std::size_t word, std::vector<Index>& indices) {
  for (std::uint64_t bits = bits_[word]; bits != 0; bits &= bits - 1)
    indices.push_back(static_cast<Index>(word * 64) + static_cast<Index>(std::countr_zero(bits)));
  bits_[word] = 0;
}

}  // namespace burin

// Mends strokes, one fault after the other.
#include <burin/ink/mend.h>
#include <burin/ink/mend/mend_positions.h>
#include <burin/ink/mend/mend_times.h>

#include <utility>

namespace burin {

std::vector<std::string> mend(Recording& recording) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < recording.strokes.size(); ++i) {
    RecordedStroke& stroke = recording.strokes[i];
    MendLog did(i + 1, stroke.samples.size());
    mend_order(stroke, did);
    remove_duplicates(stroke, did);
    mend_packets(stroke, did);
    remove_wild_samples(stroke, did);
    remove_hooks(stroke, did);
    for (std::string& line : std::move(did).lines()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace burin

#pragma once
#include <burin/ink/mend/mend_log.h>
#include <burin/stroke/recording.h>

namespace burin {

/// Removes single samples that lie far beside the way from the one before to the next: more than 10 times as
/// far from both as these are from each other, and as the stroke's median step.
void remove_wild_samples(RecordedStroke& stroke, MendLog& log);

/// Removes hooks, which pens draw as they land and lift: up to 6 samples at an end that go straight, for half
/// a median step to a thirtieth of the stroke's way, and turn by more than 120 degrees into the way beyond.
void remove_hooks(RecordedStroke& stroke, MendLog& log);

}  // namespace burin

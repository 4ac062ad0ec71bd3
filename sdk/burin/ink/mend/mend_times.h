#pragma once
#include <burin/ink/mend/mend_log.h>
#include <burin/stroke/recording.h>

namespace burin {

/// Puts samples in the order of their times if the way gets no longer by that, else raises times that fall to
/// the one before.
void mend_order(RecordedStroke& stroke, MendLog& log);

/// Removes samples that equal the one before in everything.
void remove_duplicates(RecordedStroke& stroke, MendLog& log);

/// Spreads the equal stamps of packets (spread_times()). Times that are the same throughout are removed.
void mend_packets(RecordedStroke& stroke, MendLog& log);

}  // namespace burin

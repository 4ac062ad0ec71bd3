#pragma once
#include <burin/remesh/divide.h>

namespace burin {

/// Lets two patches that cover the same surface, of which one keeps what the other does not, be divided along
/// the same lines, at most `tolerance` from each other. Where one has a line that the other lacks, the disc
/// within it changes sides, if its field is nowhere farther from 0 than `shallow`. All in object units.
void agree(DividedPatch& first, DividedPatch& second, double tolerance, double shallow);

}  // namespace burin

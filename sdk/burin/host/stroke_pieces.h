#pragma once
#include <burin/host/session.h>

#include <span>
#include <vector>

namespace burin {

/// Adds a sample, by add(), to the piece of a stroke. Where it does not continue a piece that has begun, the
/// piece ends by end_piece(); a sample across a gap then begins the next. Returns what became of the sample.
template <class Add, class EndPiece>
StrokeEvent::Outcome add_in_pieces(bool piece_begun, const Add& add, const EndPiece& end_piece) {
  const StrokeEvent::Outcome outcome = add();
  if (outcome == StrokeEvent::Outcome::drawn || !piece_begun) return outcome;
  end_piece();
  return outcome == StrokeEvent::Outcome::disconnected ? add() : outcome;
}

/// How a piece of a stroke ends that is not the whole of it: only pieces that come back by themselves close.
inline Closure closure_of_piece(Closure of_stroke) {
  return of_stroke == Closure::automatic ? of_stroke : Closure::open;
}

/// A stroke of a session that ends a piece where the pen leaves the surface or jumps across a gap, as
/// replay() does. Session::add_sample by itself would go on from the last place to the next, with a bridge
/// between them. One thread, as Session.
class StrokePieces {
 public:
  /// Begins a stroke of the session, which must outlive the object. Throws as Session::begin_stroke.
  StrokePieces(Session& session, const StrokeSettings& settings, Closure closure = Closure::open);

  /// As Session::add_sample; `changed` has what the end of a piece changed, too, whatever the outcome.
  StrokeEvent add(const Ray& ray, double time, const Pen& pen, Show show = Show::now);
  StrokeEvent add(const Vec3d& position, double time, const Pen& pen, Show show = Show::now);

  /// As Session::end_stroke.
  std::span<const Index> end();

 private:
  template <class At>
  StrokeEvent add_at(const At& at, double time, const Pen& pen, Show show);
  void note_changed(std::span<const Index> vertices);

  Session* session_;
  Closure closure_;
  bool piece_begun_ = false;  ///< has a sample
  bool whole_ = true;         ///< no piece has ended yet
  std::vector<Index> changed_;
};

}  // namespace burin

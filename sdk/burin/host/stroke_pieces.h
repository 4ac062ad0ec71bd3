#pragma once
#include <burin/host/session.h>

#include <span>
#include <vector>

namespace burin {

/// Adds a sample to a piece of a stroke by calling add(), which returns an Outcome. If the sample does not
/// continue a piece that has begun, end_piece() is called, and a sample across a gap is added again as the
/// start of the next piece. Returns the outcome of the sample.
template <class Add, class EndPiece>
StrokeEvent::Outcome add_in_pieces(bool piece_begun, const Add& add, const EndPiece& end_piece) {
  const StrokeEvent::Outcome outcome = add();
  if (outcome == StrokeEvent::Outcome::drawn || !piece_begun) return outcome;
  end_piece();
  return outcome == StrokeEvent::Outcome::disconnected ? add() : outcome;
}

/// The closure of a piece that is not the whole stroke: it closes only if it returns to its start by itself.
inline Closure closure_of_piece(Closure of_stroke) {
  return of_stroke == Closure::automatic ? of_stroke : Closure::open;
}

/// Draws a stroke of a session that ends a piece where the pen leaves the surface or jumps across a gap, as
/// replay() does. Session::add_sample() alone would connect the last point before to the first point after,
/// where that is possible. One thread, as Session.
class StrokePieces {
 public:
  /// Starts a stroke of the session, which must outlive the object. Throws as Session::begin_stroke() does.
  StrokePieces(Session& session, const StrokeSettings& settings, Closure closure = Closure::open);

  /// Adds a sample as Session::add_sample() does. `changed` includes the vertices that the end of a piece
  /// changed, whatever the outcome.
  StrokeEvent add(const Ray& ray, double time, const Pen& pen, Show show = Show::now);
  StrokeEvent add(const Vec3d& position, double time, const Pen& pen, Show show = Show::now);

  /// Ends the stroke as Session::end_stroke() does.
  std::span<const Index> end();

 private:
  template <class At>
  StrokeEvent add_at(const At& at, double time, const Pen& pen, Show show);
  void note_changed(std::span<const Index> vertices);

  Session* session_;
  Closure closure_;
  bool piece_begun_ = false;  ///< the current piece has a sample
  bool whole_ = true;         ///< no piece has ended yet
  std::vector<Index> changed_;
};

}  // namespace burin

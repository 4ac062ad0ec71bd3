// Decides for each sample whether it continues the piece, begins a new one or lies beside the surface.
#include <burin/base/sort_unique.h>
#include <burin/host/stroke_pieces.h>

namespace burin {

StrokePieces::StrokePieces(Session& session, const StrokeSettings& settings, Closure closure)
    : session_(&session), closure_(closure) {
  session.begin_stroke(settings);
}

template <class At>
StrokeEvent StrokePieces::add_at(const At& at, double time, const Pen& pen, Show show) {
  changed_.clear();
  const auto add = [&] {
    const StrokeEvent event = session_->add_sample(at, time, pen, show);
    note_changed(event.changed);
    return event.outcome;
  };
  const auto end_piece = [&] {
    note_changed(session_->end_piece(closure_of_piece(closure_)));
    piece_begun_ = whole_ = false;
  };
  const StrokeEvent::Outcome outcome = add_in_pieces(piece_begun_, add, end_piece);
  piece_begun_ |= outcome == StrokeEvent::Outcome::drawn;
  sort_unique(changed_);
  return {outcome, changed_};
}

StrokeEvent StrokePieces::add(const Ray& ray, double time, const Pen& pen, Show show) {
  return add_at(ray, time, pen, show);
}

StrokeEvent StrokePieces::add(const Vec3d& position, double time, const Pen& pen, Show show) {
  return add_at(position, time, pen, show);
}

std::span<const Index> StrokePieces::end() {
  return session_->end_stroke(whole_ ? closure_ : closure_of_piece(closure_));
}

void StrokePieces::note_changed(std::span<const Index> vertices) {
  changed_.insert(changed_.end(), vertices.begin(), vertices.end());
}

}  // namespace burin

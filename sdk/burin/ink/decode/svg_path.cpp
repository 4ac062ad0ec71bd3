// Follows the data of SVG paths ("Scalable Vector Graphics 2", section 9.3).
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/ink/decode/svg_path.h>
#include <burin/ink/parse/scan.h>
#include <burin/math/elementary.h>
#include <fmt/format.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

namespace burin {
namespace {

/// The place on a Bézier curve of three or four points.
Eigen::Vector2d bezier(std::span<const Eigen::Vector2d> points, double share) {
  std::array<Eigen::Vector2d, 4> left;
  std::ranges::copy(points, left.begin());
  for (std::size_t count = points.size(); count > 1; --count)
    for (std::size_t i = 0; i + 1 < count; ++i) left[i] += share * (left[i + 1] - left[i]);
  return left[0];
}

/// The elliptic arc between two points, by its centre (section B.2.4).
struct Arc {
  Arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Eigen::Vector2d radii, double turn, bool large,
      bool sweep);
  Eigen::Vector2d at(double share) const {
    const double angle = first + share * sweep_angle;
    return centre + axes * Eigen::Vector2d(math::cos(angle), math::sin(angle));
  }
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Matrix2d axes;
  double first = 0, sweep_angle = 0;
};

Arc::Arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Eigen::Vector2d radii, double turn,
         bool large, bool sweep) {
  Eigen::Matrix2d turned;
  turned << math::cos(turn), -math::sin(turn), math::sin(turn), math::cos(turn);
  const Eigen::Vector2d half = turned.transpose() * (from - to) / 2;
  const double beyond = half.cwiseQuotient(radii).squaredNorm();
  if (beyond > 1) radii *= std::sqrt(beyond);
  axes = turned * radii.asDiagonal();
  const Eigen::Vector2d start = half.cwiseQuotient(radii);  // on the unit circle around `middle`
  const double chord = start.squaredNorm();
  const double off = std::sqrt(std::max(0., 1 / chord - 1)) * (large == sweep ? -1 : 1);
  const Eigen::Vector2d middle = off * Eigen::Vector2d(start.y(), -start.x());
  centre = axes * middle + (from + to) / 2;
  const Eigen::Vector2d a = start - middle, b = -start - middle;
  first = math::atan2(a.y(), a.x());
  sweep_angle = math::atan2(b.y(), b.x()) - first;
  constexpr double full = 2 * std::numbers::pi;
  if (sweep && sweep_angle < 0) sweep_angle += full;
  if (!sweep && sweep_angle > 0) sweep_angle -= full;
}

class PathFollower {
 public:
  PathFollower(std::string_view data, const std::function<void()>& begin,
               const std::function<void(const Eigen::Vector2d&)>& point)
      : rest_(data), begin_(begin), point_(point) {}

  void follow();

 private:
  void take_command(char command);
  void take_curve(char kind, const Eigen::Vector2d& origin);
  void take_arc(const Eigen::Vector2d& origin);
  void go_to(const Eigen::Vector2d& place);
  void skip_commas();
  bool number_follows();
  double number();
  bool flag();
  Eigen::Vector2d pair(const Eigen::Vector2d& origin) {
    const double x = number();
    return origin + Eigen::Vector2d(x, number());
  }

  std::string_view rest_;
  const std::function<void()>& begin_;
  const std::function<void(const Eigen::Vector2d&)>& point_;
  Eigen::Vector2d at_ = Eigen::Vector2d::Zero(), start_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d control_ = Eigen::Vector2d::Zero();  ///< the last one of the curve before
  char before_ = 'M';                                  ///< the command before, in upper case
  bool open_ = false;                                  ///< the subpath has begun
};

void PathFollower::skip_commas() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n\f,"), rest_.size()));
}

bool PathFollower::number_follows() {
  skip_commas();
  return !rest_.empty() && (std::string_view("+-.0123456789").find(rest_.front()) != std::string_view::npos);
}

double PathFollower::number() {
  skip_commas();
  double value = 0;
  if (!take_number(rest_, value))
    throw Error(fmt::format("expected a number in a path, found {}", quoted_word(rest_.substr(0, 20))));
  return value;
}

/// Flags need no blank behind them.
bool PathFollower::flag() {
  skip_commas();
  if (rest_.empty() || (rest_.front() != '0' && rest_.front() != '1'))
    throw Error("expected a flag of an arc");
  const bool set = rest_.front() == '1';
  rest_.remove_prefix(1);
  return set;
}

void PathFollower::go_to(const Eigen::Vector2d& place) {
  if (!open_) {
    begin_();
    point_(at_);
    open_ = true;
  }
  at_ = place;
  point_(at_);
}

void PathFollower::take_curve(char kind, const Eigen::Vector2d& origin) {
  const bool cubic = kind == 'C' || kind == 'S';
  const bool smooth = kind == 'S' || kind == 'T';
  const bool follows = cubic ? before_ == 'C' || before_ == 'S' : before_ == 'Q' || before_ == 'T';
  std::array<Eigen::Vector2d, 4> points;
  std::size_t count = 0;
  points[count++] = at_;
  if (smooth)
    points[count++] = follows ? Eigen::Vector2d(2 * at_ - control_) : at_;
  else
    points[count++] = pair(origin);
  if (cubic) points[count++] = pair(origin);
  points[count++] = pair(origin);
  control_ = points[count - 2];
  for (int i = 1; i <= chords_of_svg_curve; ++i)
    go_to(bezier(std::span(points).first(count), static_cast<double>(i) / chords_of_svg_curve));
}

void PathFollower::take_arc(const Eigen::Vector2d& origin) {
  const Eigen::Vector2d radii = pair(Eigen::Vector2d::Zero()).cwiseAbs();
  const double turn = number() * std::numbers::pi / 180;
  const bool large = flag(), sweep = flag();
  const Eigen::Vector2d to = pair(origin);
  if (radii.minCoeff() == 0 || to == at_) return go_to(to);
  const Arc arc(at_, to, radii, turn, large, sweep);
  for (int i = 1; i < chords_of_svg_curve; ++i) go_to(arc.at(static_cast<double>(i) / chords_of_svg_curve));
  go_to(to);
}

/// Takes one set of arguments of a command.
void PathFollower::take_command(char command) {
  const char kind = command >= 'a' ? static_cast<char>(command - 'a' + 'A') : command;
  const Eigen::Vector2d origin = command == kind ? Eigen::Vector2d::Zero() : at_;
  switch (kind) {
    case 'M':
      at_ = start_ = pair(origin);
      open_ = false;
      break;
    case 'L':
      go_to(pair(origin));
      break;
    case 'H':
      go_to({origin.x() + number(), at_.y()});
      break;
    case 'V':
      go_to({at_.x(), origin.y() + number()});
      break;
    case 'C':
    case 'S':
    case 'Q':
    case 'T':
      take_curve(kind, origin);
      break;
    case 'A':
      take_arc(origin);
      break;
    default:
      throw Error(fmt::format("no command of a path: {}", quoted_word(std::string(1, command))));
  }
  before_ = kind;
}

void PathFollower::follow() {
  if (rest_ == "none") return;
  for (skip_commas(); !rest_.empty(); skip_commas()) {
    char command = rest_.front();
    rest_.remove_prefix(1);
    if (command == 'Z' || command == 'z') {
      if (open_) go_to(start_);
      at_ = start_;
      open_ = false;
      before_ = 'Z';
      continue;
    }
    take_command(command);
    // Further pairs after a move are lines.
    if (command == 'M') command = 'L';
    if (command == 'm') command = 'l';
    while (number_follows()) take_command(command);
  }
}

}  // namespace

void follow_svg_path(std::string_view data, const std::function<void()>& begin,
                     const std::function<void(const Eigen::Vector2d& point)>& point) {
  PathFollower(data, begin, point).follow();
}

}  // namespace burin

// Exchanges border nodes between the parts of a front. Each part keeps copies of the nodes of others
// beside its own vertices, and what others know of its own, so that it reports only what differs.
#include <burin/chart/front/front_part.h>

#include <algorithm>

namespace burin {

void FrontPart::receive(std::size_t part, std::span<const BorderNode> reports) {
  std::vector<Index> inside;
  for (const BorderNode& report : reports) {
    const Index index = copy_of(part, report);
    if (index == no_index) continue;
    FrontNode& copy = nodes_[index];
    if (copy.state == NodeState::inside) mark_downwind(index);
    copy.state = report.inside ? NodeState::inside : NodeState::open;
    copy.set_g(report.inside ? report.g : unreached);
    copy.sample = report.sample;
    copy.frame = report.frame;
    if (report.inside) inside.push_back(index);
  }
  take_back_marked();
  for (const Index index : inside)
    if (nodes_[index].state == NodeState::inside) lead_on(index);
  take_back_marked();
  reach_waiting();
}

Index FrontPart::copy_of(std::size_t part, const BorderNode& report) {
  if (copies_.size() <= part) copies_.resize(part + 1);
  const auto known = copies_[part].find(report.node);
  if (known != copies_[part].end()) return known->second;
  const auto own = [this](Index vertex) { return own_.holds(vertex); };
  if (std::ranges::none_of(ground_->neighbours(report.vertex), own)) return no_index;
  return copies_[part][report.node] = nodes_.add_foreign(report.vertex);
}

std::span<const BorderNode> FrontPart::reports() {
  reports_.clear();
  for (const Index node : border_) report(node);
  border_.clear();
  return reports_;
}

void FrontPart::report(Index index) {
  const FrontNode& node = nodes_[index];
  const bool inside = node.state == NodeState::inside;
  const BorderNode now{index, node.vertex(), node.sample, inside, node.g(), node.frame};
  BorderNode& known = reported_.try_emplace(index, BorderNode{}).first->second;
  if (known == now || (!known.inside && !inside)) return;
  known = now;
  reports_.push_back(now);
}

}  // namespace burin

#pragma once
#include <burin/abi/brush.h>
#include <burin/host/isolate/message.h>

#include <deque>
#include <span>
#include <string>
#include <vector>

namespace burin::isolate {

/// Appends the descriptors of a module, which must be checked.
void write_descriptors(MessageWriter& to, std::span<const burin_brush_descriptor* const> brushes);

/// Descriptors that came in a message, with all that they point to. They are as unchecked as the message.
class ReceivedDescriptors {
 public:
  /// Throws Error if the message ends too early.
  explicit ReceivedDescriptors(MessageReader& from);
  ReceivedDescriptors(const ReceivedDescriptors&) = delete;
  ReceivedDescriptors& operator=(const ReceivedDescriptors&) = delete;

  const std::vector<const burin_brush_descriptor*>& brushes() const { return pointers_; }

 private:
  burin_brush_descriptor read_brush(MessageReader& from);
  burin_param_info read_param(MessageReader& from);
  const char* read_text(MessageReader& from);
  const char* const* read_texts(MessageReader& from);

  std::deque<std::string> texts_;
  std::deque<std::vector<const char*>> lists_;
  std::deque<std::vector<float>> knots_;
  std::deque<burin_param_info> params_;
  std::deque<std::vector<const burin_param_info*>> param_lists_;
  std::deque<burin_brush_descriptor> brushes_;
  std::vector<const burin_brush_descriptor*> pointers_;
};

}  // namespace burin::isolate

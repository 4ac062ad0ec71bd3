#pragma once
#include <burin/abi/base.h>

#include <array>
#include <string>

namespace burin {

/// A buffer that a plugin leaves its one line of explanation in.
class ErrorText {
 public:
  /// To be handed to a plugin; valid while this object stays in place.
  burin_text* abi() { return &text_; }

  ErrorText();
  ErrorText(const ErrorText&) = delete;
  ErrorText& operator=(const ErrorText&) = delete;

  /// What the plugin wrote, as one line; where it wrote nothing, what the status means.
  std::string line(burin_status status) const;

 private:
  std::array<char, 512> buffer_{};
  burin_text text_;
};

}  // namespace burin

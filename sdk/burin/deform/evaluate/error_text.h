#pragma once
#include <burin/abi/base.h>

#include <array>
#include <string>

namespace burin {

/// A buffer in which a plugin can leave one line of explanation.
class ErrorText {
 public:
  /// The structure to pass to a plugin; valid while this object stays in place.
  burin_text* abi() { return &text_; }

  ErrorText();
  ErrorText(const ErrorText&) = delete;
  ErrorText& operator=(const ErrorText&) = delete;

  /// The plugin's text as one line, or the meaning of the status if the plugin wrote nothing.
  std::string line(burin_status status) const;

 private:
  std::array<char, 512> buffer_{};
  burin_text text_;
};

}  // namespace burin

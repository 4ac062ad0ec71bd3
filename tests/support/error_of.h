#pragma once
#include <burin/base/error.h>

#include <string>

namespace burin::test {

/// The message of the Error that `body` throws, or "none".
template <class Body>
std::string error_of(const Body& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace burin::test

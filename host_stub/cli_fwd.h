#pragma once

/// Forward declarations of CLI11. Its header takes longer to compile than most sources here, so only sources
/// that add options include it.
namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

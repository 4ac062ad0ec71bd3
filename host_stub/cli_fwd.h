#pragma once

/// CLI11's header alone takes longer to compile than most sources here: only sources that add options have
/// it.
namespace CLI {
class App;
class Validator;
}  // namespace CLI

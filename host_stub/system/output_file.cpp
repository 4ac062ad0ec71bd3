// Checks output paths before work starts.
#include "system/output_file.h"

#include <burin/base/file.h>

namespace burin {

void check_output_path(const std::string& path) {
  if (!path.empty()) check_output(path);
}

}  // namespace burin

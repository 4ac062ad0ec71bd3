#include "bench_suite.h"

#include <filesystem>

#include "support/shapes.h"

namespace burin::test {

using nlohmann::json;

BenchFolder::BenchFolder() {
  write("sphere.obj", obj_text(sphere(4, 0.1, 1)));
  write("a.stroke", equator_stroke(-0.6, 0.6, 41, "\"brush\":\"org.burin.groove\",\"radius\":0.2"));
}

json BenchFolder::bench_case(const std::string& name, const json& members) {
  json made = {{"name", name}, {"mesh", "sphere.obj"}, {"strokes", {"a.stroke"}}};
  made.update(members);
  return made;
}

std::string BenchFolder::write_suite(const std::vector<json>& cases) const {
  const json suite = {{"burin_suite", 1}, {"name", "small"}, {"cases", cases}};
  return write("suite.json", suite.dump(1));
}

std::string BenchFolder::changed_burin(const std::string& expression) const {
  namespace fs = std::filesystem;
  const std::string script =
      write("other_burin", "#!/bin/sh\n'" BURIN_COMMAND "' \"$@\" | sed -E '" + expression + "'\n");
  fs::permissions(script, fs::perms::owner_all);
  return script;
}

}  // namespace burin::test

// Modules that only processes of their own load.
#if defined(__linux__)
#include <burin/host/isolate/isolated_module.h>
#include <burin/host/plugin/descriptor_check.h>
#include <burin/plugin/detail/error.h>

#include <utility>

namespace burin::isolate {

DescriptorReader::DescriptorReader(const Isolation& isolation, Log log)
    : isolation_(isolation), log_(std::move(log)) {}

Answer DescriptorReader::ask(const std::filesystem::path& module) {
  if (!process_ || process_->has_failed()) {
    process_ = std::make_unique<BrushProcess>(isolation_, log_);
    used_ = false;
  }
  const bool first = !std::exchange(used_, true);
  try {
    return process_->request(Request::describe, MessageWriter().text(module.string()),
                             isolation_.load_seconds);
  } catch (const Error&) {
    if (first) throw;
  }
  return ask(module);
}

Bytes DescriptorReader::read(const std::filesystem::path& module) {
  try {
    const Answer answer = ask(module);
    // The text names the file already.
    if (answer.status() != BURIN_OK) throw Error(answer.text());
    const std::span<const std::byte> message = answer.content().block();
    return {message.begin(), message.end()};
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    const std::string name = module.string() + ": ";
    const std::string_view what = error.what();
    throw FileError(module.string(), what.starts_with(name) ? what.substr(name.size()) : what);
  }
}

IsolatedModule::IsolatedModule(std::filesystem::path path, DescriptorReader& reader,
                               const Isolation& isolation, Log log)
    : path_(std::move(path)), isolation_(isolation), log_(std::move(log)), message_(reader.read(path_)) {
  try {
    MessageReader message{message_};
    descriptors_.emplace(message);
  } catch (const Error& error) {
    throw FileError(path_.string(), error.what());
  }
  for (const burin_brush_descriptor* brush : descriptors_->brushes())
    if (const std::string problem = descriptor_problem(*brush); !problem.empty())
      throw FileError(path_.string(), shown_text(problem));
}

const burin_brush* IsolatedModule::create(const burin_host*, const char* brush_id, burin_text* error) const {
  const burin_brush* brush = nullptr;
  plugin::guarded(error, [&] {
    brush = (new IsolatedBrush({path_, brush_id, message_, isolation_, log_}))->abi();
  });
  return brush;
}

}  // namespace burin::isolate
#endif

#pragma once
#include <burin/host/host_extensions.h>

#include <memory>

namespace burin {

/// Stamps and lettering for the brushes of a BrushLibrary: images from files, and lines of text as images.
/// Without these services a stroke of a brush that needs them fails with a message. The services may be
/// called on any thread.
std::unique_ptr<HostExtensions> stamp_services();

}  // namespace burin

#pragma once
#include <burin/host/host_extensions.h>

#include <memory>

namespace burin {

/// Stamps and lettering for the brushes of a BrushLibrary: images from files, and lines of text as images.
/// Without them brushes that need them cannot be created, or go without, and say so.
std::unique_ptr<HostExtensions> stamp_services();

}  // namespace burin

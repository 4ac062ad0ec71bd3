// Writes the page of a watch, and the pictures that it shows.
#include "watch/watch_page.h"

#include <burin/base/hash.h>
#include <fmt/format.h>

#include <filesystem>

#include "report/html_text.h"
#include "report/report_folder.h"

namespace burin {
namespace {

std::string figure(const std::string& name, const WatchedStroke& stroke) {
  // The hash makes another address of another picture, so that browsers read it anew.
  return fmt::format(
      "<figure><img src='watch_{0}.png?{1}' alt='{0}'><figcaption>{0}: {2}</figcaption></figure>\n", name,
      hash_text(stroke.hash), stroke_text(stroke));
}

}  // namespace

std::string stroke_text(const WatchedStroke& stroke) {
  return fmt::format("{:.3f} s, {:.0f} ns a node, hash {}", stroke.seconds, stroke.nanoseconds_per_node,
                     hash_text(stroke.hash));
}

void write_watch_page(const std::string& folder, const WatchedStroke& before, const WatchedStroke& after) {
  const std::filesystem::path root = folder;
  write_png(root / "watch_before.png", before.picture);
  write_png(root / "watch_after.png", after.picture);
  write_text(root / "watch.html",
             fmt::format("<!doctype html>\n<html lang='en'><meta charset='utf-8'><meta http-equiv='refresh' "
                         "content='1'><title>{0}</title>\n<style>body{{font:15px sans-serif;margin:1em}}"
                         "figure{{display:inline-block;width:48%;margin:0}}img{{width:100%}}</style>\n"
                         "<h1>{0}</h1>\n{1}{2}</html>\n",
                         escaped(after.brush), figure("before", before), figure("after", after)));
}

}  // namespace burin

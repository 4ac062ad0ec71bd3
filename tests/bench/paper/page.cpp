#include "page.h"

#include <burin/base/file.h>
#include <burin/base/text/base64.h>
#include <fmt/format.h>

#include "host_stub/report/html_text.h"
#include "support/shared_data.h"

namespace burin::paper {
namespace {

std::string png(const Picture& picture) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "picture.png";
  write_png(file, picture);
  return read_file(file);
}

std::string row_of(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  return row + "</tr>\n";
}

constexpr const char* style =
    "body{font:15px/1.5 sans-serif;max-width:1180px;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}td,th{padding:.2em .8em;border-bottom:1px solid #ccc;"
    "text-align:right}td:first-child,th:first-child{text-align:left}.row{display:flex;gap:1em;flex-wrap:wrap}"
    "figure{margin:0;flex:1 1 320px;max-width:560px}img{width:100%}figcaption{font-size:13px}";

}  // namespace

Page::Page(const std::string& title)
    : body_(fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>{0}</title>"
                        "<style>{1}{2}</style></head>\n<body><h1>{0}</h1>\n",
                        escaped(title), plot_style(), style)) {}

void Page::heading(const std::string& text) { body_ += fmt::format("<h2>{}</h2>\n", escaped(text)); }

void Page::paragraph(const std::string& text) { body_ += fmt::format("<p>{}</p>\n", escaped(text)); }

void Page::table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  body_ += "<table>" + row_of(head, "th");
  for (const auto& row : rows) body_ += row_of(row, "td");
  body_ += "</table>\n";
}

void Page::pictures(const std::vector<Captioned>& row) {
  body_ += "<div class=\"row\">";
  for (const Captioned& item : row) {
    body_ += fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"/><figcaption>{0}</figcaption></figure>\n",
        escaped(item.caption), base64(png(item.picture)));
  }
  body_ += "</div>\n";
}

void Page::plot(const Plot& plot) { body_ += "<figure>" + plot.svg() + "</figure>\n"; }

void Page::write(const std::filesystem::path& path) const {
  write_file_whole(path, [&](std::ostream& out) { out << body_ << "</body></html>\n"; });
}

}  // namespace burin::paper

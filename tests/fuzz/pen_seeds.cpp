// Pen files as their programs write them, shortened.
#include "pen_seeds.h"

#include <vector>

#include "ink/kinds/bytes.h"

namespace burin::fuzz {
namespace {

using test::Bytes;
using test::riff;
using test::zigzags;

std::string uim() {
  constexpr double per_metre = 96 / 0.0254;
  Bytes group;
  for (const char* name : {"X", "Y", "Timestamp", "Pressure", "Altitude", "Azimuth"})
    group.add_field(2, Bytes()
                           .add_field(1, name)
                           .add_field(2, std::string("will://input/3.0/channel/") + name)
                           .add_field(4, per_metre)
                           .add_field(7, std::uint64_t{2})
                           .text());
  const std::string context = Bytes().add_field(2, group.add_field(5, "pen").text()).text();
  Bytes data;
  data.add_field(4, std::uint64_t{1600000000500});
  for (const char* name : {"X", "Y", "Timestamp", "Pressure", "Altitude", "Azimuth"})
    data.add_field(5, Bytes().add_field(1, name).add_field(2, zigzags({10, 20, -5})).text());
  const std::string contexts =
      Bytes().add_field(2, Bytes().add_field(1, "pen").text()).add_field(5, context).text();
  return riff("UINK", "INPT", Bytes().add_field(1, contexts).add_field(2, data.text()).text());
}

std::string will() {
  const std::string path = Bytes()
                               .add_field(3, std::uint64_t{1})
                               .add_field(4, zigzags({10, 20, 5, -10, 300, 7}))
                               .add_field(5, zigzags({30, 1, 1}))
                               .text();
  return riff("WILL", "INK ", Bytes().add_varint(path.size()).add_text(path).text());
}

std::string tilt() {
  Bytes bytes;
  bytes.add(0xc576a5cdU).add(5).add(0).add(4U).add_text("more").add(1);
  bytes.add(0).add(1.F).add(0.F).add(0.F).add(1.F).add(0.5F);
  bytes.add(0x10003U).add(3U).add(0U).add(2.F).add(3U).add_text("xyz").add(2U);
  for (const float x : {1.F, 2.F})
    bytes.add(x).add(2.F).add(3.F).add(0.F).add(0.F).add(0.F).add(1.F).add(0.25F).add(1500U);
  return bytes.text();
}

std::string isf() {
  constexpr char size = 28;
  return std::string(1, '\0') + size +
         std::string(
             "\x05\x01\x38\x11\x00\x00\xc8\x42\x0a\x12"
             "\x02\x08\x0a\x14\x08\x1e\xd8\x09\x19\xbf\xc0\x00\x00\x00\x00\x00\x00\x00\x00",
             28);
}

std::string remarkable_5() {
  Bytes bytes;
  bytes.add_text("reMarkable .lines file, version=5          ").add(2U).add(0U).add(1U);
  bytes.add(6U).add(0U).add(7U).add(2.F).add(9U).add(2U);
  for (const float x : {1.F, 2.F}) bytes.add(x).add(2.F).add(0.F).add(1.F).add(2.F).add(0.5F);
  return bytes.text();
}

std::string remarkable_6() {
  Bytes line;
  line.add(std::uint8_t{3}).add_varint(1 << 4 | 4).add(15U).add_varint(5 << 4 | 12).add(14U);
  line.add(1.F)
      .add(2.F)
      .add(std::uint16_t{0})
      .add(std::uint16_t{6})
      .add(std::uint8_t{0})
      .add(std::uint8_t{51});
  Bytes item;
  for (unsigned index = 1; index <= 4; ++index)
    item.add_varint(index << 4 | 15).add(std::uint8_t{1}).add_varint(index == 2 ? 10 : 0);
  item.add_varint(6 << 4 | 12).add(static_cast<std::uint32_t>(line.text().size())).add_text(line.text());
  Bytes file;
  file.add_text("reMarkable .lines file, version=6          ");
  file.add(static_cast<std::uint32_t>(item.text().size())).add_text(std::string_view("\0\1\2\5", 4));
  return file.add_text(item.text()).text();
}

std::vector<PenSeed> all_seeds() {
  return {
      {"uim", uim()},
      {"will", will()},
      {"tilt", tilt()},
      {"isf", isf()},
      {"remarkable", remarkable_5()},
      {"remarkable", remarkable_6()},
      {"excalidraw",
       R"({"type":"excalidraw","elements":[{"type":"freedraw","x":10,"y":20,"angle":1.5,"points":)"
       R"([[0,0],[4,0]],"pressures":[0.25,0]}]})"},
      {"point_lists", R"({"a":[[1,2,0.5,8],[3,4,0.5,16]],"b":[{"x":5,"y":6}]})"},
      {"scap", "#9 9\n@1\n{\n#0 0\n@1\n1 2 0.5\n3 4 0\n}\n"},
      {"inkml",
       R"(<ink xmlns="http://www.w3.org/2003/InkML"><definitions><context xml:id="c"><traceFormat>)"
       R"(<channel name="X" type="integer"/><channel name="Y" type="integer"/><channel name="F" max="255"/>)"
       R"(</traceFormat></context></definitions><trace contextRef="#c">32 635 27,'34'0'10,"0"0"2,-2 0-1</trace>)"
       R"(</ink>)"},
      {"xournal",
       R"(<xournal><page width="9" height="9"><layer><stroke tool="pen" width="1 2">1 2 3 4</stroke>)"
       R"(</layer></page></xournal>)"},
      {"svg", R"svg(<svg><g transform="scale(2)"><path d="M1 2 l3 4 C1 2 3 4 5 6 z"/></g></svg>)svg"},
      {"evemu",
       "# EVEMU 1.2\nN: A\nA: 00 0 100 0 0 10\nA: 01 0 100 0 0 10\nE: 0.01 0003 0000 20\nE: 0.01 0003 0001 "
       "20\nE: 0.01 0001 014a 1\nE: 0.01 0000 0000 0\n"},
      {"pointers", R"([{"pointers":[{"x":1,"y":2,"t":1500,"p":0.5},{"x":3,"y":4,"t":1516,"p":1}]}])"},
      {"csv", "stroke,x,y,time,pressure\n1,1,2,0,0.5\n2,3,4,8,1\n"},
  };
}

}  // namespace

std::span<const PenSeed> pen_seeds() {
  static const std::vector<PenSeed> seeds = all_seeds();
  return seeds;
}

}  // namespace burin::fuzz

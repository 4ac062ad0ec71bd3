// Pen files as their programs write them, shortened.
#include "pen_seeds.h"

#include <string_view>
#include <vector>

#include "ink/kinds/bytes.h"

namespace burin::fuzz {
namespace {

using test::Bytes;
using test::riff;
using test::zigzags;
using namespace std::string_view_literals;

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

std::string will_path() {
  const std::string path = Bytes()
                               .add_field(3, std::uint64_t{1})
                               .add_field(4, zigzags({10, 20, 5, -10, 300, 7}))
                               .add_field(5, zigzags({30, 1, 1}))
                               .text();
  return Bytes().add_varint(path.size()).add_text(path).text();
}

std::string will() { return riff("WILL", "INK ", will_path()); }

std::string tilt() {
  Bytes bytes;
  bytes.add(0xc576a5cdU).add(5).add(0).add(4U).add_text("more").add(1);
  bytes.add(0).add(1.F).add(0.F).add(0.F).add(1.F).add(0.5F);
  bytes.add(0x10003U).add(3U).add(0U).add(2.F).add(3U).add_text("xyz").add(2U);
  for (const float x : {1.F, 2.F})
    bytes.add(x).add(2.F).add(3.F).add(0.F).add(0.F).add(0.F).add(1.F).add(0.25F).add(1500U);
  return bytes.text();
}

/// A stream with these contents, fewer than 128 bytes.
std::string isf_stream(std::string_view content) {
  return std::string(1, '\0') + static_cast<char>(content.size()) + std::string(content);
}

std::string isf() {
  return isf_stream(
      "\x05\x01\x38\x11\x00\x00\xc8\x42\x0a\x12"
      "\x02\x08\x0a\x14\x08\x1e\xd8\x09\x19\xbf\xc0\x00\x00\x00\x00\x00\x00\x00"sv);
}

/// Three points with a status and two buttons each.
std::string isf_buttons() {
  return isf_stream(
      "\x05\x05\x35\x06\x02\x53\x55\x0a\x12\x03\x08\x00\x01\x02\x08\x00\x01\x02\x08\x00\x02\x00\x74"
      "\x00\x00\x00\x00"sv);
}

std::string remarkable_5() {
  Bytes bytes;
  bytes.add_text("reMarkable .lines file, version=5          ").add(2U).add(0U).add(1U);
  bytes.add(6U).add(0U).add(7U).add(2.F).add(9U).add(2U);
  for (const float x : {1.F, 2.F}) bytes.add(x).add(2.F).add(0.F).add(1.F).add(2.F).add(0.5F);
  return bytes.text();
}

/// A part of reMarkable's version 6 with its tag.
std::string remarkable_part(std::uint64_t index, const std::string& content) {
  Bytes bytes;
  bytes.add_varint(index << 4 | 12).add(static_cast<std::uint32_t>(content.size()));
  return bytes.add_text(content).text();
}

std::string remarkable_id(std::uint64_t index, std::uint64_t number) {
  Bytes bytes;
  return bytes.add_varint(index << 4 | 15).add(std::uint8_t{0}).add_varint(number).text();
}

std::string remarkable_block(char type, const std::string& content) {
  Bytes bytes;
  bytes.add(static_cast<std::uint32_t>(content.size())).add_text(std::string_view("\0\1\2", 3));
  return bytes.add(type).add_text(content).text();
}

/// A group beside typed text, in a layer.
std::string remarkable_text() {
  Bytes real, style, place;
  real.add_varint(2 << 4 | 4).add(-464.F);
  style.add(std::uint8_t{0}).add_varint(21);
  place.add(-400.0).add(200.0);
  const auto id = remarkable_id;
  const auto part = remarkable_part;
  const std::string piece = part(0, id(2, 20) + id(3, 0) + id(4, 0) + part(6, "\3\1a\nb")),
                    styles =
                        part(2, part(1, std::string("\1") + style.text() + id(1, 7) + part(2, "\x11\x04"))),
                    heads = id(2, 12) + id(3, 0) + id(4, 0);
  return remarkable_block(7, id(1, 0) + part(2, part(1, part(1, std::string("\1") + piece)) + styles) +
                                 part(3, place.text())) +
         remarkable_block(2, id(1, 0) + part(7, id(1, 5) + id(2, 22)) + part(10, id(1, 5) + real.text())) +
         remarkable_block(4, id(1, 1) + heads + part(6, std::string("\2") + id(2, 30))) +
         remarkable_block(4, id(1, 30) + heads + part(6, std::string("\2") + id(2, 0)));
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
      {"will", test::stored_zip({{"a/strokes.protobuf", will_path()}, {"b.protobuf", ""}})},
      {"tilt",
       std::string("tilT\x10\0\1\0\0\0\0\0\0\0\0\0", 16) + test::stored_zip({{"data.sketch", tilt()}})},
      {"inkml",
       R"(<ink><definitions><trace id="a">1 2 T</trace></definitions><context><traceFormat><channel name="X"/>)"
       R"(<channel name="Y" orientation="-ve"/><channel name="S" type="boolean"/><intermittentChannels>)"
       R"(<channel name="F" max="2" default="1"/></intermittentChannels></traceFormat></context>)"
       R"(<trace id="b" continuation="begin">1 2 T 1,3 4 F</trace><trace continuation="end" priorRef="#b">5 6 T)"
       R"(</trace><traceView traceDataRef="#a"/></ink>)"},
      {"svg",
       R"svg(<svg width="1in" height="9" viewBox="0 0 8 4" preserveAspectRatio="xMinYMax slice"><g)svg"
       R"svg( transform="skewX(9)"><path d="M0 0Q1 2 3 4T5 6A1 2 3 014 5S1 2 3 4H1V2"/></g></svg>)svg"},
      {"csv",
       "sep=;\n\"x (cm)\";y_px;t (ms);p (%);Tilt X (deg);note\n1,5;2;0;50;9;\"a;b\"\n\"3\";4;8;20,5;0;\n"},
      {"pointers",
       R"({"events":[{"pointerType":"PEN","points":[{"clientX":1,"x":2,"y":3,"force":1,"n":[]}]}]})"},
      {"uim", uim()},
      {"will", will()},
      {"tilt", tilt()},
      {"isf", isf()},
      {"isf", isf_buttons()},
      {"remarkable", remarkable_5()},
      {"remarkable", remarkable_6()},
      {"remarkable", remarkable_6() + remarkable_text()},
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
      {"inkml",
       R"(<ink><definitions><brush xml:id="b"><brushProperty name="tool" value="p&#233;n"/><brushProperty )"
       R"(name="eraser" value="true"/></brush><context xml:id="c" brushRef="#b"/></definitions>)"
       R"(<traceGroup brushRef="#b"><trace contextRef="#c">1 2,3 4</trace></traceGroup></ink>)"},
      {"xournal",
       R"(<xournal><page width="9" height="9"><layer><stroke tool="pen" width="1 2">1 2 3 4</stroke>)"
       R"(<timestamp ts="1" fn="a"/><text x="1" y="2">a</text><image left="1">QQ==</image></layer></page></xournal>)"},
      {"svg",
       R"svg(<svg><defs><path id="a" d="M1 2l3 4"/></defs><g style="transform:rotate(1rad)translateX(2px);)svg"
       R"svg(transform-origin:1px 2px"><use href="#a" x="5"/><rect/></g></svg>)svg"},
      {"svg",
       R"svg(<svg><switch><g requiredExtensions="a"><path d="M1 2l3 4"/></g><g systemLanguage="de, en-GB">)svg"
       R"svg(<path d="M5 6l7 8"/></g><path d="M9 9"/></switch></svg>)svg"},
      {"svg", R"svg(<svg><g transform="scale(2)"><path d="M1 2 l3 4 C1 2 3 4 5 6 z"/></g></svg>)svg"},
      {"evemu",
       "# EVEMU 1.2\nN: A\nA: 00 0 100 0 0 10\nA: 01 0 100 0 0 10\nE: 0.01 0003 0000 20\nE: 0.01 0003 0001 "
       "20\nE: 0.01 0001 014a 1\nE: 0.01 0000 0000 0\n"},
      {"evemu",
       "# EVEMU 1.3\nA: 35 0 100 0 0 10\nA: 36 0 100 0 0 10\nA: 3a 0 9 0 0\nE: 0.01 0003 0039 1\nE: 0.01 "
       "0003 0035 "
       "20\nE: 0.01 0003 0036 20\nE: 0.01 0003 003a 5\nE: 0.01 0000 0000 0\nE: 0.02 0003 002f 1\nE: 0.02 "
       "0003 0039 "
       "2\nE: 0.02 0003 0035 7\nE: 0.02 0003 0036 8\nE: 0.02 0000 0000 0\nE: 0.03 0003 0039 -1\nE: 0.03 0000 "
       "0000 0\n"},
      {"evemu",
       "# EVEMU 1.3\nA: 30 0 9 0 0\nA: 35 0 100 0 0 10\nA: 36 0 100 0 0 10\nE: 0.01 0003 0035 20\nE: 0.01 "
       "0003 "
       "0036 20\nE: 0.01 0000 0002 0\nE: 0.01 0003 0035 7\nE: 0.01 0003 0036 8\nE: 0.01 0000 0002 0\nE: 0.01 "
       "0000 0000 0\nE: 0.02 0003 0039 1\nE: 0.02 0003 0035 8\nE: 0.02 0003 0036 8\nE: 0.02 0000 0002 0\nE: "
       "0.02 0000 0000 0\nE: 0.03 0001 014b 1\nE: 0.03 0000 0002 0\nE: 0.03 0000 0000 0\n"},
      {"pointers", "{\"points\":[{\"x\":1,\"y\":2}]}\n{\"drawing\":[[[1,2],[3,4],[0,8]]]}\n"},
      {"pointers", R"([{"pointers":[{"x":1,"y":2,"t":1500,"p":0.5},{"x":3,"y":4,"t":1516,"p":1}]}])"},
      {"uim_json",
       R"({"inputData": {"inputContextData": {"sensorContexts": [{"sensorChannelsContext": [{"channels": [)"
       R"({"id": "x", "type": "a/X", "precision": 1}, {"id": "y", "type": "a/Y"},)"
       R"({"id": "t", "type": "a/Timestamp", "resolution": 1000}, {"id": "p", "type": "a/Pressure"},)"
       R"({"id": "l", "type": "a/Altitude", "precision": 2}, {"id": "z", "type": "a/Azimuth"}]}]}]},)"
       R"("sensorData": [{"timestamp": "1600000000500", "dataChannels": [)"
       R"({"sensorChannelID": "x", "values": [10, 20]}, {"sensorChannelID": "y", "values": [3, -1]},)"
       R"({"sensorChannelID": "t", "values": [0, 8]}, {"sensorChannelID": "l", "values": [100, 0]},)"
       R"({"sensorChannelID": "z", "values": [0, 0]}]}]}})"},
      {"hid",
       "R: 105 05 0d 09 02 a1 01 85 02 09 20 a1 00 09 42 09 44 09 45 09 32 15 00 25 01 75 01 95 04 81 02 95 "
       "04 81 03 05 01 09 30 09 31 65 11 55 0e 35 00 46 e8 03 26 d0 07 75 0c 95 02 81 02 05 0d 09 30 65 00 "
       "55 "
       "00 45 00 26 ff 03 75 10 95 01 81 02 09 3d 09 3e 65 14 15 c0 25 3f 35 c0 45 3f 75 08 95 02 81 02 85 "
       "03 "
       "09 3b 81 02 c0 c0\nN: A Pen\nE: 0.0 9 02 09 c8 00 19 ff 01 0a f6\nE: 0.01 9 02 0b 90 01 19 ff 03 00 "
       "00\n"},
      {"libinput",
       "libinput:\ndevices:\n- evdev:\n    name: A\n    absinfo:\n      0: [0, 100, 4, 0, 200]\n      24: "
       "[0, 255, "
       "0, 0, 0]\n  events:\n  - evdev:\n    - [0, 0, 3, 0, 20]\n    - [0, 0, 3, 1, 40]\n    - [0, 0, 3, 24, "
       "99]\n "
       "   - [0, 0, 1, 330, 1]\n    - [0, 0, 0, 0, 0]\n"},
      {"brush_stroke",
       R"(f(stroke=[{"name":'it\'s', "location":(0.1, 0.2, 0.3), "mouse":(10, 20), "pressure":0.5, "size":25,)"
       R"("pen_flip":False, "time":1.5, "is_start":True}, {'location':(0, 1, 2), "x_tilt": 0.5, 'y_tilt': 0,}]))"},
      {"csv", "idx,SPLINE_X,SPLINE_Y,SENSOR_TIMESTAMP,note\n0,1,2,3,\"a\nb\"\"\"\n1,5,6,7,\n"},
      {"csv", "stroke,x,y,tool\n1,1,2,\"a \"\"b\"\"\"\n1,3,4,pen\n"},
      {"csv", "stroke,x,y,barrel,eraser,note\n1,1,2,1,0,\"a\"\n2,3,4,0,1,\"b\nc\"\n"},
      {"csv", "stroke,x,y,time,pressure\n1,1,2,0,0.5\n2,3,4,8,1\n"},
  };
}

}  // namespace

std::span<const PenSeed> pen_seeds() {
  static const std::vector<PenSeed> seeds = all_seeds();
  return seeds;
}

}  // namespace burin::fuzz

#include "ink/pen_files.h"

namespace burin {
namespace {

using test::PenFileFolder;
using test::places;

std::string svg(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n<svg:svg xmlns:svg=\"http://www.w3.org/2000/svg\">\n" +
         content + "</svg:svg>\n";
}

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(ReadSvg, FollowsLines) {
  const PenFile file = PenFileFolder().read(svg(R"svg(<svg:g transform="translate(10,20) scale(2)">
    <path transform="rotate(90)" d="M1-2.5l1.5.5 2,3 H7v-1z m1 1 2 2M9 9"/></svg:g>
    <path d="none"/><polyline points="0,0 1,2 3 4"/><defs><path d="M0 0L5 5"/></defs>)svg"));
  ASSERT_EQ(file.strokes.size(), 3u) << "a move alone is none";
  EXPECT_EQ(file.strokes[0].samples.size(), 6u);
  EXPECT_EQ(places(file.strokes[0]), "15 22, 14 25, 8 29, 8 34, 10 34, 15 22");
  EXPECT_EQ(places(file.strokes[1]), "13 24, 9 28") << "a closed path leaves the pen at its start";
  EXPECT_EQ(places(file.strokes[2]), "0 0, 1 2, 3 4");
  EXPECT_EQ(file.strokes[0].fields, PenFields());
}

TEST(ReadSvg, LeavesOutWhatIsNotDrawn) {
  const PenFile file =
      PenFileFolder().read(svg(R"svg(<g style="fill:none;display:inline"><path d="M1 2L3 4"/></g>
    <g display="none"><path style="display:inline" d="M0 0L5 5"/></g><path display="block" style="fill:red; display : none" d="M0 0L6 6"/>
    <path style="display:none;display:inline" d="M5 6L7 8"/>)svg"));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "1 2, 3 4");
  EXPECT_EQ(places(file.strokes[1]), "5 6, 7 8");
}

TEST(ReadSvg, FollowsSkewsAndViews) {
  const std::string path = R"svg(<path d="M0 0L1 2"/>)svg";
  const auto placed = [&](const std::string& around, const std::string& end) {
    return places(PenFileFolder().read(around + path + end).strokes.at(0));
  };
  EXPECT_EQ(placed(R"svg(<svg><g transform="skewX(45)">)svg", "</g></svg>"), "0 0, 3 2");
  EXPECT_EQ(placed(R"svg(<svg><g transform="skewY(45)">)svg", "</g></svg>"), "0 0, 1 3");
  EXPECT_EQ(placed(R"svg(<svg width="1in" height="96" viewBox="-1 -2 48 24">)svg", "</svg>"), "2 28, 4 32");
  EXPECT_EQ(placed(R"svg(<svg width="96" height="96" viewBox="0,0,48,24" preserveAspectRatio="none">)svg",
                   "</svg>"),
            "0 0, 2 8");
  EXPECT_EQ(
      placed(R"svg(<svg width="96" height="96" viewBox="0 0 48 24" preserveAspectRatio="xMaxYMin slice">)svg",
             "</svg>"),
      "-96 0, -92 8");
  EXPECT_EQ(placed(R"svg(<svg width="100%" viewBox="5 5 8 8">)svg", "</svg>"), "0 0, 1 2")
      << "of an unknown size";
  EXPECT_EQ(
      placed(R"svg(<svg><svg x="10" y="20" width="8" height="8" viewBox="0 0 4 4">)svg", "</svg></svg>"),
      "10 20, 12 24");
}

TEST(ReadSvg, ShowsAgainWhatIsUsed) {
  const std::string defs = R"svg(<defs><path id="a" transform="scale(2)" d="M1 2L3 4"/><symbol id="s"><g>
    <line x2="1"/></g></symbol><g id="both"><use href="#a"/><use xlink:href="#s" x="5px"/></g></defs>)svg";
  const PenFile file = PenFileFolder().read(svg(defs + R"svg(<use href="#a" x="10" transform="scale(3)"/>
    <g visibility="hidden"><use href="#a"/></g><use href="#both" y="1"/><use href="#none"/>)svg"));
  ASSERT_EQ(file.strokes.size(), 3u);
  EXPECT_EQ(places(file.strokes[0]), "36 12, 48 24");
  EXPECT_EQ(places(file.strokes[1]), "2 5, 6 9");
  EXPECT_EQ(places(file.strokes[2]), "5 1, 6 1");
}

TEST(ReadSvg, ShowsSymbolsInTheSizeOfTheirUse) {
  const auto placed = [](const std::string& symbol, const std::string& use) {
    const std::string path = R"svg(<path d="M0 0L1 2"/>)svg";
    const PenFile file =
        PenFileFolder().read(svg("<" + symbol + ">" + path + "</" + symbol.substr(0, symbol.find(' ')) + ">" +
                                 "<use href=\"#a\" " + use + "/>"));
    return file.strokes.empty() ? "none" : places(file.strokes.back());
  };
  const std::string box = R"svg( id="a" viewBox="0 0 10 10")svg", size = R"svg( width="20" height="20")svg";
  EXPECT_EQ(placed("symbol" + box, R"svg(x="5" width="100" height="100")svg"), "5 0, 15 20");
  EXPECT_EQ(placed("symbol" + box + size, ""), "0 0, 2 4");
  EXPECT_EQ(placed("symbol" + box + size, R"svg(width="40")svg"), "10 0, 12 4")
      << "in the middle of the width";
  EXPECT_EQ(placed("symbol" + box, ""), "0 0, 1 2") << "of an unknown size";
  EXPECT_EQ(placed("svg" + box + size, R"svg(width="100" height="100")svg"), "0 0, 10 20");
  EXPECT_EQ(placed(R"svg(symbol id="a" transform="scale(5)")svg", R"svg(x="1")svg"), "1 0, 6 10");
  EXPECT_EQ(placed(R"svg(symbol id="a" display="none")svg", ""), "none");
}

TEST(ReadSvg, ShowsNothingForUsesOfNothing) {
  const std::string path = R"svg(<path id="a" d="M0 0L1 1"/>)svg";
  const PenFile file = PenFileFolder().read(svg(path + R"svg(<use href="#"/><use href="a"/><use/>)svg"));
  EXPECT_EQ(file.strokes.size(), 1u);
  const PenFile within =
      PenFileFolder().read(svg(path + R"svg(<use href="#a" x="2"><path d="M5 5L6 6"/></use>)svg"));
  ASSERT_EQ(within.strokes.size(), 2u) << "what is in a use is not drawn";
  EXPECT_EQ(places(within.strokes[1]), "2 0, 3 1");
}

TEST(ReadSvg, RefusesUsesWithoutEnd) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(svg(R"svg(<g id="a"><use href="#a"/></g>)svg")),
            "4: nested deeper than 300 elements, with those that use shows");
  std::string bomb = "<g id=\"g0\"><path d=\"M0 0L1 1\"/></g>";
  for (int i = 0; i < 30; ++i) {
    const std::string use = "<use href=\"#g" + std::to_string(i) + "\"/>";
    bomb += "<g id=\"g" + std::to_string(i + 1) + "\">" + use + use + "</g>";
  }
  EXPECT_EQ(folder.complaint(svg(bomb)), "4: more elements shown again than a file of this size may have");
}

TEST(ReadSvg, BoundsTheDepthThroughUses) {
  const auto nested = [](int groups) {
    std::string text = "<defs>";
    for (int i = 0; i < 20; ++i) {
      text += "<g id=\"g" + std::to_string(i) + "\">" + repeated("<g>", groups);
      text += "<use href=\"#g" + std::to_string(i + 1) + "\"/>" + repeated("</g>", groups + 1);
    }
    return svg(text + "<path id=\"g20\" d=\"M0 0L1 1\"/></defs><use href=\"#g0\"/>");
  };
  const PenFileFolder folder;
  EXPECT_EQ(folder.read(nested(12)).strokes.size(), 1u);
  EXPECT_EQ(folder.complaint(nested(13)), "4: nested deeper than 300 elements, with those that use shows");
}

TEST(ReadSvg, BoundsTheWorkOfUses) {
  const auto used = [](const std::string& element, int times) {
    return svg("<defs>" + element + "</defs>" + repeated("<use href=\"#a\"/>", times));
  };
  const std::string groups = "<g id=\"a\">" + repeated("<g/>", 1000) + "</g>",
                    moves = "<path id=\"a\" d=\"" + repeated("M0 0", 5000) + "\"/>";
  const PenFileFolder folder;
  for (const std::string& element : {groups, moves}) {
    EXPECT_EQ(folder.read(used(element, 100)).strokes.size(), 0u);
    EXPECT_EQ(folder.complaint(used(element, 300)),
              "4: more elements shown again than a file of this size may have");
  }
  const std::string curves = "<path id=\"a\" d=\"M0 0" + repeated("t1 1", 1000) + "\"/>";
  EXPECT_EQ(folder.read(used(curves, 20)).strokes.size(), 20u);
  EXPECT_EQ(folder.complaint(used(curves, 100)), "4: more points than a file of this size may show");
}

TEST(ReadSvg, NamesOtherShapes) {
  const PenFile file = PenFileFolder().read(svg(R"svg(<text>a</text><rect width="9" height="9"/>
    <path d="M1 2L3 4"/><rect/><circle r="3" style="display:none"/><defs><image/></defs>)svg"));
  EXPECT_EQ(file.strokes.size(), 1u);
  EXPECT_EQ(file.not_used, (std::vector<std::string>{"rect", "text"}));
}

TEST(ReadSvg, FollowsTransformsOfCss) {
  const auto placed = [&](const std::string& transform) {
    return places(
        PenFileFolder().read("<svg><g " + transform + "><path d=\"M0 0L1 2\"/></g></svg>").strokes.at(0));
  };
  EXPECT_EQ(placed(R"svg(style="fill:none; transform: translate(1in, -2.5px) scale(2,3) !important")svg"),
            "96 -2.5, 98 3.5");
  EXPECT_EQ(placed(R"svg(style="transform:rotate(0.25turn)" transform="scale(9)")svg"), "0 0, -2 1")
      << "instead of the attribute";
  EXPECT_EQ(placed(R"svg(style="transform:translateX(4px)translateY(5px)skew(45deg)")svg"), "4 5, 7 7");
  EXPECT_EQ(placed(R"svg(style="transform:scaleX(2) scaleY(-1);transform-origin:1px 2px")svg"), "-1 4, 1 2");
  EXPECT_EQ(placed(R"svg(style="transform:none" transform="scale(9)")svg"), "0 0, 1 2");
  EXPECT_EQ(placed(R"svg(transform="translate(3-4)rotate(90 1,1)")svg"), "5 -4, 3 -3");
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(svg(R"svg(<g style="transform:translate(50%)"/>)svg")),
            "4: expected a number, found '50%'");
  EXPECT_EQ(folder.complaint(svg(R"svg(<g style="transform:rotateX(3deg)"/>)svg")),
            "4: a transform that is not known: 'rotateX'");
  EXPECT_EQ(folder.complaint(svg(R"svg(<g style="transform:scale(2);transform-origin:center"/>)svg")),
            "4: a transform-origin that is not two lengths: 'center'");
  EXPECT_EQ(folder.complaint(svg(R"svg(<g style="transform:scale(2);transform-origin:10px"/>)svg")),
            "4: a transform-origin that is not two lengths: '10px'");
  EXPECT_EQ(placed(R"svg(style="transform-origin:center")svg"), "0 0, 1 2") << "of no transform";
  EXPECT_EQ(placed(R"svg(style="transform:none;transform-origin:center")svg"), "0 0, 1 2");
  EXPECT_EQ(placed(R"svg(style="transform:scale(2);transform-origin:1px 2px !important")svg"), "-1 -2, 1 2");
}

TEST(ReadSvg, LeavesOutWhatIsInvisible) {
  const PenFile file = PenFileFolder().read(svg(R"svg(<g visibility="hidden"><path d="M1 2L3 4"/>
    <path visibility="visible" d="M5 6L7 8"/></g><g style="visibility:collapse"><line x2="1"/></g>
    <line x1="1" y1="2" x2="1e1"/>)svg"));
  ASSERT_EQ(file.strokes.size(), 2u);
  EXPECT_EQ(places(file.strokes[0]), "5 6, 7 8");
  EXPECT_EQ(places(file.strokes[1]), "1 2, 10 0");
}

TEST(ReadSvg, ShowsTheFirstBranchOfASwitchThatApplies) {
  const auto shown = [](const std::string& branches) {
    std::string lines;
    for (const PenStroke& stroke : PenFileFolder().read(svg(branches)).strokes)
      lines += places(stroke) + "; ";
    return lines;
  };
  const std::string a = "<path d=\"M1 2L3 4\"/>", b = "<path d=\"M5 6L7 8\"/>";
  EXPECT_EQ(shown("<switch> some text " + a + b + "</switch>"), "1 2, 3 4; ");
  // As illustration programs write it, with what they alone read in front.
  EXPECT_EQ(shown("<switch><foreignObject requiredExtensions=\"http://ns.adobe.com/x/\" width=\"1\">" + a +
                  "</foreignObject><g>" + b + b + "</g></switch>"),
            "5 6, 7 8; 5 6, 7 8; ");
  EXPECT_EQ(shown("<switch><g systemLanguage=\"de, fr\">" + a + "</g><g systemLanguage=\"de,EN-gb\">" + b +
                  "</g><g>" + a + "</g></switch>"),
            "5 6, 7 8; ");
  EXPECT_EQ(shown("<switch><g display=\"none\">" + a + "</g>" + b + "</switch>" + a), "1 2, 3 4; ")
      << "the first applies, and shows nothing";
  EXPECT_EQ(shown("<g systemLanguage=\"de\">" + a + "</g><g systemLanguage=\"en\">" + b + "</g>" + a),
            "5 6, 7 8; 1 2, 3 4; ")
      << "outside a switch too";
}

// As illustration programs write it.
TEST(ReadSvg, PassesOverTheTypeOfTheDocument) {
  const PenFile file = PenFileFolder().read(
      R"(<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd" [
      <!ENTITY ns_svg "http://www.w3.org/2000/svg"> <!-- [x] > --> <!ENTITY b "[]">
      ] ><svg xmlns="&ns_svg;"><path d="M1 2L3 4"/></svg>)");
  EXPECT_EQ(file.kind, "svg");
  EXPECT_EQ(places(file.strokes.at(0)), "1 2, 3 4");
  EXPECT_NE(PenFileFolder().complaint("<!DOCTYPE svg [<!ENTITY a \"x\"> <svg/>"), "accepted");
}

TEST(ReadSvg, GivesChordsOfCurves) {
  const PenFile file = PenFileFolder().read(svg(
      R"(<path d="M0 0C0 8 8 8 8 0S16-8 16 0"/><path d="M0,0Q4,8 8,0T16,0"/><path d="M-5 0A5 5 0 015 0"/>)"));
  ASSERT_EQ(file.strokes.size(), 3u);
  ASSERT_EQ(file.strokes[0].samples.size(), 17u);
  EXPECT_EQ(file.strokes[0].samples[4].position, Vec3d(4, 6, 0));
  EXPECT_EQ(file.strokes[0].samples[12].position, Vec3d(12, -6, 0));
  EXPECT_EQ(file.strokes[1].samples[4].position, Vec3d(4, 4, 0));
  EXPECT_EQ(file.strokes[1].samples[12].position, Vec3d(12, -4, 0));
  ASSERT_EQ(file.strokes[2].samples.size(), 9u);
  for (const Sample& sample : file.strokes[2].samples) EXPECT_NEAR(sample.position.norm(), 5, 1e-12);
  EXPECT_NEAR(file.strokes[2].samples[4].position.y(), -5, 1e-12) << "clockwise on the screen";
}

TEST(ReadSvg, HidesWhatItsStyleSheetsHide) {
  const PenFile file = PenFileFolder().read(
      R"(<svg><style>/* .c {display:none} */ @media print {.c{display:none}} .a, g.b {fill:none; display : none}
.c{stroke:#000} #d, line {visibility:hidden} path .c {display:none}</style>
<style><![CDATA[.e{transform:translate(10px,0)} .f{display:none}]]></style>
<path class="x a" d="M1 1L2 2"/><g class="b"><path d="M1 1L2 2"/></g><path class="b c" d="M3 3L4 4"/>
<path id="d" d="M1 1L2 2"/><line x2="5"/><path class="e" d="M5 5L6 6"/>
<path class="f" style="display:inline" d="M7 7L8 8"/></svg>)");
  std::string drawn;
  for (const PenStroke& stroke : file.strokes) drawn += places(stroke) + "; ";
  EXPECT_EQ(drawn, "3 3, 4 4; 15 5, 16 6; 7 7, 8 8; ");
}

TEST(ReadSvg, RefusesStyleSheetsThatSayFarTooMuch) {
  std::string selectors, comments, elements;
  for (int i = 0; i < 20'000; ++i) selectors += ".a" + std::to_string(i) + ",";
  for (int i = 0; i < 200'000; ++i) comments += "/**/";
  for (int i = 0; i < 20'000; ++i) elements += "<g/>";
  const auto complaint = [](const std::string& sheet, const std::string& rest) {
    return PenFileFolder().complaint("<svg><style>" + sheet + "</style>" + rest + "</svg>");
  };
  const std::string fault = "1: style sheets that say more than pictures need";
  const std::string rules = selectors + ".b{display:none}";
  EXPECT_EQ(complaint(rules, elements), fault);
  EXPECT_EQ(complaint(selectors + ".b{display:" + std::string(2000, 'x') + "}", ""), fault);
  EXPECT_EQ(complaint(rules, "<g class='" + std::string(100'000, 'c') + "'/>"), fault);
  EXPECT_EQ(complaint(comments + rules, "<path class='c' d='M0 0L1 1'/>"), "accepted");
}

TEST(ReadSvg, NamesTheLineOfAFault) {
  const PenFileFolder folder;
  EXPECT_EQ(folder.complaint(svg("<path d=\"M0 0L1\"/>")), "4: expected a number in a path, found ''");
  EXPECT_EQ(folder.complaint(svg("\n<path d=\"M0 0X\"/>")), "5: no command of a path: 'X'");
  EXPECT_EQ(folder.complaint(svg("<g transform=\"spin(3)\"/>")), "4: a transform that is not known: 'spin'");
  EXPECT_EQ(folder.complaint(svg("<g transform=\"rotate(3 a)\"/>")), "4: expected a number, found 'a'");
}

}  // namespace
}  // namespace burin

#include <burin/base/error.h>
#include <burin/stamp/files/stamp_channels.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace burin {
namespace {

using Names = std::vector<std::string>;

/// The names of the channels that are used, in order; what is complained of where there are none.
Names chosen(const Names& names, const std::string& layer = {}, const std::string& channel = {}) {
  try {
    const ChannelChoice choice = choose_channels(names, layer, channel);
    Names used;
    for (const std::size_t i : choice.used) used.push_back(names[i]);
    EXPECT_EQ(choice.used.size() + choice.unused.size(), names.size());
    return used;
  } catch (const Error& error) {
    return {error.what()};
  }
}

TEST(ChooseChannels, TakesTheOnlyOneWhateverItsName) {
  for (const char* name : {"Y", "Z", "R", "height", "layer.depth", "A"})
    EXPECT_EQ(chosen({name}), Names{name});
}

TEST(ChooseChannels, TakesVectorsInTheOrderOfTheirAxesNotOfTheAlphabet) {
  for (const Names& right :
       {Names{"R", "G", "B"}, Names{"r", "g", "b"}, Names{"X", "Y", "Z"}, Names{"dispR", "dispG", "dispB"},
        Names{"vdm.x", "vdm.y", "vdm.z"}, Names{"disp_red", "disp_green", "disp_blue"},
        Names{"Red", "Green", "Blue"}, Names{"a.b.R", "a.b.G", "a.b.B"},
        Names{"colourR", "colourG", "colourB"}, Names{"R", "G", "B", "A"},
        Names{"dispR", "dispG", "dispB", "dispA"}, Names{"n.red", "n.green", "n.blue", "n.alpha"}}) {
    Names order = right;
    std::ranges::sort(order);
    do EXPECT_EQ(chosen(order), right);
    while (std::ranges::next_permutation(order).found);
  }
}

TEST(ChooseChannels, TakesGreyBesideAlpha) {
  EXPECT_EQ(chosen({"A", "Y"}), Names{"Y"});
  EXPECT_EQ(chosen({"Background.Y", "Background.A"}), Names{"Background.Y"});
  EXPECT_EQ(chosen({"alpha", "height"}), Names{"height"});
  EXPECT_EQ(chosen({"Y", "A", "Z"}), Names{"Y"});
}

TEST(ChooseChannels, PrefersWhatHasNoLayerAndNoPrefix) {
  EXPECT_EQ(chosen({"B", "G", "R", "depth.Z", "n.X", "n.Y", "n.Z"}), (Names{"R", "G", "B"}));
  EXPECT_EQ(chosen({"B", "G", "R", "Z"}), (Names{"R", "G", "B"}));
  EXPECT_EQ(chosen({"B", "G", "R", "normalX", "normalY", "normalZ"}), (Names{"R", "G", "B"}));
}

TEST(ChooseChannels, RefusesWhatIsNotClear) {
  const std::string rest = "; a channel, or three, can be chosen by name";
  EXPECT_EQ(chosen({"RY", "BY", "Y"}),
            Names{"holds the channels 'RY', 'BY', 'Y': they are luminance and chroma, neither heights nor "
                  "vectors" +
                  rest});
  EXPECT_EQ(chosen({"A", "B", "C"}),
            Names{"holds the channels 'A', 'B', 'C': none of its channels stands out "
                  "as the heights, and no three as a vector" +
                  rest});
  EXPECT_EQ(chosen({"R", "G"}), Names{"holds the channels 'R', 'G': none of its channels stands out as the "
                                      "heights, and no three as a vector" +
                                      rest});
  EXPECT_EQ(
      chosen({"aR", "aG", "aB", "bR", "bG", "bB"}),
      Names{"holds the channels 'aR', 'aG', 'aB', 'bR', 'bG', 'bB': several of its channels are vectors" +
            rest});
  EXPECT_EQ(
      chosen({"R", "G", "B", "X", "Y", "Z"}),
      Names{"holds the channels 'R', 'G', 'B', 'X', 'Y', 'Z': several of its channels are vectors" + rest});
  EXPECT_EQ(chosen({"a.R", "a.G", "a.B", "b.Y"}),
            Names{"holds several layers, of which one must be chosen by its name: 'a', 'b'"});
}

TEST(ChooseChannels, TakesTheLayerThatIsAskedFor) {
  const Names names = {"V.Combined.B", "V.Combined.G", "V.Combined.R", "V.Depth.Z",
                       "V.Normal.X",   "V.Normal.Y",   "V.Normal.Z",   "W.Mist.Z"};
  EXPECT_EQ(chosen(names, "V.Combined"), (Names{"V.Combined.R", "V.Combined.G", "V.Combined.B"}));
  EXPECT_EQ(chosen(names, "Normal"), (Names{"V.Normal.X", "V.Normal.Y", "V.Normal.Z"}));
  EXPECT_EQ(chosen(names, "W"), Names{"W.Mist.Z"});
  EXPECT_EQ(chosen(names, "V"), Names{"holds several layers, of which one must be chosen by its name: "
                                      "'V.Combined', 'V.Depth', 'V.Normal'"});
  EXPECT_EQ(chosen(names, "x\x1b[2J"), Names{"has no layer 'x\\x1b[2J'; there are: 'V.Combined', 'V.Depth', "
                                             "'V.Normal', 'W.Mist'"});
}

TEST(ChooseChannels, TakesTheChannelsThatAreAskedFor) {
  EXPECT_EQ(chosen({"RY", "BY", "Y"}, "", "Y"), Names{"Y"});
  EXPECT_EQ(chosen({"a.R", "b.Y", "c,d"}, "", "c,d"), Names{"c,d"});
  EXPECT_EQ(chosen({"a.R", "b.R"}, "b", "R"), Names{"b.R"});
  EXPECT_EQ(chosen({"a.R", "b.R"}, "b", "a.R"), Names{"a.R"});
  EXPECT_EQ(chosen({"1", "2", "3", "4"}, "", "3,1,2"), (Names{"3", "1", "2"}));
  EXPECT_EQ(chosen({"1", "2"}, "", "1,2"), Names{"cannot be read by 2 channels; a stamp has 1, 3 or 4"});
  EXPECT_EQ(chosen({"1", "2"}, "", "r"), Names{"has no channel 'r'; there are: '1', '2'"});
}

TEST(ChooseChannels, ComplainsInALineOfBoundedLength) {
  Names names;
  for (int i = 0; i < 5000; ++i) names.push_back(std::to_string(i) + std::string(300, 'n'));
  EXPECT_LT(chosen(names)[0].size(), 1500u);
}

}  // namespace
}  // namespace burin

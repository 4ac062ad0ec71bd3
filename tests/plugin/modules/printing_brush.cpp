// org.burin.test.printing: writes to the standard output, by every way there is, and draws nothing.
#include <burin/plugin/plugin.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace {

using namespace burin::plugin;

class PrintingBrush : public Brush {
 public:
  static constexpr BrushInfo info{
      .id = "org.burin.test.printing", .name = "Printing", .vendor = "Burin", .version = "1.0.0"};

  PrintingBrush() {
    std::puts("by stdio");
    std::cout << "by streams" << std::endl;
    constexpr char text[] = "by the system\n";
    if (write(STDOUT_FILENO, text, sizeof(text) - 1) < 0) std::perror("write");
  }

  void evaluate(const Batch& in, const Outputs& out) const override {
    for (std::size_t i = 0; i < in.size(); ++i) out.up()[i] = 0;
  }
};

}  // namespace

BURIN_PLUGIN(PrintingBrush);

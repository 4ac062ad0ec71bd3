// Lets an exception out of a function that says that it throws none.
#include <string>
static char last_letter(const char* text) noexcept {
  const std::string letters = text;
  return letters.size() > 1000 ? letters.at(letters.size()) : ' ';
}
#define IN_BEGIN (void)last_letter(start.params[text])
#include "../good_cpp.h"

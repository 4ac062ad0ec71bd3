// Implements the host's service burin.lettering/1.
#include <burin/host/plugin/utf8_path.h>
#include <burin/services/service_tables.h>
#include <burin/stamp/lettering/font_search.h>
#include <burin/stamp/lettering/lettering.h>

#include <utility>

namespace burin {
namespace {

burin_lettering_info info_of(const Lettering& lettering) {
  return {.struct_size = 0,
          .width = lettering.width,
          .ascent = lettering.ascent,
          .descent = lettering.descent,
          .left = lettering.left,
          .right = lettering.right,
          .bottom = lettering.bottom,
          .top = lettering.top};
}

burin_status BURIN_CALL set(const burin_host* host, const char* font, const char* text, std::uint32_t em,
                            burin_stamp* stamp, burin_lettering_info* info, burin_text* error) {
  if (!font || !text || !stamp || em < min_em || em > max_em) return BURIN_INVALID_ARGUMENT;
  return status_of(error, [&] {
    Lettering lettering = set_lettering(find_font(path_from_utf8(font)), text, em);
    stamp->handle = stamps_of(host).add(std::move(lettering.image));
    fill_known_members(info_of(lettering), info);
  });
}

}  // namespace

constexpr burin_lettering lettering_service{sizeof(burin_lettering), 0, set};

}  // namespace burin

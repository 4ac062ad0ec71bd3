// Steps of undo that applications hold, for C.
#include <burin/host/c/call.h>
#include <burin/host/c/handles.h>
#include <burin/host/session.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

struct burin_step {
  burin::StrokeStep step;
};

using namespace burin;

burin_status burin_session_take_step(burin_session* session, burin_step** step, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(step, "step");
    if (session->stroke) c::reject("a stroke is open");
    auto made = std::make_unique<burin_step>();
    std::optional<StrokeStep> taken = session->session.take_step();
    if (!taken) throw plugin::Error("there is no stroke to undo", BURIN_NOT_FOUND);
    made->step = std::move(*taken);
    *step = made.release();
  });
}

burin_status burin_session_apply_step(burin_session* session, burin_step* step, burin_text* error) {
  return c::in_session(session, error, [&] {
    c::require(step, "step");
    if (session->stroke) c::reject("a stroke is open");
    try {
      session->session.apply(step->step);
    } catch (const Error& fault) {
      c::reject(fault.what());
    }
    session->note_changed();
  });
}

void burin_step_destroy(burin_step* step) { delete step; }

burin_status burin_step_get_info(const burin_step* step, burin_step_info* info, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(step, "step");
    const burin_step_info known{.struct_size = 0,
                                .reserved = 0,
                                .bytes = step->step.bytes(),
                                .saved_bytes = saved_bytes(step->step),
                                .vertex_count = step->step.vertices.size(),
                                .painted_count = step->step.painted_vertices.size()};
    c::give(known, info, info && BURIN_HAS(info, burin_step_info, painted_count), "info");
  });
}

burin_status burin_step_save(const burin_step* step, void* bytes, uint64_t capacity, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(step, "step");
    c::require(bytes, "bytes");
    if (capacity < saved_bytes(step->step)) c::reject("the step does not fit");
    std::ranges::copy(saved_step(step->step), static_cast<std::byte*>(bytes));
  });
}

burin_status burin_step_load(const void* bytes, uint64_t size, burin_step** step, burin_text* error) {
  return plugin::guarded(error, [&] {
    c::require(bytes, "bytes");
    c::require(step, "step");
    *step = new burin_step{loaded_step({static_cast<const std::byte*>(bytes), size})};
  });
}

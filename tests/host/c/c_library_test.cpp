// Brush libraries of libburin.so, and what the file itself shows to others.
#include <burin/base/file.h>
#include <burin/version.h>
#include <gtest/gtest.h>

#include <oneapi/tbb/version.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <regex>
#include <set>

#include "c_host.h"
#include "house/all_matches.h"
#include "sanitizers/sanitized.h"
#include "support/process.h"
#include "support/shared_data.h"
#include "tbb_arrivals.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The functions that a header declares for libburin.so.
Names declared(const fs::path& header) {
  static const std::regex function(R"(BURIN_API [^;]*?BURIN_CALL\s+(burin_\w+)\()");
  return all_matches<Names>(read_file(header), function);
}

TEST(CLibraryFile, ShowsTheFunctionsOfItsHeadersAndNothingElse) {
  const ProcessResult result = run_process({"nm", "-D", "--defined-only", "--format=posix", BURIN_C_LIBRARY});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  Names shown;
  std::istringstream lines(result.out);
  for (std::string name, rest; lines >> name && std::getline(lines, rest);)
    if (name != "BURIN_0") shown.insert(name.substr(0, name.find('@')));
  Names expected = declared(fs::path(BURIN_SDK) / "burin/host/c/burin.h");
  EXPECT_GE(expected.size(), 25u);
  expected.merge(declared(fs::path(BURIN_SDK) / "burin/host/recorder.h"));
  EXPECT_EQ(shown, expected);
}

TEST(CLibraryFile, HasItsMajorVersionInItsName) {
  const ProcessResult result = run_process({"readelf", "-d", BURIN_C_LIBRARY});
  EXPECT_NE(result.out.find("[libburin.so." + std::to_string(BURIN_C_MAJOR) + "]"), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("SYMBOLIC"), std::string::npos);
}

TEST(CLibraryFile, TellsItsVersion) {
  auto info = sized<burin_version_info>();
  CText error;
  ASSERT_EQ(IN_C(burin_get_version)(&info, &error), BURIN_OK);
  EXPECT_EQ(info.struct_size, sizeof info);
  EXPECT_EQ(info.major, BURIN_C_MAJOR);
  EXPECT_EQ(info.minor, BURIN_C_MINOR);
  EXPECT_EQ(info.abi_major, BURIN_ABI_MAJOR);
  EXPECT_STREQ(info.text, BURIN_VERSION);
}

/// A stroke of a library that is one of several in the process, sample by sample.
class OneOfSeveral {
 public:
  OneOfSeveral(const fs::path& file, const TriangleMesh& mesh, int flags = 0)
      : functions_(file.string(), flags) {
    check(
        functions_.find<decltype(burin_library_create)>("burin_library_create")(nullptr, &library_, &error_));
    check(functions_.find<decltype(burin_library_load)>("burin_library_load")(
        library_, brushes_folder.c_str(), &error_));
    const burin_mesh arrays = arrays_of(mesh);
    check(functions_.find<decltype(burin_session_create)>("burin_session_create")(library_, &arrays,
                                                                                  &session_, &error_));
    const char* const settings[] = {"brush=org.burin.groove", "radius=0.15", nullptr};
    auto stroke = sized<burin_stroke>();
    stroke.settings = settings;
    check(functions_.find<decltype(burin_session_begin)>("burin_session_begin")(session_, &stroke, &error_));
  }
  void add(const burin_sample& sample) {
    check(functions_.find<decltype(burin_session_add)>("burin_session_add")(session_, &sample, 1, nullptr,
                                                                            &error_));
  }
  std::uint64_t end() {
    std::uint64_t hash = 0;
    check(functions_.find<decltype(burin_session_end)>("burin_session_end")(session_, &error_));
    check(functions_.find<decltype(burin_session_hash)>("burin_session_hash")(session_, &hash, &error_));
    functions_.find<decltype(burin_session_destroy)>("burin_session_destroy")(session_);
    functions_.find<decltype(burin_library_destroy)>("burin_library_destroy")(library_);
    return hash;
  }
  const void* address() const {
    return reinterpret_cast<const void*>(functions_.find<decltype(burin_session_add)>("burin_session_add"));
  }

 private:
  void check(burin_status status) {
    if (status != BURIN_OK) throw std::runtime_error(error_.str());
  }

  CLibrary functions_;
  CText error_;
  burin_library* library_ = nullptr;
  burin_session* session_ = nullptr;
};

TEST(CLibraryFile, MayBeInAProcessSeveralTimes) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = shuffled(plane(1, 0.04, 4), 5);
  Session expected(make_surface(mesh), brushes());
  StrokeSettings groove = settings("org.burin.groove");
  groove.fields = {};
  draw(expected, groove, without_pen(wave()));
  for (const char* name : {"a.so", "b.so"}) fs::copy(BURIN_C_LIBRARY, folder.path() / name);
  OneOfSeveral a(folder.path() / "a.so", mesh), b(folder.path() / "b.so", mesh);
  EXPECT_NE(a.address(), b.address());
  for (const burin_sample& sample : in_c(wave())) {
    a.add(sample);
    b.add(sample);
  }
  EXPECT_EQ(a.end(), expected.result_hash());
  EXPECT_EQ(b.end(), expected.result_hash());
}

/// Writes a copy of a file in which a name is another one of the same length.
void copy_renamed(const fs::path& from, const fs::path& to, const std::string& name,
                  const std::string& other) {
  std::string bytes = read_file(from);
  std::size_t renamed = 0;
  for (std::size_t at = bytes.find(name); at != std::string::npos; at = bytes.find(name, at), ++renamed)
    bytes.replace(at, name.size(), other);
  EXPECT_GT(renamed, 0u);
  std::ofstream(to, std::ios::binary) << bytes;
}

/// The file of the oneTBB that this program uses.
fs::path file_of_tbb() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&TBB_runtime_version), &info) == 0)
    throw std::runtime_error("no oneTBB");
  return fs::canonical(info.dli_fname);
}

TEST(CLibraryFile, LivesInAProcessWithAnotherOneTBB) {
  if (test::sanitized) GTEST_SKIP() << "sanitizers do not allow RTLD_DEEPBIND";
  const TemporaryFolder folder;
  const fs::path tbb = folder.path() / "libtbo.so.12", burin = folder.path() / "a.so";
  copy_renamed(file_of_tbb(), tbb, "libtbb.so.12", "libtbo.so.12");
  copy_renamed(BURIN_C_LIBRARY, burin, "libtbb.so.12", "libtbo.so.12");
  const CLibrary other(tbb);
  EXPECT_NE(reinterpret_cast<const void*>(other.find<decltype(TBB_runtime_version)>("TBB_runtime_version")),
            reinterpret_cast<const void*>(&TBB_runtime_version));
  const TriangleMesh mesh = shuffled(plane(1, 0.01, 4), 5);
  StrokeSettings groove = settings("org.burin.groove");
  groove.fields = {};
  const auto drawn_by_this_program = [&] {
    Session session(make_surface(mesh), brushes());
    draw(session, groove, without_pen(wave()));
    return session.result_hash();
  };
  std::uint64_t hash = 0;
  const int arrivals = CountedArena().arrivals_during([&] {
    OneOfSeveral apart(burin, mesh, RTLD_DEEPBIND);
    for (const burin_sample& sample : in_c(without_pen(wave()))) apart.add(sample);
    hash = apart.end();
  });
  EXPECT_EQ(arrivals, 0) << "it works with its own";
  EXPECT_EQ(hash, drawn_by_this_program());
  EXPECT_TRUE(CountedArena().arrive_at(drawn_by_this_program)) << "the program goes on with its own";
}

/// Lines of a log, with their severities.
struct Log {
  static void BURIN_CALL write(void* user, burin_log_severity severity, const char* line) {
    auto& log = *static_cast<Log*>(user);
    const std::lock_guard lock(log.mutex);
    log.lines.push_back(std::to_string(severity) + " " + line);
  }
  std::mutex mutex;
  std::vector<std::string> lines;
};

/// What burin_library_create answers to options.
struct Created {
  burin_status status;
  std::string text;
};

TEST(CIsolation, TakesOnlyOptionsThatMakeSense) {
  const auto create = [](double seconds, std::uint32_t isolate) {
    auto options = sized<burin_library_options>();
    options.isolate = isolate;
    options.batch_seconds = seconds;
    burin_library* library = nullptr;
    CText error;
    const burin_status status = IN_C(burin_library_create)(&options, &library, &error);
    IN_C(burin_library_destroy)(library);
    return Created{status, status == BURIN_OK ? "" : error.str()};
  };
  EXPECT_EQ(create(0, 1).status, BURIN_OK);
  EXPECT_EQ(create(INFINITY, 1).status, BURIN_OK);
  for (const double seconds : {-1.0, static_cast<double>(NAN)}) {
    EXPECT_EQ(create(seconds, 1).status, BURIN_INVALID_ARGUMENT);
    EXPECT_EQ(create(seconds, 1).text, "batch_seconds is not above 0");
  }
  EXPECT_EQ(create(0, 2).text, "isolate is neither 0 nor 1");
}

class CBrushes : public ::testing::Test {
 protected:
  CBrushes() {
    auto options = sized<burin_library_options>();
    options.log = Log::write;
    options.user = &log_;
    EXPECT_EQ(IN_C(burin_library_create)(&options, &library_, &error_), BURIN_OK) << error_.str();
  }
  ~CBrushes() override { IN_C(burin_library_destroy)(library_); }

  burin_status load(const fs::path& path) {
    return IN_C(burin_library_load)(library_, path.c_str(), &error_);
  }
  std::uint64_t count() const { return IN_C(burin_library_brush_count)(library_); }

  /// Whether the first brush has a parameter of this id.
  bool has_param(std::string_view id) const {
    const burin_brush_descriptor* brush = IN_C(burin_library_brush)(library_, 0);
    return std::any_of(brush->params, brush->params + brush->param_count,
                       [&](const burin_param_info* param) { return param->id == id; });
  }

  Log log_;
  burin_library* library_ = nullptr;
  CText error_;
};

TEST_F(CBrushes, PassOverAPluginThatIsBrokenAndLoadTheOthers) {
  const TemporaryFolder folder;
  fs::copy(brushes_folder / "bead.burin", folder.path());
  fs::copy(brushes_folder / "rope.burin", folder.path());
  fs::copy(test_plugins_folder / "broken_descriptor.burin", folder.path() / "c.burin");
  EXPECT_EQ(load(folder.path()), BURIN_OK) << error_.str();
  EXPECT_EQ(count(), 2u);
  ASSERT_EQ(IN_C(burin_library_refused_count)(library_), 1u);
  const std::string why = IN_C(burin_library_refused)(library_, 0);
  EXPECT_EQ(why.find((folder.path() / "c.burin").string()), 0u) << why;
  EXPECT_EQ(IN_C(burin_library_refused)(library_, 1), nullptr);
  EXPECT_EQ(log_.lines, std::vector<std::string>{"3 " + why});
  EXPECT_EQ(load(test_plugins_folder / "broken_descriptor.burin"), BURIN_ERROR) << "by itself it fails";
  EXPECT_NE(error_.str(), "");
  EXPECT_EQ(load(folder.path() / "none"), BURIN_ERROR);
  EXPECT_EQ(count(), 2u);
}

TEST_F(CBrushes, ComeWithTheLibraryAndDescribeTheirPanels) {
  EXPECT_EQ(IN_C(burin_library_load)(library_, nullptr, &error_), BURIN_OK) << error_.str();
  EXPECT_GE(count(), 18u);
  Names ids;
  for (std::uint64_t i = 0; i < count(); ++i) {
    const burin_brush_descriptor* brush = IN_C(burin_library_brush)(library_, i);
    ids.insert(brush->id);
    for (std::uint32_t k = 0; k < brush->param_count; ++k) EXPECT_NE(brush->params[k]->name, nullptr);
  }
  EXPECT_EQ(IN_C(burin_library_brush)(library_, count()), nullptr);
  EXPECT_TRUE(ids.contains("org.burin.groove"));
  EXPECT_EQ(ids.size(), count());
}

TEST(CIsolation, CostsABrushThatCrashesItsStroke) {
  auto options = sized<burin_library_options>();
  options.isolate = 1;
  options.batch_seconds = 10;
  burin_library* library = nullptr;
  burin_session* session = nullptr;
  CText error;
  ASSERT_EQ(IN_C(burin_library_create)(&options, &library, &error), BURIN_OK) << error.str();
  const std::string module = BURIN_FAILING_BRUSHES "/failing.burin";
  ASSERT_EQ(IN_C(burin_library_load)(library, module.c_str(), &error), BURIN_OK) << error.str();
  const TriangleMesh mesh = plane(1, 0.04, 4);
  const burin_mesh arrays = arrays_of(mesh);
  ASSERT_EQ(IN_C(burin_session_create)(library, &arrays, &session, &error), BURIN_OK) << error.str();
  const std::vector<burin_sample> samples = in_c(without_pen(wave(5)));
  for (const auto& [fault, status] :
       {std::pair("params=text=evaluate:crash", BURIN_ERROR), std::pair("params=text=none", BURIN_OK)}) {
    const char* const settings[] = {"brush=org.burin.test.failing", "radius=0.15", fault, nullptr};
    auto stroke = sized<burin_stroke>();
    stroke.settings = settings;
    ASSERT_EQ(IN_C(burin_session_begin)(session, &stroke, &error), BURIN_OK) << error.str();
    EXPECT_EQ(IN_C(burin_session_add)(session, samples.data(), samples.size(), nullptr, &error), status);
    if (status != BURIN_OK) EXPECT_NE(error.str().find("in crash_here, failing.burin+0x"), std::string::npos);
  }
  EXPECT_EQ(IN_C(burin_session_end)(session, &error), BURIN_OK) << error.str();
  IN_C(burin_session_destroy)(session);
  IN_C(burin_library_destroy)(library);
}

TEST_F(CBrushes, SampleStampsAndSetLettersBesideTheirLibrary) {
  EXPECT_EQ(IN_C(burin_library_load)(library_, nullptr, &error_), BURIN_OK) << error_.str();
  const TriangleMesh mesh = plane(1, 0.04, 4);
  const burin_mesh arrays = arrays_of(mesh);
  burin_session* session = nullptr;
  ASSERT_EQ(IN_C(burin_session_create)(library_, &arrays, &session, &error_), BURIN_OK) << error_.str();
  const std::string stamp = "params=stamp=" + std::string(BURIN_SAMPLES) + "/stamps/scales.exr";
  const char* const scales[] = {"brush=org.burin.scales", "radius=0.15", stamp.c_str(), nullptr};
  // What looks like a number is the text that it is.
  const char* const text[] = {"brush=org.burin.text", "radius=0.15", "params=text=1884", nullptr};
  const std::vector<burin_sample> samples = in_c(without_pen(wave(15)));
  for (const char* const* settings : {scales, text}) {
    auto stroke = sized<burin_stroke>();
    stroke.settings = settings;
    std::uint64_t before = 0, after = 0;
    IN_C(burin_session_hash)(session, &before, &error_);
    EXPECT_EQ(IN_C(burin_session_begin)(session, &stroke, &error_), BURIN_OK) << error_.str();
    EXPECT_EQ(IN_C(burin_session_add)(session, samples.data(), samples.size(), nullptr, &error_), BURIN_OK)
        << error_.str();
    EXPECT_EQ(IN_C(burin_session_end)(session, &error_), BURIN_OK) << error_.str();
    IN_C(burin_session_hash)(session, &after, &error_);
    EXPECT_NE(before, after);
  }
  // The library may go first.
  IN_C(burin_library_destroy)(library_);
  library_ = nullptr;
  EXPECT_EQ(IN_C(burin_session_undo)(session, &error_), BURIN_OK);
  IN_C(burin_session_destroy)(session);
}

TEST_F(CBrushes, AreLoadedAnew) {
  const TemporaryFolder folder;
  const fs::path module = folder.path() / "a.burin";
  fs::copy(fs::path(BURIN_RELOADED_BRUSHES) / "reloaded_1.burin", module);
  ASSERT_EQ(load(module), BURIN_OK) << error_.str();
  EXPECT_TRUE(has_param("count"));
  fs::remove(module);  // what is loaded must not be overwritten
  fs::copy(fs::path(BURIN_RELOADED_BRUSHES) / "reloaded_2.burin", module);
  EXPECT_EQ(IN_C(burin_library_reload)(library_, module.c_str(), &error_), BURIN_OK) << error_.str();
  EXPECT_TRUE(has_param("amount"));
  EXPECT_EQ(IN_C(burin_library_reload)(library_, "/no/such/file", &error_), BURIN_ERROR);
}

/// The brushes of a module, as an application has its own: it calls the module itself, which stays loaded.
const burin_brush_factory& brushes_in(const fs::path& module) {
  void* const handle = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(dlerror());
  const auto* entry = static_cast<const burin_plugin_entry*>(dlsym(handle, BURIN_PLUGIN_SYMBOL));
  CText error;
  if (entry->init(module.c_str(), &error) != BURIN_OK) throw std::runtime_error(error.str());
  return *static_cast<const burin_brush_factory*>(entry->get_factory(BURIN_BRUSH_FACTORY));
}

TEST_F(CBrushes, OfTheApplicationItselfDrawWhatThoseOfModulesDraw) {
  const auto add = [&](const burin_brush_factory& factory) {
    return IN_C(burin_library_add)(library_, "own brushes", &factory, &error_);
  };
  ASSERT_EQ(add(brushes_in(test_brushes_folder / "raise_to.burin")), BURIN_OK) << error_.str();
  EXPECT_EQ(count(), 1u);
  const TriangleMesh mesh = plane(1, 0.04, 4);
  const burin_mesh arrays = arrays_of(mesh);
  burin_session* own = nullptr;
  ASSERT_EQ(IN_C(burin_session_create)(library_, &arrays, &own, &error_), BURIN_OK) << error_.str();
  const char* const settings[] = {"brush=org.burin.test.raise-to", "radius=0.15", nullptr};
  auto stroke = sized<burin_stroke>();
  stroke.settings = settings;
  const std::vector<burin_sample> samples = in_c(without_pen(wave()));
  EXPECT_EQ(IN_C(burin_session_begin)(own, &stroke, &error_), BURIN_OK) << error_.str();
  EXPECT_EQ(IN_C(burin_session_add)(own, samples.data(), samples.size(), nullptr, &error_), BURIN_OK);
  EXPECT_EQ(IN_C(burin_session_end)(own, &error_), BURIN_OK) << error_.str();
  std::uint64_t hash = 0;
  IN_C(burin_session_hash)(own, &hash, &error_);
  CSession of_module(mesh);
  of_module.draw({settings[0], settings[1]}, samples);
  EXPECT_EQ(hash, of_module.hash());

  // The second time they take the place of the first.
  EXPECT_EQ(add(brushes_in(fs::path(BURIN_RELOADED_BRUSHES) / "reloaded_1.burin")), BURIN_OK) << error_.str();
  EXPECT_EQ(count(), 1u);
  EXPECT_TRUE(has_param("count"));
  EXPECT_EQ(IN_C(burin_session_begin)(own, &stroke, &error_), BURIN_NOT_FOUND);
  IN_C(burin_session_destroy)(own);
}

TEST_F(CBrushes, OfTheApplicationItselfAreRefusedLikeThoseOfModules) {
  const fs::path bead = brushes_folder / "bead.burin";
  ASSERT_EQ(load(bead), BURIN_OK);
  const burin_brush_factory& factory = brushes_in(bead);
  EXPECT_EQ(IN_C(burin_library_add)(library_, "own", &factory, &error_), BURIN_ERROR);
  EXPECT_EQ(error_.str(), "own: brush org.burin.bead is already there, from " + bead.string());
  EXPECT_EQ(IN_C(burin_library_add)(library_, bead.c_str(), &factory, &error_), BURIN_ERROR);
  EXPECT_EQ(error_.str(), bead.string() + ": is a module that was loaded from a file");
  burin_brush_factory no_create = factory;
  no_create.create = nullptr;
  EXPECT_EQ(IN_C(burin_library_add)(library_, "own", &no_create, &error_), BURIN_ERROR);
  EXPECT_EQ(error_.str(), "own: its brush factory is incomplete");
  EXPECT_EQ(IN_C(burin_library_add)(library_, nullptr, &factory, &error_), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(IN_C(burin_library_add)(library_, "own", nullptr, &error_), BURIN_INVALID_ARGUMENT);
  EXPECT_EQ(count(), 1u);
}

}  // namespace
}  // namespace burin::test

// Threads that an application lends.
#include <gtest/gtest.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "c_host.h"
#include "sanitizers/sanitized.h"
#include "tbb_arrivals.h"

namespace burin::test {
namespace {

/// A pool of threads, which takes one job at a time.
class Pool {
 public:
  explicit Pool(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) threads_.emplace_back([this] { work(); });
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    news_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// burin_run_tasks.
  static void BURIN_CALL run(void* user, burin_task task, void* tasks, uint64_t count) {
    auto& pool = *static_cast<Pool*>(user);
    EXPECT_FALSE(inside) << "one call within another";
    std::unique_lock lock(pool.mutex_);
    ++pool.calls;
    pool.task_ = task;
    pool.tasks_ = tasks;
    pool.next_ = 0;
    pool.count_ = count - pool.forgets;
    pool.left_ = pool.count_;
    pool.news_.notify_all();
    pool.done_.wait(lock, [&] { return pool.left_ == 0; });
  }

  std::size_t calls = 0;
  std::set<std::thread::id> used;  ///< threads that have run a task
  std::size_t forgets = 0;         ///< how many tasks of a call it does not run

 private:
  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      news_.wait(lock, [&] { return ends_ || next_ < count_; });
      if (ends_) return;
      const std::uint64_t number = count_ - 1 - next_++;  // the last first
      used.insert(std::this_thread::get_id());
      lock.unlock();
      inside = true;
      task_(tasks_, number);
      inside = false;
      lock.lock();
      if (--left_ == 0) done_.notify_one();
    }
  }

  static inline thread_local bool inside = false;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable news_, done_;
  burin_task task_ = nullptr;
  void* tasks_ = nullptr;
  std::uint64_t next_ = 0, count_ = 0, left_ = 0;
  bool ends_ = false;
};

/// A session of a library of its own.
class Lent {
 public:
  Lent(burin_run_tasks run, void* user, const TriangleMesh& mesh) {
    auto options = sized<burin_library_options>();
    options.run = run;
    options.run_user = user;
    options.run_threads = 4;
    check(IN_C(burin_library_create)(&options, &library_, &error));
    check(IN_C(burin_library_load)(library_, brushes_folder.c_str(), &error));
    check(IN_C(burin_library_load)(library_, (test_plugins_folder / "error_brush.burin").c_str(), &error));
    burin_mesh arrays = arrays_of(mesh);
    arrays.refines = 1;  // solids may be merged
    arrays.order = BURIN_ORDER_CALLER;
    check(IN_C(burin_session_create)(library_, &arrays, &session_, &error));
  }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;
  ~Lent() {
    IN_C(burin_session_destroy)(session_);
    IN_C(burin_library_destroy)(library_);
  }

  burin_status draw(std::vector<const char*> settings, const std::vector<burin_sample>& samples) {
    settings.push_back(nullptr);
    auto stroke = sized<burin_stroke>();
    stroke.settings = settings.data();
    burin_status status = IN_C(burin_session_begin)(session_, &stroke, &error);
    for (std::size_t i = 0; status == BURIN_OK && i < samples.size(); ++i)
      status = IN_C(burin_session_add)(session_, &samples[i], 1, nullptr, &error);
    return status == BURIN_OK ? IN_C(burin_session_end)(session_, &error) : status;
  }
  /// How many triangles the surface of the first solid beside the mesh has.
  std::uint64_t triangles_of_solid() {
    burin_triangles* triangles = nullptr;
    check(IN_C(burin_session_read_solid)(session_, 0, &triangles, &error));
    auto arrays = sized<burin_mesh>();
    check(IN_C(burin_triangles_get)(triangles, &arrays, nullptr, &error));
    IN_C(burin_triangles_destroy)(triangles);
    return arrays.face_count;
  }
  std::uint64_t hash() {
    std::uint64_t hash = 0;
    check(IN_C(burin_session_hash)(session_, &hash, &error));
    return hash;
  }
  void check(burin_status status) {
    if (status != BURIN_OK) throw std::runtime_error(error.str());
  }

  CText error;

 private:
  burin_library* library_ = nullptr;
  burin_session* session_ = nullptr;
};

const std::vector<const char*> rope = {"brush=org.burin.rope", "radius=0.4"};

TEST(CThreads, ThatAreLentDrawTheSameBitsAndNoOthersWork) {
  const TriangleMesh mesh = shuffled(plane(1, 0.01, 4), 5);
  const std::vector<burin_sample> samples = in_c(without_pen(wave(20)));
  Lent expected(nullptr, nullptr, mesh);
  ASSERT_EQ(expected.draw(rope, samples), BURIN_OK) << expected.error.str();
  Pool pool(3);
  const int arrivals = CountedArena().arrivals_during([&] {
    Lent lent(Pool::run, &pool, mesh);
    EXPECT_GT(pool.calls, 5u) << "to make the surface";
    EXPECT_EQ(lent.draw(rope, samples), BURIN_OK) << lent.error.str();
    EXPECT_EQ(lent.hash(), expected.hash());
  });
  EXPECT_EQ(arrivals, 0);
  EXPECT_GT(pool.calls, 60u);
  EXPECT_FALSE(pool.used.contains(std::this_thread::get_id()));
  EXPECT_GT(pool.used.size(), 1u);
  if (test::sanitized) return;  // the thread sanitizer's loops have threads of their own
  EXPECT_TRUE(CountedArena().arrive_at([&] { expected.draw(rope, samples); })) << "they would be counted";
}

TEST(CThreads, ThatAreLentMakeSolidsOfTheSameBitsAndNoOthersWork) {
  const TriangleMesh mesh = shuffled(plane(1, 0.02, 4), 5);
  const std::vector<burin_sample> samples = in_c(without_pen(wave(20)));
  const std::vector<const char*> merged = {"brush=org.burin.tube", "radius=0.2", "solid=union", "voxel=0.04"},
                                 beside = {"brush=org.burin.tube", "radius=0.2", "voxel=0.04"};
  Lent expected(nullptr, nullptr, mesh);
  ASSERT_EQ(expected.draw(merged, samples), BURIN_OK) << expected.error.str();
  ASSERT_EQ(expected.draw(beside, samples), BURIN_OK) << expected.error.str();
  const std::uint64_t hash = expected.hash(), triangles = expected.triangles_of_solid();
  Pool pool(3);
  const int arrivals = CountedArena().arrivals_during([&] {
    Lent lent(Pool::run, &pool, mesh);
    const std::size_t before = pool.calls;
    EXPECT_EQ(lent.draw(merged, samples), BURIN_OK) << lent.error.str();
    EXPECT_GT(pool.calls, before + 10);
    EXPECT_EQ(lent.draw(beside, samples), BURIN_OK) << lent.error.str();
    EXPECT_EQ(lent.hash(), hash);
    const std::size_t drawn = pool.calls;
    EXPECT_EQ(lent.triangles_of_solid(), triangles);
    EXPECT_GT(pool.calls, drawn);
  });
  EXPECT_EQ(arrivals, 0);
}

TEST(CThreads, ThatAreLentBringFaultsBack) {
  const TriangleMesh mesh = shuffled(plane(1, 0.04, 4), 5);
  Pool pool(3);
  Lent lent(Pool::run, &pool, mesh), expected(nullptr, nullptr, mesh);
  const std::uint64_t before = lent.hash();
  const std::vector<burin_sample> samples = in_c(without_pen(wave(20)));
  EXPECT_EQ(expected.draw({"brush=org.burin.test.error", "radius=0.4"}, samples), BURIN_ERROR);
  EXPECT_EQ(lent.draw({"brush=org.burin.test.error", "radius=0.4"}, samples), BURIN_ERROR);
  EXPECT_EQ(lent.error.str(), expected.error.str());
  EXPECT_EQ(lent.hash(), before);
  pool.forgets = 1;
  EXPECT_EQ(lent.draw(rope, samples), BURIN_ERROR);
  EXPECT_EQ(lent.error.str(), "the application has not run all tasks");
  pool.forgets = 0;
  EXPECT_EQ(lent.hash(), before);
  EXPECT_EQ(lent.draw(rope, samples), BURIN_OK) << lent.error.str();
}

}  // namespace
}  // namespace burin::test

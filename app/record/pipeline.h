// Two stages beside the thread that steps: drawing, then encoding and writing. Items keep their order, so what is
// written does not depend on who waits for whom.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "app/base/bounded_queue.h"
#include "app/base/stopwatch.h"

namespace app {

// Job: what is to be drawn. Drawn: what is to be written.
template <typename Job, typename Drawn>
class Pipeline {
 public:
  using Draw = std::function<Drawn(Job)>;
  using MakeDraw = std::function<Draw()>;  // called in the drawing thread, which then owns what it makes (a GL context)
  using Write = std::function<void(Drawn)>;

  // Returns when the drawing stage is ready; throws what `make` throws. `depth` items may wait before each stage.
  Pipeline(MakeDraw make, Write write, std::size_t depth = 2) : jobs_(depth), drawn_(depth) {
    std::promise<void> ready;
    std::future<void> drawing_ready = ready.get_future();
    drawing_ =
        std::thread([this, make = std::move(make), ready = std::move(ready)]() mutable { draw_all(make, ready); });
    writing_ = std::thread([this, write = std::move(write)] { write_all(write); });
    try {
      drawing_ready.get();
    } catch (...) {
      join();
      throw;
    }
  }

  // Writes what was pushed, without a word about errors: call finish() to learn of them.
  ~Pipeline() { join(); }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  // Waits for room. Throws what a stage has thrown; from then on nothing is drawn or written.
  void push(Job job) {
    if (!jobs_.push(std::move(job))) throw_error();
  }

  // Returns when everything is written. Throws what a stage has thrown.
  void finish() {
    join();
    throw_error();
  }

  // Time spent in each stage so far [s].
  double drawing_seconds() const { return drawing_seconds_; }
  double writing_seconds() const { return writing_seconds_; }

 private:
  void draw_all(const MakeDraw& make, std::promise<void>& ready) {
    Draw draw;
    try {
      draw = make();
    } catch (...) {
      jobs_.cancel();
      drawn_.close();
      ready.set_exception(std::current_exception());
      return;
    }
    ready.set_value();
    run_stage([&] {
      while (std::optional<Job> job = jobs_.pop()) {
        const Stopwatch watch;
        Drawn drawn = draw(std::move(*job));
        drawing_seconds_ += watch.seconds();
        if (!drawn_.push(std::move(drawn))) break;
      }
    });
    drawn_.close();
  }

  void write_all(const Write& write) {
    run_stage([&] {
      while (std::optional<Drawn> drawn = drawn_.pop()) {
        const Stopwatch watch;
        write(std::move(*drawn));
        writing_seconds_ += watch.seconds();
      }
    });
  }

  // An error ends both stages; the first one is kept for the main thread.
  template <typename Stage>
  void run_stage(const Stage& stage) {
    try {
      stage();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      jobs_.cancel();
      drawn_.cancel();
    }
  }

  void join() {
    jobs_.close();
    if (drawing_.joinable()) drawing_.join();
    if (writing_.joinable()) writing_.join();
  }

  void throw_error() {
    const std::lock_guard lock(mutex_);
    if (error_) std::rethrow_exception(error_);
  }

  BoundedQueue<Job> jobs_;
  BoundedQueue<Drawn> drawn_;
  std::mutex mutex_;
  std::exception_ptr error_;
  std::atomic<double> drawing_seconds_ = 0, writing_seconds_ = 0;
  std::thread drawing_, writing_;
};

}  // namespace app

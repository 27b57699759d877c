#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include <boost/make_shared.hpp>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

namespace rigid_body_sim {

/// A queue that can be waited for without serving it.
class NodeQueue : public ros::CallbackQueue {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override {
    ros::CallbackQueue::addCallback(callback, owner);
    { const std::lock_guard<std::mutex> lock(mutex_); }  // none is between its look and its sleep
    has_come_.notify_all();
  }

  /// Returns once a callback is there, or after that long [s].
  void waitForCallback(double seconds) {
    std::unique_lock<std::mutex> lock(mutex_);
    has_come_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return !isEmpty(); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable has_come_;
};

/// A queue beside another one: what comes in wakes up whoever waits for the other.
class SideQueue : public ros::CallbackQueue {
 public:
  explicit SideQueue(ros::CallbackQueue& other) : other_(other) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override {
    ros::CallbackQueue::addCallback(callback, owner);
    other_.addCallback(boost::make_shared<WakeUp>());
  }

 private:
  struct WakeUp : ros::CallbackInterface {
    CallResult call() override { return Success; }
  };
  ros::CallbackQueue& other_;
};

/// The handles of a node that serves its callbacks itself. ~step has a queue of its own, so that
/// all other callbacks can be served while steps are taken.
struct NodeQueues {
  /// Calls a function as ~step is called: not from within another callback.
  void callWithSteps(const std::function<void()>& function) {
    step_queue.addCallback(boost::make_shared<Call>(function), 0);
  }

  NodeQueue queue;
  SideQueue step_queue{queue};
  ros::NodeHandle nh = handle("", queue);
  ros::NodeHandle private_nh = handle("~", queue);
  ros::NodeHandle step_nh = handle("~", step_queue);

 private:
  struct Call : ros::CallbackInterface {
    explicit Call(std::function<void()> f) : function(std::move(f)) {}
    CallResult call() override { return function(), Success; }
    std::function<void()> function;
  };
  static ros::NodeHandle handle(const std::string& name_space, ros::CallbackQueue& served) {
    ros::NodeHandle nh(name_space);
    nh.setCallbackQueue(&served);
    return nh;
  }
};

}  // namespace rigid_body_sim

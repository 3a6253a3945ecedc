// Quality of service: what a publisher offers and a subscription asks for.
#pragma once

#include <cstddef>

namespace rclcpp
{

enum class HistoryPolicy {KeepLast, KeepAll, SystemDefault, Unknown};
enum class ReliabilityPolicy {BestEffort, Reliable, SystemDefault, Unknown, BestAvailable};
enum class DurabilityPolicy {Volatile, TransientLocal, SystemDefault, Unknown, BestAvailable};

struct QoSInitialization
{
  QoSInitialization(HistoryPolicy history_policy, std::size_t history_depth)
  : history(history_policy), depth(history_depth) {}

  HistoryPolicy history;
  std::size_t depth;
};

struct KeepLast : QoSInitialization
{
  explicit KeepLast(std::size_t depth)
  : QoSInitialization(HistoryPolicy::KeepLast, depth) {}
};

struct KeepAll : QoSInitialization
{
  KeepAll()
  : QoSInitialization(HistoryPolicy::KeepAll, 0) {}
};

class QoS
{
public:
  QoS(const QoSInitialization & initialization)  // NOLINT: implicit upstream
  : history_(initialization.history), depth_(initialization.depth) {}
  QoS(std::size_t history_depth)  // NOLINT: implicit upstream
  : QoS(KeepLast(history_depth)) {}

  HistoryPolicy history() const {return history_;}
  std::size_t depth() const {return depth_;}
  ReliabilityPolicy reliability() const {return reliability_;}
  DurabilityPolicy durability() const {return durability_;}

  QoS & history(HistoryPolicy policy) {history_ = policy; return *this;}
  QoS & keep_last(std::size_t depth)
  {
    history_ = HistoryPolicy::KeepLast;
    depth_ = depth;
    return *this;
  }
  QoS & keep_all()
  {
    history_ = HistoryPolicy::KeepAll;
    depth_ = 0;
    return *this;
  }
  QoS & reliability(ReliabilityPolicy policy) {reliability_ = policy; return *this;}
  QoS & reliable() {return reliability(ReliabilityPolicy::Reliable);}
  QoS & best_effort() {return reliability(ReliabilityPolicy::BestEffort);}
  QoS & durability(DurabilityPolicy policy) {durability_ = policy; return *this;}
  QoS & durability_volatile() {return durability(DurabilityPolicy::Volatile);}
  QoS & transient_local() {return durability(DurabilityPolicy::TransientLocal);}

private:
  HistoryPolicy history_;
  std::size_t depth_;
  ReliabilityPolicy reliability_ = ReliabilityPolicy::Reliable;
  DurabilityPolicy durability_ = DurabilityPolicy::Volatile;
};

class SensorDataQoS : public QoS
{
public:
  SensorDataQoS(const QoSInitialization & initialization = KeepLast(5))  // NOLINT: as upstream
  : QoS(initialization) {best_effort();}
};

class ServicesQoS : public QoS
{
public:
  ServicesQoS()
  : QoS(KeepLast(10)) {}
};

class SystemDefaultsQoS : public QoS
{
public:
  SystemDefaultsQoS(const QoSInitialization & initialization = KeepLast(10))  // NOLINT
  : QoS(initialization) {}
};

}  // namespace rclcpp

#pragma once

#include <cstddef>
#include <cstdint>
#include <forward_list>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>

#include "message_filters/simple_filter.hpp"

namespace message_filters
{

/// The types of fields that can be compared.
using MFieldType = std::variant<
  bool, std::byte, char, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
  std::int64_t, std::uint64_t, float, double, std::string>;

/// Selects the messages that a ComparisonFilter passes on.
template<typename M>
class ComparisonHandler
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;
  using FieldGetterFunctionType = std::function<MFieldType (const MConstPtr &)>;

  virtual ~ComparisonHandler() = default;

  virtual bool message_fits(const EventType & event) = 0;
  virtual bool do_fields_fit(MFieldType before, MFieldType now) const = 0;
};

/// Passes on the first message, and each message with a matching field compared with the last one
/// passed on.
template<typename M>
class CachedComparisonHandler : public ComparisonHandler<M>
{
public:
  using typename ComparisonHandler<M>::MConstPtr;
  using typename ComparisonHandler<M>::EventType;
  using typename ComparisonHandler<M>::FieldGetterFunctionType;

  explicit CachedComparisonHandler(std::forward_list<FieldGetterFunctionType> field_getters)
  : field_getters_(std::move(field_getters)) {}

  bool message_fits(const EventType & event) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const MConstPtr & message = event.getConstMessage();
    bool fits = !last_;
    for (auto get = field_getters_.begin(); !fits && get != field_getters_.end(); ++get) {
      fits = this->do_fields_fit((*get)(last_), (*get)(message));
    }
    if (fits) {last_ = message;}
    return fits;
  }

private:
  std::forward_list<FieldGetterFunctionType> field_getters_;
  std::mutex mutex_;
  MConstPtr last_;
};

/// Matches a field whose value has changed.
template<typename M>
class DeltaCompare : public CachedComparisonHandler<M>
{
public:
  using CachedComparisonHandler<M>::CachedComparisonHandler;

  bool do_fields_fit(MFieldType before, MFieldType now) const override {return before != now;}
};

template<typename M, template<typename> class HandlerT>
class ComparisonFilter : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;
  using FieldGetterFunctionType = std::function<MFieldType (const MConstPtr &)>;

  template<typename F>
  ComparisonFilter(F & filter, std::forward_list<FieldGetterFunctionType> field_getters)
  : handler_(std::move(field_getters))
  {
    connectInput(filter);
  }
  ~ComparisonFilter() {connection_.disconnect();}

  template<typename F>
  void connectInput(F & filter)
  {
    connection_.disconnect();
    connection_ = filter.registerCallback([this](const EventType & event) {add(event);});
  }
  void add(const EventType & event)
  {
    if (handler_.message_fits(event)) {this->signalMessage(event);}
  }

private:
  HandlerT<M> handler_;
  Connection connection_;
};

/// Passes on messages that differ in one of the compared fields from the last one passed on.
template<typename M>
class DeltaFilter : public ComparisonFilter<M, DeltaCompare>
{
public:
  using ComparisonFilter<M, DeltaCompare>::ComparisonFilter;
};

}  // namespace message_filters

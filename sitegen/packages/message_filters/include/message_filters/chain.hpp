#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "message_filters/pass_through.hpp"
#include "message_filters/simple_filter.hpp"

namespace message_filters
{

/// A chain of filters for messages of any type.
class ChainBase
{
public:
  virtual ~ChainBase() = default;

  /// Null if there is no such filter.
  template<class F>
  std::shared_ptr<F> getFilter(std::size_t index) const
  {
    return std::static_pointer_cast<F>(getFilterForIndex(index));
  }

protected:
  virtual std::shared_ptr<void> getFilterForIndex(std::size_t index) const = 0;
};
using ChainBasePtr = std::shared_ptr<ChainBase>;

/// A chain of filters as one filter.
template<typename M>
class Chain : public ChainBase, public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;

  Chain() = default;
  template<typename F>
  explicit Chain(F & filter) {connectInput(filter);}
  ~Chain()
  {
    input_.disconnect();
    output_.disconnect();
  }

  /// Returns the index of the filter. A filter given as a plain pointer must outlive the chain.
  template<class F>
  std::size_t addFilter(F * filter)
  {
    return addFilter(std::shared_ptr<F>(filter, [](F *) {}));
  }
  template<class F>
  std::size_t addFilter(const std::shared_ptr<F> & filter)
  {
    output_.disconnect();
    if (links_.empty()) {
      filter->connectInput(start_);
    } else {
      filter->connectInput(*links_.back().out);
    }
    output_ = filter->registerCallback(
      [this](const EventType & event) {this->signalMessage(event);});
    // The next filter connects to the output of this one, whatever its class is.
    links_.push_back({filter, std::make_shared<PassThrough<M>>(*filter)});
    return links_.size() - 1;
  }

  template<class F>
  void connectInput(F & filter)
  {
    input_.disconnect();
    input_ = filter.registerCallback([this](const EventType & event) {add(event);});
  }
  void add(const MConstPtr & message) {start_.add(message);}
  void add(const EventType & event) {start_.add(event);}

protected:
  std::shared_ptr<void> getFilterForIndex(std::size_t index) const override
  {
    return index < links_.size() ? links_[index].filter : nullptr;
  }

private:
  struct Link
  {
    std::shared_ptr<void> filter;
    std::shared_ptr<PassThrough<M>> out;
  };

  PassThrough<M> start_;
  std::vector<Link> links_;
  Connection input_;
  Connection output_;
};

}  // namespace message_filters

#pragma once

#include <cstddef>
#include <vector>

#include "imr-h/imr_assert.h"

namespace imr {
namespace dijkstra {

/// The priority queue of Dijkstra's algorithm (specs: syrotek.md C): nodes 0 .. size - 1, each at
/// most once, the cheapest first; of equal ones, any. A binary heap that knows where each node is,
/// so that a cost can be lowered: E. W. Dijkstra, "A note on two problems in connexion with
/// graphs", 1959; J. W. J. Williams, "Algorithm 232: heapsort", 1964. One thread.
///
/// @tparam Weight What costs are: ordered by <.
template <typename Weight>
class CHeap {
 public:
  /// Room for nodes 0 .. size - 1. Throws argument_error for a negative size.
  explicit CHeap(int size) {
    assert_argument(size >= 0, "the size of a heap must not be negative");
    index_.assign(static_cast<std::size_t>(size), kOut);
    cost_.resize(static_cast<std::size_t>(size));
  }

  /// Puts a node in. Throws argument_error if it is in already, or there is no such node.
  void add(int n, Weight cost) {
    ASSERT_ARGUMENT(getIDX(n) == kOut, "the node is in the heap already");
    cost_[at(n)] = cost;
    index_[at(n)] = static_cast<int>(nodes_.size());
    nodes_.push_back(n);
    up(nodes_.size() - 1);
  }

  /// Takes the cheapest node out; -1 when there is none.
  int getFirst() {
    if (nodes_.empty()) return kOut;
    const int first = nodes_.front();
    place(0, nodes_.back());
    nodes_.pop_back();
    index_[at(first)] = kOut;
    if (!nodes_.empty()) down(0);
    return first;
  }

  /// Gives a node that is in another cost, lower or higher; one that is not in is put in.
  void update(int n, Weight cost) {
    if (getIDX(n) == kOut) {
      add(n, cost);
      return;
    }
    cost_[at(n)] = cost;
    up(at(index_[at(n)]));
    down(at(index_[at(n)]));
  }

  /// The cost that a node was given last. Throws argument_error if there is no such node.
  Weight getCost(int n) const {
    getIDX(n);
    return cost_[at(n)];
  }

  /// Where in the heap a node is, 0 for the cheapest; -1 if it is not in. Throws argument_error if
  /// there is no such node.
  int getIDX(int n) const {
    ASSERT_ARGUMENT(n >= 0 && at(n) < index_.size(), "there is no such node");
    return index_[at(n)];
  }

  bool isEmpty() const { return nodes_.empty(); }

  /// Whether no node from place `n` on costs less than the one above it: true, but for an error.
  bool is_valid(int n = 0) const {
    for (std::size_t i = at(n) > 0 ? at(n) : 1; i < nodes_.size(); ++i) {
      if (cost_[at(nodes_[i])] < cost_[at(nodes_[(i - 1) / 2])]) return false;
      if (at(index_[at(nodes_[i])]) != i) return false;
    }
    return true;
  }

 private:
  static constexpr int kOut = -1;
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

  void place(std::size_t i, int n) {
    nodes_[i] = n;
    index_[at(n)] = static_cast<int>(i);
  }
  void up(std::size_t i) {
    const int n = nodes_[i];
    for (; i > 0 && cost_[at(n)] < cost_[at(nodes_[(i - 1) / 2])]; i = (i - 1) / 2) {
      place(i, nodes_[(i - 1) / 2]);
    }
    place(i, n);
  }
  void down(std::size_t i) {
    const int n = nodes_[i];
    for (std::size_t child = 2 * i + 1; child < nodes_.size(); child = 2 * i + 1) {
      if (child + 1 < nodes_.size() && cost_[at(nodes_[child + 1])] < cost_[at(nodes_[child])]) {
        ++child;
      }
      if (!(cost_[at(nodes_[child])] < cost_[at(n)])) break;
      place(i, nodes_[child]);
      i = child;
    }
    place(i, n);
  }

  std::vector<int> nodes_;    // the heap
  std::vector<int> index_;    // of each node: its place in nodes_
  std::vector<Weight> cost_;  // of each node
};

}  // namespace dijkstra
}  // namespace imr

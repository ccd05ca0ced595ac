// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/mesh/minimum_cut.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

namespace posture {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Arc = Traits::edge_descriptor;
using NodeProperties =
    boost::property<boost::vertex_color_t,
                    boost::default_color_type,
                    boost::property<boost::vertex_distance_t,
                                    int,
                                    boost::property<boost::vertex_predecessor_t, Arc>>>;
using ArcProperties = boost::property<boost::edge_capacity_t,
                                      double,
                                      boost::property<boost::edge_residual_capacity_t,
                                                      double,
                                                      boost::property<boost::edge_reverse_t, Arc>>>;
using Graph = boost::
    adjacency_list<boost::vecS, boost::vecS, boost::directedS, NodeProperties, ArcProperties>;

}  // namespace

std::vector<char> MinimumCut::onSinkSide() const {
  Graph graph(sink_ + 1);
  for (const auto& [a, b, there, back] : joins_) {
    const Arc forward = boost::add_edge(a, b, graph).first,
              backward = boost::add_edge(b, a, graph).first;
    boost::put(boost::edge_capacity, graph, forward, there);
    boost::put(boost::edge_capacity, graph, backward, back);
    boost::put(boost::edge_reverse, graph, forward, backward);
    boost::put(boost::edge_reverse, graph, backward, forward);
  }
  boost::boykov_kolmogorov_max_flow(graph, source_, sink_);
  using Color = boost::color_traits<boost::default_color_type>;
  std::vector<char> sides(source_);
  for (int node = 0; node < source_; ++node)
    sides[node] = boost::get(boost::vertex_color, graph, node) != Color::black();
  return sides;
}

}  // namespace posture

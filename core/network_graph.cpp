#include "core/network_graph.hpp"

#include <boost/graph/connected_components.hpp>

#include "core/tension/tree_kinematics.hpp"

namespace reeve::core {

namespace {

void add_ties(const Network& network, std::size_t block, NetworkGraph& result) {
  std::vector<std::size_t> tails;
  std::vector<std::size_t> others;
  for (const TendonSpan& tendon : network.tendons) {
    for_each_pull(network, tendon, [&](std::size_t segment, std::size_t of, double sign, double) {
      if (of == block) (sign < 0 ? tails : others).push_back(segment);
    });
  }
  for (const std::vector<std::size_t>* segments : {&tails, &others}) {
    for (const std::size_t segment : *segments) {
      if (segment == tails.front()) continue;
      const Contact tie{ContactKind::block, ContactPlace::block, 0, block};
      boost::add_edge(tails.front(), segment,
                      ContactEdge{tie, 0, tails.front(), block_name(network.blocks[block]), true},
                      result);
    }
  }
}

}  // namespace

NetworkGraph graph(const Network& network) {
  NetworkGraph result(network.segments.size());
  for (std::size_t i = 0; i < network.segments.size(); ++i) result[i] = network.segments[i];
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const std::size_t index = tendon.first_contact + k;
      const Contact& contact = network.contacts[index];
      const bool on_block = contact.block != no_block;
      boost::add_edge(left, right,
                      ContactEdge{contact, index, left,
                                  on_block ? block_name(network.blocks[contact.block]) : ""},
                      result);
    }
  }
  for (std::size_t block = 0; block < network.blocks.size(); ++block) {
    add_ties(network, block, result);
  }
  return result;
}

std::vector<std::size_t> tendons(const NetworkGraph& graph) {
  std::vector<std::size_t> component(boost::num_vertices(graph));
  boost::connected_components(graph, component.data());
  return component;
}

}  // namespace reeve::core

#include "core/graph.hpp"

#include <boost/graph/connected_components.hpp>
#include <boost/graph/graphviz.hpp>
#include <fmt/format.h>

#include <sstream>

#include "core/error.hpp"
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

void require_actuated(const NetworkGraph& graph, const std::string& word) {
  const std::vector<std::size_t> tendon = tendons(graph);
  std::vector<bool> actuated(tendon.size(), false);
  for (std::size_t i = 0; i < tendon.size(); ++i) {
    if (graph[i].kind == SegmentKind::motor_side) actuated[tendon[i]] = true;
  }
  for (std::size_t i = 0; i < tendon.size(); ++i) {
    if (!actuated[tendon[i]]) {
      throw InputError(
          {.where = fmt::format("routing '{}'", word),
           .what = fmt::format("the tendon with {} is not actuated: it has no M and no P, so the "
                               "motor cannot pull it",
                               segment_name(graph[i]))});
    }
  }
}

namespace {

const char* shape(SegmentKind kind) {
  switch (kind) {
    case SegmentKind::strand:
      return "box";
    case SegmentKind::motor_side:
      return "ellipse";
    case SegmentKind::hand:
      return "plain";
  }
  return "box";
}

const char* line_style(ContactKind kind) {
  switch (kind) {
    case ContactKind::tube:
      return "solid";
    case ContactKind::bearing:
      return "dashed";
    case ContactKind::sheath:
      return "bold";
    case ContactKind::block:
    case ContactKind::bar:
      return "dashed";
  }
  return "solid";
}

std::string place_label(const ContactEdge& edge) {
  const Contact& contact = edge.contact;
  switch (contact.place) {
    case ContactPlace::tip:
      return fmt::format("tip {} ({})", contact.finger, contact_kind_name(contact.kind));
    case ContactPlace::carriage:
      return "movable pulley";
    case ContactPlace::hand_join:
    case ContactPlace::sheath:
      return contact_kind_name(contact.kind);
    case ContactPlace::block:
      return edge.block;
  }
  return "";
}

std::string segment_attributes(const Segment& segment, double tension, bool with_tension) {
  const std::string label = with_tension
                                ? fmt::format("{}\\n{:.3f}", segment_name(segment), tension)
                                : segment_name(segment);
  return fmt::format("[label=\"{}\", shape={}]", label, shape(segment.kind));
}

// dir=forward draws the arrow from the edge's source to its target.
std::string contact_attributes(const ContactEdge& edge, bool source_is_left,
                               const TensionState* state) {
  std::string attributes = fmt::format("[label=\"{}\", style={}", place_label(edge),
                                       edge.is_tie ? "dotted" : line_style(edge.contact.kind));
  if (state != nullptr && !edge.is_tie && state->slip[edge.index] != 0) {
    const bool to_right = state->slip[edge.index] > 0;
    attributes += to_right == source_is_left ? ", dir=forward" : ", dir=back";
  }
  return attributes + "]";
}

}  // namespace

std::string to_dot(const Network& network, const std::string& title, const TensionState* state) {
  const NetworkGraph net = graph(network);
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // where there is no memory
  boost::write_graphviz(
      out, net,
      [&](std::ostream& os, NetworkGraph::vertex_descriptor v) {
        os << segment_attributes(net[v], state == nullptr ? 0 : state->tension[v],
                                 state != nullptr);
      },
      [&](std::ostream& os, NetworkGraph::edge_descriptor e) {
        os << contact_attributes(net[e], boost::source(e, net) == net[e].left, state);
      },
      [&](std::ostream& os) {
        os << fmt::format(
            "label=\"{}\";\nrankdir=LR;\nnode [fontname=Helvetica];\n"
            "edge [fontname=Helvetica, fontsize=10];\n",
            title);
      });
  return out.str();
}

}  // namespace reeve::core

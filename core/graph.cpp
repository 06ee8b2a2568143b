#include "core/graph.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/network_graph.hpp"
#include "core/notation.hpp"

namespace reeve::core {

void require_actuated(const Network& network, const std::string& word) {
  const std::vector<std::size_t> tendon = tendons(graph(network));
  std::vector<bool> actuated(tendon.size(), false);
  for (std::size_t i = 0; i < tendon.size(); ++i) {
    if (network.segments[i].kind == SegmentKind::motor_side) actuated[tendon[i]] = true;
  }
  for (std::size_t i = 0; i < tendon.size(); ++i) {
    if (!actuated[tendon[i]]) {
      throw InputError(
          {.where = fmt::format("routing '{}'", word),
           .what = fmt::format("the tendon with {} is not actuated: it has no M and no P, so the "
                               "motor cannot pull it",
                               segment_name(network.segments[i]))});
    }
  }
}

const Segment* second_tendon(const Network& network) {
  const auto is_second = [&](const Segment& segment) {
    if (segment.kind != SegmentKind::strand || segment.number % 2 == 1) return false;
    return std::none_of(
        network.contacts.begin(), network.contacts.end(), [&](const Contact& contact) {
          return contact.place == ContactPlace::tip && contact.finger == segment.finger;
        });
  };
  const auto found = std::find_if(network.segments.begin(), network.segments.end(), is_second);
  return found == network.segments.end() ? nullptr : &*found;
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
  std::string out = fmt::format(
      "graph G {{\nlabel=\"{}\";\nrankdir=LR;\nnode [fontname=Helvetica];\n"
      "edge [fontname=Helvetica, fontsize=10];\n",
      title);
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    out += fmt::format(
        "{}{};\n", i,
        segment_attributes(net[i], state == nullptr ? 0 : state->tension[i], state != nullptr));
  }
  for (auto [edge, end] = boost::edges(net); edge != end; ++edge) {
    const std::size_t source = boost::source(*edge, net);
    out += fmt::format("{}--{} {};\n", source, boost::target(*edge, net),
                       contact_attributes(net[*edge], source == net[*edge].left, state));
  }
  return out + "}\n";
}

}  // namespace reeve::core

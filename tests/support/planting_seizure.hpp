// A seized contact: it never slides and transmits any difference of tension, so that the tendon
// ends there on both sides and is two tendons, each written as a walk of its own:
//
//     hand join   M-1-T-2-F at T2-T3:   M-1-F and F-2-F
//     pulley      M-1-P-2-F at b-c:     M-1-M and M-2-F, both ends tied to the carriage
//     sheath      M-1-P-2-F at T2-b:    M-1-F and F-P-2-F, whose first segment stands for nothing
//     end sheath  M-1-F at a-T1:        a alone, which the carriage pulls in vain
//     loop        opened there: the same loop with a contact that is never worth turning over
//
// A piece without motor is slack. At a fingertip both pieces close with the same finger; that is
// easy only where one motor end pulls everything towards itself, and refused elsewhere.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace reeve::testing {

struct CutRouting {
  std::string word;                            // of the pieces on the motor; empty: blocked
  std::map<std::string, std::string> segment;  // of `word` -> of the routing; others are slack
  std::set<std::string> stand_ins;             // segments of `word` that the routing does not have
  std::set<std::pair<std::string, std::string>> locked;  // contacts of `word` that never slide
  std::string blocked;  // the segment that takes the whole motor tension
};

// An uncut routing.
CutRouting whole(const std::string& word);

// Of one tendon. Throws std::invalid_argument on a contact that is not there or that is refused.
CutRouting cut_at(const std::string& word, const std::string& contact);

// The contacts of a routing that cut_at takes: none of one with several tendons.
std::vector<std::string> seizable_contacts(const std::string& word);

}  // namespace reeve::testing

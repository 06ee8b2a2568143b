#include "diagnosis/search/levers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/mechanics.hpp"
#include "diagnosis/fit/mounting.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::array site_kinds{ContactKind::tube, ContactKind::sheath, ContactKind::bearing,
                                ContactKind::block};

struct ContactColumn {
  NumberedContact contact;
  VectorXd by_exponent_N;
};

VectorXd by_exponent(const Dataset& dataset, const Model& model, const NumberedContact& contact) {
  constexpr double step = 1e-4;
  const auto changed = [&](double by) {
    return [&contact, by](double phi, const ContactLoad& load) {
      return contact.is(load) ? phi + by : phi;
    };
  };
  const ChangedExponents less(changed(-step)), more(changed(step));
  const auto with = [&](const Cause& exponents) {
    Model there = model;
    there.effects.push_back({&exponents, {}, {}});
    return there;
  };
  return reading_slope(dataset, with(less), with(more), 2 * step)
      .value_or(VectorXd::Zero(static_cast<Index>(dataset.cells.size())));
}

std::vector<ContactColumn> slots(const Dataset& dataset, const Model& model, Workers& workers) {
  std::vector<ContactColumn> result;
  for (const ContactKind kind : site_kinds) {
    for (std::size_t n = 0; n < most_of_a_kind(dataset, kind); ++n)
      result.push_back({{kind, n}, {}});
  }
  workers.for_each_block(result.size(), 1, [&](const IndexBlock& block) {
    result[block.begin].by_exponent_N = by_exponent(dataset, model, result[block.begin].contact);
  });
  return result;
}

// Kinds of contacts with the coefficient of their kind, at fingers (true) or elsewhere: others have
// values of their own, as blocks have that the hardware gives a law. What is known stays, too.
using Coefficients = std::set<std::pair<ContactKind, bool>>;

Coefficients coefficients(const Dataset& dataset, const Hardware& hardware) {
  const MechanicsBuilder builder(hardware);
  Coefficients result;
  for (const MeasuredRouting& routing : dataset.data->routings) {
    for (const TendonSpan& tendon : routing.network.tendons) {
      for (std::size_t k = 0; k < tendon.contacts; ++k) {
        const Contact& contact = routing.network.contacts[tendon.first_contact + k];
        if (builder.has_own_mu(routing.network, tendon, k)) continue;
        const bool is_block = contact.kind == ContactKind::block;
        if (is_block && hardware.block && !hardware.block->known) continue;
        result.insert({contact.kind, contact.finger != 0});
      }
    }
  }
  return result;
}

class LeversOf {
 public:
  LeversOf(const Dataset& dataset, const Model& model, const Forecast& at, Workers& workers)
      : dataset_(dataset),
        at_(at),
        slots_(slots(dataset, model, workers)),
        contacts_(contacts_of_rows(dataset, model)),
        coefficients_(coefficients(dataset, model.hardware)),
        block_of_(dataset.rows.size()),
        turns_(std::ranges::any_of(dataset.blocks, [&](const ReadingBlock& block) {
          return block.direction != dataset.blocks.front().direction;
        })) {
    for (const ReadingBlock& block : dataset.blocks) {
      for (const std::size_t r : block.rows) block_of_[r] = &block;
    }
  }

  std::vector<Lever> run() {
    add_contacts();
    add_channels();
    add_motor();
    add_in_groups();
    std::vector<Lever> result;
    for (Lever& lever : levers_) {
      if (!lever.by_value_N.isZero(0) && !has_alike(result, lever)) {
        result.push_back(std::move(lever));
      }
    }
    return result;
  }

 private:
  // Sites that have the same contacts wherever there are readings are one, named by the widest.
  static bool has_alike(const std::vector<Lever>& levers, const Lever& other) {
    return std::ranges::any_of(levers, [&](const Lever& lever) {
      return lever.target == other.target && lever.site.place == other.site.place &&
             lever.by_value_N == other.by_value_N;
    });
  }

  const MeasuredRouting& routing(std::size_t row) const {
    return dataset_.data->routings[block_of_[row]->routing];
  }

  bool is_in(const Site& site, std::size_t row, const causes::SolvedContact& contact) const {
    const ReadingBlock& block = *block_of_[row];
    const ContactLoad load{contact.kind,   contact.high,   contact.number,   block.direction,
                           contact.finger, block.recorded, routing(row).word};
    return causes::acts_on(site, load);
  }

  std::vector<ContactShare> shares(Target target, const Site& site) const {
    std::vector<ContactShare> result;
    for (std::size_t r = 0; r < dataset_.rows.size(); ++r) {
      const DatasetRow& row = dataset_.rows[r];
      for (const causes::SolvedContact& contact : contacts_[r]) {
        if (!is_in(site, r, contact)) continue;
        const ContactColumn& slot = *std::ranges::find_if(slots_, [&](const ContactColumn& each) {
          return each.contact.kind == contact.kind && each.contact.number == contact.number;
        });
        const double factor = factor_of(target, contact);
        for (auto i = static_cast<Index>(row.first); i < static_cast<Index>(row.last); ++i) {
          result.push_back({i, factor * slot.by_exponent_N[i], contact.high});
        }
      }
    }
    return result;
  }

  static double factor_of(Target target, const causes::SolvedContact& contact) {
    if (target == Target::force) {
      return contact.high > 0 ? std::exp(contact.phi) / contact.high : 0;
    }
    return causes::is_tube_or_sheath(contact.kind) ? contact.phi : 1;
  }

  static std::optional<RowCovariate> load_at(const std::vector<ContactShare>& shares) {
    constexpr double wide = 1.3;
    constexpr std::size_t most_distinct = 100;
    std::vector<double> loads;
    for (const ContactShare& share : shares) {
      if (share.load_N > 0) loads.push_back(share.load_N);
    }
    std::ranges::sort(loads);
    loads.erase(std::unique(loads.begin(), loads.end()), loads.end());
    if (loads.size() < 3 || loads.back() < wide * loads.front()) return std::nullopt;
    RowCovariate result;
    result.covariate.kind = causes::CovariateKind::load;
    result.covariate.middle = loads[loads.size() / 2];
    result.covariate.seen = {loads.front(), loads.back()};
    const std::size_t stride = (loads.size() - 1) / most_distinct + 1;
    for (std::size_t i = 0; i < loads.size(); i += stride) result.distinct.push_back(loads[i]);
    return result;
  }

  // Each direction besides both: of a law that follows something, neither says what the other does.
  void add_in_directions(Site site, Breadth breadth, void (LeversOf::*add)(const Site&, Breadth)) {
    (this->*add)(site, breadth);
    for (const Direction direction : {Direction::release, Direction::pull}) {
      if (!turns_) break;
      site.direction = direction;
      (this->*add)(site, Breadth::part);
    }
  }

  void add_at_contacts(const Site& site, Breadth breadth) {
    for (const Target target : {Target::exponent, Target::force}) {
      Lever lever{target, site, breadth, VectorXd::Zero(static_cast<Index>(dataset_.cells.size()))};
      lever.shares = shares(target, site);
      for (const ContactShare& share : lever.shares) {
        lever.by_value_N[share.cell] += share.by_value_N;
      }
      if (breadth != Breadth::one) lever.load = load_at(lever.shares);
      if (!lever.load) lever.shares.clear();
      lever.has_coefficient = std::ranges::any_of(coefficients_, [&](const auto& coefficient) {
        return causes::acts_on(site, coefficient.first);
      });
      levers_.push_back(std::move(lever));
    }
  }

  void add_contacts() {
    for (const ContactKind kind : site_kinds) {
      if (most_of_a_kind(dataset_, kind) == 0) continue;
      add_in_directions({.kind = kind}, Breadth::whole, &LeversOf::add_at_contacts);
      std::set<int> fingers;
      std::set<std::pair<std::string, std::size_t>> numbered, in_hand;
      bool held = false;
      for (std::size_t r = 0; r < dataset_.rows.size(); ++r) {
        for (const causes::SolvedContact& contact : contacts_[r]) {
          if (contact.kind != kind) continue;
          if (contact.finger != 0) fingers.insert(contact.finger);
          if (contact.finger == 0) in_hand.insert({routing(r).word, contact.number});
          held |= contact.finger != 0 && block_of_[r]->recorded.holds(contact.finger);
          numbered.insert({routing(r).word, contact.number});
        }
      }
      for (const int finger : fingers) {
        if (fingers.size() < 2) break;
        add_at_contacts({.kind = kind, .finger = finger}, Breadth::part);
      }
      // The coefficient says what fingers do beside a single other contact, unless it moves this
      // one alone.
      const bool are_fingers_apart =
          coefficients_.contains({kind, false}) && !coefficients_.contains({kind, true});
      for (const bool at_fingers : {true, false}) {
        const bool is_said = in_hand.size() < 2 && !(at_fingers && are_fingers_apart);
        if (fingers.empty() || is_said) break;
        add_at_contacts({.kind = kind, .at_fingers = at_fingers}, Breadth::part);
      }
      for (const bool is_held : {true, false}) {
        if (!held) break;
        add_at_contacts({.kind = kind, .held = is_held}, Breadth::part);
      }
      std::map<std::string, int> of_routing;
      for (const auto& [word, number] : numbered) ++of_routing[word];
      for (const auto& [word, count] : of_routing) {
        if (of_routing.size() < 2 || count < 2) continue;
        add_at_contacts({.kind = kind, .routing = word}, Breadth::one);
      }
      for (const auto& [word, number] : numbered) {
        add_at_contacts({.kind = kind, .routing = word, .number = number}, Breadth::one);
      }
    }
    // Behind both kinds: where no reading tells of tubes, these are sheaths alone.
    if (most_of_a_kind(dataset_, ContactKind::tube) > 0 &&
        most_of_a_kind(dataset_, ContactKind::sheath) > 0) {
      add_in_directions({.with_sheaths = true}, Breadth::whole, &LeversOf::add_at_contacts);
    }
  }

  void add_cells(Target target, const Site& site, Breadth breadth,
                 const std::function<double(std::size_t row, Index cell)>& value) {
    Lever lever{target, site, breadth, VectorXd::Zero(static_cast<Index>(dataset_.cells.size()))};
    for (std::size_t r = 0; r < dataset_.rows.size(); ++r) {
      if (!causes::acts_in(site, block_of_[r]->direction)) continue;
      for (std::size_t i = dataset_.rows[r].first; i < dataset_.rows[r].last; ++i) {
        const bool reads =
            site.place != SitePlace::channel ||
            dataset_.data->channels[dataset_.cells[i].channel].segment == site.channel;
        if (reads) lever.by_value_N[static_cast<Index>(i)] = value(r, static_cast<Index>(i));
      }
    }
    levers_.push_back(std::move(lever));
  }

  void add_readings(const Site& site, Breadth breadth) {
    const auto gain = [&](std::size_t, Index cell) { return at_.reading_N[cell]; };
    add_cells(Target::gain, site, breadth, gain);
    add_cells(Target::offset, site, breadth, [](std::size_t, Index) { return 1.0; });
  }

  void add_channels() {
    if (dataset_.data->channels.size() > 1) {
      add_in_directions({.place = SitePlace::channels}, Breadth::whole, &LeversOf::add_readings);
    }
    for (const Channel& channel : dataset_.data->channels) {
      add_in_directions({.place = SitePlace::channel, .channel = channel.segment}, Breadth::whole,
                        &LeversOf::add_readings);
    }
  }

  double by_motor(std::size_t row, Index cell) const {
    return dataset_.rows[row].has_motor_tension ? at_.by_scale[cell] : 0;
  }

  void add_at_motor(const Site& site, Breadth breadth) {
    add_cells(Target::gain, site, breadth, [&](std::size_t r, Index cell) {
      return by_motor(r, cell) * dataset_.rows[r].conditions.motor_tension_N;
    });
    add_cells(Target::offset, site, breadth,
              [&](std::size_t r, Index cell) { return by_motor(r, cell); });
  }

  void add_motor() {
    const Site site{.place = SitePlace::motor};
    add_in_directions(site, Breadth::whole, &LeversOf::add_at_motor);
    if (!turns_) return;
    add_cells(Target::force, site, Breadth::whole, [&](std::size_t r, Index cell) {
      return (block_of_[r]->direction == Direction::pull ? -1 : 1) * by_motor(r, cell);
    });
  }

  // Levers of the whole rig also act in one group of readings by itself: nothing says what others
  // do.
  void add_in_groups() {
    const std::vector<std::string>& groups = dataset_.data->groups;
    const std::size_t of_all = levers_.size();
    for (std::size_t g = 0; g < groups.size() && groups.size() > 1; ++g) {
      std::vector<bool> is_in(dataset_.cells.size());
      for (std::size_t i = 0; i < is_in.size(); ++i) {
        is_in[i] = dataset_.data->readings[dataset_.cells[i].reading].group == g;
      }
      for (std::size_t l = 0; l < of_all; ++l) {
        if (levers_[l].breadth != Breadth::whole) continue;
        levers_.push_back(inside(levers_[l], is_in));
        levers_.back().site.group = groups[g];
      }
    }
  }

  static Lever inside(Lever lever, const std::vector<bool>& is_in) {
    lever.breadth = Breadth::part;
    for (std::size_t i = 0; i < is_in.size(); ++i) {
      if (!is_in[i]) lever.by_value_N[static_cast<Index>(i)] = 0;
    }
    std::erase_if(lever.shares, [&](const ContactShare& share) {
      return !is_in[static_cast<std::size_t>(share.cell)];
    });
    lever.load = load_at(lever.shares);
    return lever;
  }

  const Dataset& dataset_;
  const Forecast& at_;
  std::vector<ContactColumn> slots_;
  RowContacts contacts_;
  Coefficients coefficients_;
  std::vector<const ReadingBlock*> block_of_;
  bool turns_;
  std::vector<Lever> levers_;
};

}  // namespace

std::vector<Lever> levers(const Dataset& dataset, const Model& model, const Forecast& at,
                          Workers& workers) {
  return LeversOf(dataset, model, at, workers).run();
}

}  // namespace reeve::diagnosis
